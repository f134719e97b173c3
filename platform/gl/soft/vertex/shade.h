/*
 * Rows of a luminance texture in shades that vary: what gray.h draws.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_SHADE_H
#define PLATFORM_GL_SOFT_VERTEX_SHADE_H

#include <stdint.h>

/* Pixels of a row; texels of one level. */
struct shade_run {
	uint16_t *pixel;
	uint16_t *depth; /* NULL: none is written */
	int count;
	const uint32_t *quads;
	int width_log2, height_log2; /* both more than 0 */
	/*
	 * Of the first centre's upper left texel: 2^32 are all of the texture,
	 * so that it repeats by itself.
	 */
	uint32_t s, t;
	int32_t s_right, t_right;
	uint32_t z;
	int32_t z_right;
	uint32_t alpha; /* 8.16 and the half of 1/32 */
	int32_t alpha_right;
	const uint32_t *shade; /* 256 wide colours */
	/* gray.c's: how much of 256 a texel counts, 8.16 */
	uint32_t share;
	int32_t share_right;
};

#endif
