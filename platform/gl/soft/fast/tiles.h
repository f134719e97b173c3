/*
 * Rows of large triangles with a luminance texture that repeats, in one colour
 * or in shades of gray that vary, opaque or blended by alpha, into RGB565.
 * Depth is not tested.
 *
 * tiles.c rearranges the texture: the four texels around a centre lie in one
 * word, a quad; neighbouring pixels in a patch, a rectangle in which all texels
 * are equal, are filled at once. A table maps luminance to colours. tile_row.c
 * and arm/tile_row.S draw rows in one colour; luminance.c does the rest.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TILES_H
#define PLATFORM_GL_SOFT_FAST_TILES_H

#include <stdint.h>

#include "platform/gl/soft/vertex/number.h"

struct draw;
struct level;

/*
 * A quad is the four texels that a bilinear filter reads, in 127ths: a texel, and
 * those right of it, below and below right, from the low byte up; the texture
 * repeats. With QUAD_PATCH set, all four texels are equal, as in all quads of the
 * patch: bits 0 to 6 are their luminance, bits 8 to 13 the patch's number.
 */
#define QUAD_PATCH 0x80000000u

enum {
	TILE_SIDE_MAX = 128,
	PATCHES_MOST = 63, /* the largest rectangles; numbered from 1 on */
	FINE_SIDE_MAX = 64,
	FINE_PATCH = 255, /* in fine: the quad belongs to a patch */
	/*
	 * Largest difference of two neighbouring pixels, of 255, in 16.16, that
	 * are drawn as one: each is off by less than a step of red or blue.
	 */
	BY_TWO_MOST = 20 << 16,
	/* the width of a place of fine, in 16.16 texels */
	FINE_PLACE = 1 << 14,
};

static inline uint32_t quad_luminance(uint32_t patch_quad)
{
	return patch_quad & 127;
}

/*
 * Filters a quad without QUAD_PATCH bilinearly: across and down are weights of
 * 256; the result is in halves of 127ths, rounded down. Both rows are mixed in
 * one word; the final sum cancels what the lower half borrows from the upper.
 */
static inline uint32_t quad_mix(uint32_t quad, uint32_t across, uint32_t down)
{
	uint32_t left = quad & 0xFF00FF, right = quad >> 8 & 0xFF00FF;
	uint32_t rows = left * 256 + (right - left) * across;

	return ((rows & 0xFFFF) * (256 - down) + (rows >> 16) * down) >> 15;
}

static inline uint32_t quad_patch(uint32_t patch_quad)
{
	return patch_quad >> 8 & 63;
}

/*
 * A rectangle of quads: [0] is the last coordinate before it and [1] the last
 * one inside of it, where 2^32 is the whole texture.
 */
struct patch {
	uint32_t s[2], t[2];
};

/*
 * A level's quads, [side][side], and its patches. The side is the level's
 * longer one: along the other one quads repeat, as the texture does. Levels up
 * to FINE_SIDE_MAX also have fine, [4 * side][4 * side]: filtered values at 4 x
 * 4 places of each quad, in halves of 127ths, or FINE_PATCH inside of a patch.
 */
struct tiles {
	int side_log2;
	struct patch patch[PATCHES_MOST + 1];
	uint8_t *fine; /* in the same allocation behind quad, or NULL */
	/* least and largest luminance, in halves of 127ths */
	uint8_t low, high;
	uint32_t by_two_most; /* largest step, 16.16, to draw two pixels as one */
	uint32_t quad[];
};

/*
 * Allocates level->tiles, which level owns, if it is luminance of 2 to 128
 * texels a side; else, or without memory, level->tiles stays NULL.
 */
void soft_tiles_make(struct level *level);

/* Makes level->tiles again, unless NULL, after texels have changed. */
void soft_tiles_update(struct level *level);

/* A run of pixels and the texture level; the assembly knows the offsets. */
struct tile_run {
	uint16_t *pixel;       /* 0 */
	int count;             /* 4: at least 1 */
	const uint32_t *quads; /* 8: see tiles.h */
	uint32_t s, t;         /* 12: first pixel's upper left texel, 16.16 */
	int32_t s_right, t_right; /* 20: change a step */
	/* 28: [luminance in halves of 127ths, 0 to 254]: RGB565, twice */
	const uint32_t *shade;
	const uint32_t *s_end; /* 32: patch[0].s[0 or 1], which s moves towards */
	const uint32_t *t_end;       /* 36: the same of t */
	uint32_t s_pixels, t_pixels; /* 40: see soft_tile_pixels() */
	int side_log2;               /* 48 */
	const uint8_t *fine;         /* 52: tiles.fine, or NULL */
};

/*
 * The reciprocal of a coordinate's step. The upper half of its product with the
 * distance to a patch's end is how many more pixels lie in the patch, or fewer.
 */
static ALWAYS_INLINE uint32_t soft_tile_pixels(int32_t step_q16, int log2)
{
	uint32_t size =
		step_q16 < 0 ? 0u - (uint32_t)step_q16 : (uint32_t)step_q16;
	int zeros;

	size <<= 16 - log2;
	if (size <= 1) {
		return UINT32_MAX;
	}
	zeros = LEADING_ZEROS_32(size);
	/* reciprocal() may be 32 too large */
	return (uint32_t)(reciprocal(size << zeros) - 32) >> (30 - zeros);
}

/*
 * Draws a run. by_fine 0: each pixel is filtered bilinearly, with 8 fraction bits.
 * 1: each pixel is that of the nearest place of fine. 2: so are two pixels at a
 * time, s and t being in the middle between them. Pixels in a patch are filled at
 * once, with the same result. With fine, steps are less than half the texture.
 */
void soft_tile_row_c(const struct tile_run *run, int by_fine);
/* arm/tile_row.S or portable/triangles.c: the same. */
void soft_tile_row(const struct tile_run *run, int by_fine);

/* luminance.c: fills draw's tables of luminance and grays, once for good. */
void soft_luminance_init(struct draw *draw);

#endif
