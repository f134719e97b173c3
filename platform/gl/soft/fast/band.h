/*
 * Bands: rows of a triangle between two of its edges, with a depth that is
 * tested LESS and written, into RGB565.
 *
 * fill_opaque.c sets them up. band.c walks them in C; platforms may bring
 * faster functions (arm/band.S) which leave the same bytes. Which are used is
 * soft_bands, from the folder that toolchain/sources.mk names.
 */
#ifndef PLATFORM_GL_SOFT_FAST_BAND_H
#define PLATFORM_GL_SOFT_FAST_BAND_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
	/*
	 * So many pixels the packed colour may run before it is taken afresh.
	 * Its steps are cut towards zero, so that it stays between what it was
	 * and what it should be, by at most half a step of RGB565 off.
	 */
	BAND_RUN = 16,
};

/*
 * What moves on with every row; all but the depth's address is at column 0,
 * and right modulo 2^32. Red and blue run together, 5.11 each, red above.
 */
struct band_row {
	uintptr_t depth;
	uint32_t z_q16, red_blue, green_q26;
};

/* Offsets are known to arm/band.S. */
struct band {
	_Alignas(8) struct band_row row; /* 0: of the next row */
	struct band_row down;            /* 16: a row further */
	uint32_t z_right;                /* 32: a pixel further */
	uint32_t packed_right;           /* 36: see band_pack() */
	uint32_t red_blue_right;         /* 40 */
	uint32_t green_right;            /* 44 */
	uint32_t edge[2];                /* 48: see BAND_LEFT */
	uint32_t edge_step[2];           /* 56 */
	uint32_t wide_mask;              /* 64: WIDE_MASK */
	uintptr_t pixels; /* 68: from behind a depth to its pixel */
	int32_t rows;     /* 72 */
	/* For the C functions alone: */
	uintptr_t pixels_step; /* what pixels grows by a row */
	int32_t from, to;      /* columns that may be drawn */
};

/*
 * The band's edges, left and right: 16.16, and 0x7FFF more than where they are,
 * so that the upper half is the first column inside of it, or outside.
 */
enum {
	BAND_LEFT,
	BAND_RIGHT,
};

/*
 * The packed colour: green in 31..21, red in 20..10, blue in 9..0: 6.5, 5.6
 * and 5.5 bits. It runs as one number.
 */
static inline uint32_t band_pack(uint32_t red_blue, uint32_t green_q26)
{
	return (green_q26 >> 21 << 21) | (red_blue >> 21 << 10) |
		(red_blue << 16 >> 22);
}

static inline uint16_t band_unpack(uint32_t packed)
{
	uint32_t wide = (packed >> 5 | packed << 27) & 0x07E0F81F;

	return (uint16_t)(wide | wide >> 16);
}

/* Draws all rows, and leaves row and edge at the row after them. */
typedef void (*band_function)(struct band *band);

/* As struct band_row, with an RGB565 texture and one share of its colour. */
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
	uintptr_t pixels;                   /* 56: as in struct band */
	uint32_t wide_round;                /* 60 */
	uint32_t edge[2];                   /* 64 */
	uint32_t edge_step[2];              /* 72 */
	uint32_t share_right;               /* 80 */
	int32_t rows;                       /* 84 */
};

/*
 * Rows in one colour without a depth test, opaque or blended, where a stencil
 * lets them: what shadows on the ground and panels are.
 */
/* Offsets are known to arm/flat.S. */
struct flat_band {
	uint8_t *pixels, *stencil; /* of column 0; stencil may be NULL */
	ptrdiff_t stride_bytes, stencil_stride;
	int rows;
	uint32_t edge[2], edge_step[2]; /* as in struct band */
	int from, to;                   /* columns that may be drawn */
	uint8_t reference, next;        /* what the stencil has, and gets */
	/* the other way: drawn where it has anything else, and keeps that */
	bool unlike;
	/* (picture keep + own) >> 5, wide; own holds the rounding */
	uint32_t keep, own;
	uint16_t opaque; /* the colour itself */
	uint32_t alpha;  /* 0 to 32 */
};

struct tile_run;
struct draw;
struct setup;

struct band_functions {
	/* draw.h: three vertices or more, of indices at an even address */
	void (*list)(struct draw *draw, const void *indices, uint32_t count);
	/* fill_narrow.c; a fill_function */
	void (*narrow)(struct draw *draw, struct setup *setup);
	/* fill_flat.c, of what a stencil lets through once; the same */
	void (*shadow)(struct draw *draw, struct setup *setup);
	band_function color;
	/* Inside of the picture, whose rows are as far apart as the depth's. */
	void (*texture)(struct texture_band *band);
	void (*flat)(struct flat_band *band);
	void (*fill)(uint16_t *at, int count, uint16_t value);
	/* tile_row.h; rows of textures as wide as high */
	void (*tile_row)(const struct tile_run *run);
	void (*tile_fine)(const struct tile_run *run);
};

extern const struct band_functions soft_bands;

/* In C. */
void soft_band_color_c(struct band *band);
void soft_band_texture_c(struct texture_band *band);
void soft_band_flat_c(struct flat_band *band);
void soft_band_fill_c(uint16_t *at, int count, uint16_t value);

#endif
