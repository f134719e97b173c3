/*
 * Rows of large triangles with a luminance texture that repeats, in one colour
 * or in shades of gray that vary, opaque or blended by alpha, into RGB565.
 * Depth is not tested.
 *
 * The four texels around a centre lie in one word (tiles.h); neighbouring
 * pixels in a patch of equal texels are filled at once. A table maps luminance
 * to colours.
 *
 * tile_row.c draws rows in one colour, and so does arm/tile_row.S, with the
 * same results; luminance.c does the rest.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TILE_ROW_H
#define PLATFORM_GL_SOFT_FAST_TILE_ROW_H

#include "platform/gl/soft/vertex/number.h"

#include <stdint.h>

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
struct draw;
void soft_luminance_init(struct draw *draw);

#endif
