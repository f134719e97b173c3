/*
 * Upright rectangles in one colour, blended into RGB565: what fill_glyph.c
 * draws letters with.
 */
#ifndef PLATFORM_GL_SOFT_FAST_GLYPH_H
#define PLATFORM_GL_SOFT_FAST_GLYPH_H

#include <stddef.h>
#include <stdint.h>

/* A letter: a texel is a pixel. */
struct glyph {
	uint16_t *pixel;
	const uint8_t *texel;   /* alpha */
	int columns, rows;      /* at least 1 */
	ptrdiff_t stride_bytes; /* of the picture */
	ptrdiff_t texel_stride;
	uint32_t own;   /* the colour, wide */
	uint32_t alpha; /* 0 to 32, which texels count */
};

void soft_glyph_draw(const struct glyph *glyph);

#endif
