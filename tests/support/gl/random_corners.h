/* Random triangles that lie close together, with colours and coordinates. */
#ifndef TESTS_SUPPORT_GL_RANDOM_CORNERS_H
#define TESTS_SUPPORT_GL_RANDOM_CORNERS_H

#include "platform/gl/gl.h"

#include <stdint.h>

struct random_corner {
	int16_t position[4]; /* three are used, as of the normal */
	int16_t normal[4];
	uint8_t color[4]; /* opaque */
	float texcoord[2];
};

/* The next corners: of each twelve, eleven lie within reach of the first one. */
void random_corners_make(
	uint32_t *seed, int reach, struct random_corner *corner, int count);

/* The next indices: each three are of the same twelve of so many corners. */
void random_corners_list(
	uint32_t *seed, int corner_count, uint16_t *index, int count);

/* Sets the arrays of GL from the first corner on. */
void random_corners_set(const struct gl *gl, const struct random_corner *corner);

#endif
