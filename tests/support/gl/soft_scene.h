/*
 * A small picture of the soft driver, to hold its short cuts against the long
 * way.
 */
#ifndef TESTS_SUPPORT_GL_SOFT_SCENE_H
#define TESTS_SUPPORT_GL_SOFT_SCENE_H

#include "platform/gl/soft/vertex/draw.h"

enum {
	SOFT_SCENE_WIDTH = 96,
	SOFT_SCENE_HEIGHT = 80,
	SOFT_SCENE_PIXELS = SOFT_SCENE_WIDTH * SOFT_SCENE_HEIGHT,
	SOFT_SCENE_GUARD = SOFT_SCENE_WIDTH * 8, /* pixels above, and below */
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

/* With a frame begun. */
struct soft_scene *soft_scene_open(void);

/*
 * Calls of GL go to the context whose frame began last: this one's then. The
 * long way is that of soft/reference.h, for all fragments.
 */
void soft_scene_use(struct soft_scene *scene, bool long_way);

/* Fails the test if something was drawn above or below the picture. */
void soft_scene_close(struct soft_scene *scene);

/* A vertex of triangles that chance makes. */
struct soft_corner {
	float position[3];
	uint8_t color[4];
	float texcoord[2];
};

/*
 * Triangles in any opaque colours, that begin within reach of the middle and
 * whose other corners lie within size of that, both in thousandths. Depths are
 * around 0 by the same, divided by flatten. Leaves texture coordinates alone.
 */
void soft_scene_scatter(struct soft_corner *corner, int triangles,
	uint32_t *seed, int reach, int size, float flatten);

/* How far apart two pixels are, in 32nds. */
int soft_scene_steps(uint16_t a, uint16_t b);

#endif
