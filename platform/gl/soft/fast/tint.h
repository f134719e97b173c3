/*
 * Bands (see band.h) with an RGB565 texture under a colour of three channels,
 * of four texels mixed. tint.c draws them.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TINT_H
#define PLATFORM_GL_SOFT_FAST_TINT_H

#include "platform/gl/soft/fast/band.h"

/*
 * As struct band_row. Colours are 1.15 and stay below 1, so that each is a
 * factor of a signed multiplication of 16 bits.
 */
struct tint_row {
	uintptr_t depth;
	uint32_t z_q16;
	/*
	 * t in the upper half, s in the lower one, in 1/256 of the level's
	 * texels, half a texel less.
	 */
	uint32_t texel;
	uint32_t red_blue; /* red in the upper half */
	uint32_t green;    /* in the lower half */
};

enum {
	/* The next texel in both directions of struct tint_row. */
	TINT_NEXT = 0x01000100,
	/*
	 * A channel of two texels side by side, at bits 5 to 9, or 10, of both
	 * halves: green as it is, red down by six, blue up by five.
	 */
	TINT_RED_BLUE = 0x03E003E0,
	TINT_GREEN = 0x07E007E0,
};

/* Levels of up to 256 texels that repeat. */
struct tint_band {
	_Alignas(8) struct tint_row row; /* of the next row */
	struct tint_row down;            /* a row further */
	uint32_t edge[2];                /* see struct texture_band */
	uint32_t edge_step[2];
	int32_t rows;
	uint32_t z_right; /* a pixel further */
	uint32_t texel_right;
	uint32_t red_blue_right;
	uint32_t green_right; /* less 0x10000, to count */
	uint32_t texel_mask;  /* whole texels of the level */
	uint32_t texel_shift; /* 24 less the width's log2 */
	const uint8_t *texels;
	uint32_t stride_bytes; /* of the level */
	uintptr_t pixels;      /* see struct texture_band */
};

/* As soft_band_texture(), with at least one row. */
void soft_band_tint_c(struct tint_band *band);
/* arm/tint.S or portable/tint.c: the same. */
void soft_band_tint(struct tint_band *band);
/* The pairs above and below where one lies across the edge of the level. */
void soft_tint_across(
	const struct tint_band *band, uint32_t at, uint32_t pair[2]);

#endif
