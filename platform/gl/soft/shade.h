/*
 * Rows of a luminance texture in one colour; luminance.h tells how. shade.c has
 * the functions in C, arm/shade.S some of them again.
 */
#ifndef PLATFORM_GL_SOFT_SHADE_H
#define PLATFORM_GL_SOFT_SHADE_H

#include <stdint.h>

/* Pixels of a row; texels of one level. Offsets are known to arm/shade.S. */
struct shade_run {
	uint16_t *pixel; /* 0 */
	uint16_t *depth; /* NULL: none is written */
	int count;       /* 8 */
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
	/* ground.c's: how much of 256 a texel counts, 8.16 */
	uint32_t share; /* 60 */
	int32_t share_right;
};

/*
 * Draws blocks of four or of two pixels, opaque, from a word's address on (if
 * mapped memory asks for that): no more than two texels wide.
 * Where the texels around the first pixel and around the one behind the last
 * are all the same, the others see no more than these, but for a corner.
 */
void shade_four_c(const struct shade_run *run);
void shade_two_c(const struct shade_run *run);
/* The same, blended by alpha with the picture. */
void shade_four_blended_c(const struct shade_run *run);
void shade_two_blended_c(const struct shade_run *run);

#endif
