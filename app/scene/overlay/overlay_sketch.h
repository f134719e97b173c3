/*
 * Coloured lines and triangles that are made anew in each frame, for overlays.
 *
 * The sketch holds a fixed number of vertices and draws them whenever it is
 * full, so it never allocates. Coordinates are those of the model-view matrix
 * that is loaded.
 */
#ifndef APP_SCENE_OVERLAY_OVERLAY_SKETCH_H
#define APP_SCENE_OVERLAY_OVERLAY_SKETCH_H

#include "platform/gl/gl.h"

#include <stdint.h>

enum {
	/* a multiple of 2 and 3, so that no line or triangle is split */
	OVERLAY_SKETCH_VERTICES = 1536
};

struct overlay_vertex {
	float position[3];
	uint8_t color[4]; /* sRGB, alpha */
};

struct overlay_sketch {
	const struct gl *gl;
	GLenum mode; /* GL_LINES or GL_TRIANGLES */
	int count;
	struct overlay_vertex vertex[OVERLAY_SKETCH_VERTICES];
};

/*
 * Sets unlit, untextured, blended drawing of both sides with vertex colours and
 * begins to collect vertices for the mode. The depth test stays as it is.
 */
void overlay_sketch_begin(
	struct overlay_sketch *sketch, const struct gl *gl, GLenum mode);

/* Draws what has been collected and turns blending off. */
void overlay_sketch_end(struct overlay_sketch *sketch);

/* Adds a line, in a sketch of GL_LINES. */
void overlay_sketch_line(struct overlay_sketch *sketch, const float a[3],
	const float b[3], const uint8_t color[4]);

/*
 * Adds two pyramids with a common square base, whose tips are a and b, in a
 * sketch of GL_TRIANGLES: the usual picture of a bone. The base lies at the
 * fraction bulge of the way from a to b; radius is half its diagonal. Faces are
 * shaded by their direction. Nothing is added if a equals b.
 */
void overlay_sketch_spindle(struct overlay_sketch *sketch, const float a[3],
	const float b[3], float bulge, float radius, const uint8_t color[4]);

/* Adds an octahedron in the same way. */
void overlay_sketch_octahedron(struct overlay_sketch *sketch,
	const float center[3], float radius, const uint8_t color[4]);

#endif
