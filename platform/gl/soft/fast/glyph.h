/*
 * Upright rectangles in one colour, blended into RGB565: what fill_glyph.c
 * draws letters and panels with. glyph.c has the functions in C, arm/glyph.S
 * again, with the same bytes.
 */
#ifndef PLATFORM_GL_SOFT_FAST_GLYPH_H
#define PLATFORM_GL_SOFT_FAST_GLYPH_H

#include <stddef.h>
#include <stdint.h>

/* A letter: a texel is a pixel. Offsets are known to arm/glyph.S. */
struct glyph {
	uint16_t *pixel;        /* 0 */
	const uint8_t *texel;   /* 4: alpha */
	int columns, rows;      /* 8: at least 1 */
	ptrdiff_t stride_bytes; /* 16: of the picture */
	ptrdiff_t texel_stride; /* 20 */
	uint32_t own;           /* 24: the colour, wide */
	uint32_t alpha;         /* 28: 0 to 32, which texels count */
};

void soft_glyph_draw_c(const struct glyph *glyph);

/* Pixels become (pixel keep + own) >> 5, wide; own holds the rounding. */
void soft_glyph_mix_c(uint16_t *pixel, int count, uint32_t keep, uint32_t own);

#endif
