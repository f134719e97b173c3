/*
 * Bands: the rows of a triangle above or below its middle vertex. A struct band
 * has an RGB565 texture and picture, and depths that are written. They are
 * tested LESS, or LEQUAL by functions with equal.
 *
 * Functions draw all rows of a band, and leave row and edges at the next row.
 */
#ifndef PLATFORM_GL_SOFT_FAST_BAND_H
#define PLATFORM_GL_SOFT_FAST_BAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

enum {
	BAND_LEFT,
	BAND_RIGHT,
};

/*
 * A band's edges in a row, 16.16 with 0x7FFF added, so that the upper half is
 * the first column inside of the left edge, or outside of the right one.
 */
struct band_edges {
	uint32_t at[2], step[2];
	int32_t rows; /* that are left */
};

static inline int band_column(const struct band_edges *edges, int side)
{
	return (int32_t)edges->at[side] >> 16;
}

/* Steps to the next row. Below an edge's end, at may wrap: no row reads it. */
static inline void band_next_row(struct band_edges *edges)
{
	edges->at[BAND_LEFT] += edges->step[BAND_LEFT];
	edges->at[BAND_RIGHT] += edges->step[BAND_RIGHT];
	edges->rows--;
}

/*
 * Values at column 0 of a row, right modulo 2^32; or their steps a row. Colours
 * are 1.15 and stay below 1, so that each is a factor of a signed
 * multiplication of 16 bits.
 */
struct band_row {
	uintptr_t depth; /* address */
	uint32_t z_q16;
	/*
	 * t in the upper half, s in the lower one, in 1/256 of the level's
	 * texels; for bilinear filters half a texel less
	 */
	uint32_t texel;
	uint32_t red_blue; /* red in the upper half; gray: its factor, 6.26 */
	uint32_t green;    /* in the lower half; gray: unused */
};

enum {
	/* longest gray row: 32, and one more by rounding */
	BAND_GRAY_PIXELS = 33,
	/* one texel in s and t of band_row.texel */
	TINT_NEXT = 0x01000100,
	/*
	 * Masks of a channel of two neighbouring texels, at bits 5 to 9, or 10,
	 * of both halves: green unshifted, red >> 6, blue << 5.
	 */
	TINT_RED_BLUE = 0x03E003E0,
	TINT_GREEN = 0x07E007E0,
};

/* Added to tinted channels, Q17: a half, and a colour added to all fragments. */
struct band_more {
	uint32_t green; /* gray: WIDE_ROUND */
	uint32_t red, blue;
};

/*
 * A band with a texture: a level of up to 256 x 256 texels that repeats, or part
 * of one, whose coordinates stay in the mask. arm/layout.c asserts the layout.
 */
struct band {
	_Alignas(8) struct band_row row; /* the next row to draw */
	struct band_row down;            /* steps a row */
	struct band_edges edges;
	_Alignas(8) uint32_t z_right; /* steps a pixel */
	uint32_t texel_right;
	uint32_t red_blue_right;
	uint32_t green_right; /* minus 0x10000, which counts pixels */
	uint32_t texel_mask;  /* of whole texels in band_row.texel */
	uint32_t texel_shift; /* 24 - log2 of the level's width */
	const uint8_t *texels;
	uint32_t stride_bytes; /* of the level; gray: WIDE_MASK */
	uintptr_t pixels;      /* from a depth's address + 2 to its pixel's */
	struct band_more more;
};

/*
 * What fill_flat.c does to pixels, opaque or blended, where the stencil is
 * reference, which becomes next.
 */
struct flat_color {
	uint8_t reference, next;
	/* (pixel * keep + own) >> 5, wide; own holds the rounding */
	uint32_t keep, own;
};

/*
 * arm/texture.S and arm/tint.S, or portable/triangles.c: draw a band of at
 * least one row. gray: nearest texels times a gray, rows of up to
 * BAND_GRAY_PIXELS; tint: bilinear ones times a colour. Rows lie inside of the
 * picture, which has the same stride as the depth buffer. band is a struct
 * band: this is what frame_draw_bands() calls.
 */
void soft_band_gray(void *band);
void soft_band_gray_equal(void *band);
void soft_band_tint(void *band);
void soft_band_tint_equal(void *band);
/* band.c: the same in C, with the same results. */
void soft_band_gray_c(struct band *band, bool equal);
void soft_band_tint_c(struct band *band, bool equal);
/* Loads the texels at and right of at, and the pair below, across level edges. */
void soft_tint_across(const struct band *band, uint32_t at, uint32_t pair[2]);

#endif
