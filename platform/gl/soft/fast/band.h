/*
 * Bands: rows of a triangle between two of its edges. Those with an RGB565
 * texture have a depth that is tested LESS and written; the picture is RGB565.
 *
 * Functions draw all rows, and leave row and edge at the row after them.
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
 * A band's edges: 16.16, and 0x7FFF more than where they are, so that the upper
 * half is the first column inside of it, or outside; and how many rows follow.
 */
struct band_edges {
	uint32_t at[2], step[2];
	int32_t rows;
};

static inline int band_column(const struct band_edges *edges, int side)
{
	return (int32_t)edges->at[side] >> 16;
}

/* To the next row. Below an edge's end it may wrap; no row reads it there. */
static inline void band_next_row(struct band_edges *edges)
{
	edges->at[BAND_LEFT] += edges->step[BAND_LEFT];
	edges->at[BAND_RIGHT] += edges->step[BAND_RIGHT];
	edges->rows--;
}

/*
 * What moves on with every row; all but the depth's address is at column 0, and
 * right modulo 2^32. Colours are 1.15 and stay below 1, so that each is a
 * factor of a signed multiplication of 16 bits.
 */
struct band_row {
	uintptr_t depth;
	uint32_t z_q16;
	/*
	 * t in the upper half, s in the lower one, in 1/256 of the level's
	 * texels; where four are mixed, half a texel less
	 */
	uint32_t texel;
	uint32_t red_blue; /* red in the upper half; of gray a share of 6.26 */
	uint32_t green;    /* in the lower half; of gray unused */
};

enum {
	/* The most of a gray row: rounding may add one to 32. */
	BAND_GRAY_PIXELS = 33,
	/* The next texel in both directions of struct band_row. */
	TINT_NEXT = 0x01000100,
	/*
	 * A channel of two texels side by side, at bits 5 to 9, or 10, of both
	 * halves: green as it is, red down by six, blue up by five.
	 */
	TINT_RED_BLUE = 0x03E003E0,
	TINT_GREEN = 0x07E007E0,
};

/* Of tinted channels: a half, and what is added to all fragments. */
struct band_more {
	uint32_t green; /* of gray: WIDE_ROUND */
	uint32_t red, blue;
};

/*
 * Levels of up to 256 texels that repeat, or parts of other levels in which no
 * coordinate leaves the mask. arm/layout.c says what is fixed.
 */
struct band {
	_Alignas(8) struct band_row row; /* of the next row */
	struct band_row down;            /* a row further */
	struct band_edges edges;
	_Alignas(8) uint32_t z_right; /* a pixel further */
	uint32_t texel_right;
	uint32_t red_blue_right;
	uint32_t green_right; /* less 0x10000, to count */
	uint32_t texel_mask;  /* whole texels of the level, or part */
	uint32_t texel_shift; /* 24 less the width's log2 */
	const uint8_t *texels;
	uint32_t stride_bytes; /* of the level; of gray: WIDE_MASK */
	uintptr_t pixels;      /* from behind a depth to its pixel */
	struct band_more more;
};

/* A level as struct band has it. */
struct textured_level {
	uint32_t texel_mask, texel_shift;
	const uint8_t *texels;
	uint32_t stride_bytes;
	/* from 16.16 of the base's texels to 8 bits of its own */
	int32_t s_down, t_down;
	bool whole; /* it repeats and is no larger than 256 */
};

/*
 * What small textured triangles of a draw call share, so that setting one up
 * looks nothing else up. fill_texture.c makes it.
 */
struct textured {
	int32_t last_level;    /* of those to choose from */
	struct band_more more; /* of tints */
	struct textured_level level[SOFT_LEVELS];
};

/*
 * What fill_flat.c draws without a depth test, opaque or blended, where the
 * stencil has a reference value, which becomes another.
 */
struct flat_color {
	uint8_t reference, next; /* what the stencil has, and gets */
	/* (picture keep + own) >> 5, wide; own holds the rounding */
	uint32_t keep, own;
};

/*
 * Nearest texels under a shade of gray, in rows of up to BAND_GRAY_PIXELS, and
 * four mixed ones under a colour, of at least one row: arm/texture.S and
 * arm/tint.S, or portable/triangles.c. Rows lie inside of the picture, whose
 * rows are as far apart as the depth's.
 */
void soft_band_gray(struct band *band);
void soft_band_tint(struct band *band);
/* band.c: the same bytes. */
void soft_band_gray_c(struct band *band);
void soft_band_tint_c(struct band *band);
/* The pairs above and below where one lies across the edge of the level. */
void soft_tint_across(const struct band *band, uint32_t at, uint32_t pair[2]);

#endif
