/*
 * A small RGB565 picture, to compare the fast paths of the soft driver with the
 * long way: the reference, which draws a fragment at a time (soft/reference.h).
 */
#ifndef TESTS_SUPPORT_GL_SOFT_SCENE_H
#define TESTS_SUPPORT_GL_SOFT_SCENE_H

#include "platform/gl/soft/vertex/draw.h"

enum {
	SOFT_SCENE_WIDTH = 96,
	SOFT_SCENE_HEIGHT = 80,
	SOFT_SCENE_PIXELS = SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT,
	SOFT_SCENE_GUARD =
		SOFT_SCENE_WIDTH * 8, /* pixels of above[], below[] */
};

struct soft_scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint16_t above[SOFT_SCENE_GUARD];
	uint16_t pixel[SOFT_SCENE_PIXELS];
	uint16_t below[SOFT_SCENE_GUARD];
	struct pixels picture;
};

/* Opens a context and begins a frame. soft_scene_close() frees the scene. */
struct soft_scene *soft_scene_open(void);

/*
 * Begins a frame, so that calls of GL go to this scene's context. With long_way
 * the reference draws all triangles.
 */
void soft_scene_use(struct soft_scene *scene, bool long_way);

/* Closes the scene. Fails the test if anything drew above or below the picture. */
void soft_scene_close(struct soft_scene *scene);

/* A vertex of a random triangle. */
struct soft_corner {
	float position[3];
	uint8_t color[4];
	float texcoord[2];
};

/*
 * Makes random triangles of opaque colours. In clip space the first corner of
 * each lies within reach thousandths of the middle, and the others within size
 * thousandths of the first. Depths lie as far around 0, divided by flatten.
 * Leaves texture coordinates alone.
 */
void soft_scene_scatter(struct soft_corner *corner, int triangles,
	uint32_t *seed, int reach, int size, float flatten);

/* The largest difference of a channel of two RGB565 pixels, in 5-bit steps. */
int soft_scene_steps(uint16_t a, uint16_t b);

#endif
