/*
 * Pictures in which the soft driver and its reference draw the same triangles,
 * and how they are compared.
 */
#ifndef TESTS_SUPPORT_SOFT_SPAN_SCENE_H
#define TESTS_SUPPORT_SOFT_SPAN_SCENE_H

#include "platform/gl/soft/vertex/draw.h"

enum {
	SPAN_WIDTH = 112,
	SPAN_HEIGHT = 90,
	SPAN_PIXELS = SPAN_WIDTH * SPAN_HEIGHT,
};

struct span_corner {
	float position[3];
	uint8_t color[4];
	float texcoord[2][2]; /* of the texture units */
};

struct span_scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint8_t bytes[SPAN_PIXELS * 4];
	struct pixels picture;
};

/* Opens a context of this format; span_scene_close() frees it. */
struct span_scene *span_scene_open(enum pixel_format format);

void span_scene_close(struct span_scene *scene);

/* Opens a scene with a picture of noise, and begins a frame in it, drawn by the
 * reference or by the driver. */
struct span_scene *span_scene_begin(enum pixel_format format, bool reference);

/* Turns linear fog on, between distances that random scenes cross. */
void span_scene_fog(const struct gl *gl);

/* Draws count corners as triangles, with texture coordinates of both units. */
void span_scene_draw(
	const struct gl *gl, const struct span_corner *corner, int count);

/* The same, but both units get the first one's texture coordinates. */
void span_scene_draw_joined(
	const struct gl *gl, const struct span_corner *corner, int count);

/* Whether pixel i of a differs from pixel k of b by at most a step of five bits. */
bool span_scene_is_near(
	const struct span_scene *a, int i, const struct span_scene *b, int k);

/*
 * Fails the test, naming the seed, unless depth and stencil agree, and colours
 * within a step of RGB565. Returns how many pixels were drawn.
 */
int span_scene_compare(
	const struct span_scene *a, const struct span_scene *b, uint32_t seed);

#endif
