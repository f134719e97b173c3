/*
 * Bands: rows of a triangle between two of its edges, with a depth that is
 * tested LESS and written, into RGB565.
 *
 * Functions draw all rows, and leave row and edge at the row after them.
 */
#ifndef PLATFORM_GL_SOFT_FAST_BAND_H
#define PLATFORM_GL_SOFT_FAST_BAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/*
 * The band's edges, left and right: 16.16, and 0x7FFF more than where they are,
 * so that the upper half is the first column inside of it, or outside.
 */
enum {
	BAND_LEFT,
	BAND_RIGHT,
};

/*
 * What moves on with every row; all but the depth's address is at column 0, and
 * right modulo 2^32.
 */
struct texture_row {
	uintptr_t depth;
	uint32_t z_q16;
	/* t in the upper half, s in the lower one, in 1/256 of texels */
	uint32_t texel;
	uint32_t share_q26; /* 0 to 32 */
};

/* Offsets are known to arm/texture.S. Up to 256 texels that repeat. */
struct texture_band {
	_Alignas(8) struct texture_row row; /* 0 */
	struct texture_row down;            /* 16 */
	uint32_t z_right;                   /* 32 */
	uint32_t texel_right;               /* 36 */
	const uint8_t *texels;              /* 40 */
	uint32_t texel_mask;                /* 44: whole texels of struct row */
	uint32_t texel_shift;               /* 48: 24 less the width's log2 */
	uint32_t wide_mask;                 /* 52 */
	uintptr_t pixels;                   /* 56: see BAND_LEFT */
	uint32_t wide_round;                /* 60 */
	uint32_t edge[2];                   /* 64 */
	uint32_t edge_step[2];              /* 72 */
	uint32_t share_right;               /* 80 */
	int32_t rows;                       /* 84 */
};

/*
 * Rows in one colour without a depth test, opaque or blended, where the stencil
 * has a reference value, which becomes another. fill_flat.c draws them.
 */
struct flat_band {
	uint8_t *pixels, *stencil; /* of column 0 */
	ptrdiff_t stride_bytes, stencil_stride;
	int rows;
	uint32_t edge[2], edge_step[2]; /* see BAND_LEFT */
	int from, to;                   /* columns that may be drawn */
	uint8_t reference, next;        /* what the stencil has, and gets */
	/* (picture keep + own) >> 5, wide; own holds the rounding */
	uint32_t keep, own;
};

/*
 * arm/texture.S or portable/texture.c: rows inside of the picture, whose rows
 * are as far apart as the depth's.
 */
void soft_band_texture(struct texture_band *band);
void soft_band_texture_c(struct texture_band *band);

#endif
