/*
 * Rows of large triangles with a luminance texture that repeats, in one colour
 * or in shades of gray that vary, opaque or blended by alpha, into RGB565.
 * Depth is not tested.
 *
 * The four texels around a centre lie in one word (tiles.h), and pixels in a
 * patch of equal texels are found at once. Tables have the colours that
 * luminance becomes.
 *
 * tile_row.c draws those in one colour, arm/tile_row.S again, with the same
 * bytes; luminance.c does the rest.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TILE_ROW_H
#define PLATFORM_GL_SOFT_FAST_TILE_ROW_H

#include "platform/gl/soft/vertex/number.h"

#include <stdint.h>

/* Pixels of a row; texels of one level. Offsets are known to the assembly. */
struct tile_run {
	uint16_t *pixel;          /* 0 */
	int count;                /* 4: at least 1 */
	const uint32_t *quads;    /* 8: see tiles.h */
	uint32_t s, t;            /* 12: first upper left texel, 16.16 */
	int32_t s_right, t_right; /* 20: of a step */
	/* 28: colours of 0 to 254 halves of 127ths, in both halves of a word */
	const uint32_t *shade;
	const uint32_t *s_end;       /* 32: patch 0's end that the run nears */
	const uint32_t *t_end;       /* 36 */
	uint32_t s_pixels, t_pixels; /* 40: see soft_tile_pixels() */
	int width_log2, height_log2; /* 48 */
	const uint8_t *fine;         /* 56: or NULL */
};

/*
 * 2^32 over a step of the coordinates, cut: times what is left to a patch's end
 * it gives, 2^32 of it, how many pixels further are still inside, or fewer.
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
	/* A reciprocal may be 32 too much. */
	return (uint32_t)(reciprocal(size << zeros) - 32) >> (30 - zeros);
}

/*
 * Draws a run, each pixel the bilinear mean around its place, of fractions of 8
 * bits; or from fine the mean of the place that is nearest to it, or, two
 * pixels at a time, to the middle between them, where s and t are: by_fine is
 * 0, 1 or 2. Whole runs of pixels in a patch are found at once, which does not
 * change what they become. Steps from fine are less than half of the texture.
 */
void soft_tile_row_c(const struct tile_run *run, int by_fine);
/* arm/tile_row.S or portable/triangles.c: the same of levels as wide as high. */
void soft_tile_row(const struct tile_run *run, int by_fine);

/* luminance.c, once: the tables of luminance and of grays. */
struct draw;
void soft_luminance_init(struct draw *draw);

#endif
