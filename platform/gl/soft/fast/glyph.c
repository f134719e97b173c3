#include "platform/gl/soft/fast/glyph.h"

#include "platform/gl/soft/raster/pixel.h"

static void draw_row(
	const struct glyph *glyph, uint16_t *pixel, const uint8_t *texel)
{
	for (int i = 0; i < glyph->columns; i++) {
		uint32_t alpha = ((texel[i] + 4u) >> 3) * glyph->alpha >> 5;

		if (alpha) {
			pixel[i] = narrow(
				mix_wide(widen(pixel[i]), glyph->own, alpha));
		}
	}
}

void soft_glyph_draw(const struct glyph *glyph)
{
	uint8_t *pixel = (uint8_t *)glyph->pixel;
	const uint8_t *texel = glyph->texel;

	for (int i = 0; i < glyph->rows; i++) {
		draw_row(glyph, (uint16_t *)(void *)pixel, texel);
		pixel += glyph->stride_bytes;
		texel += glyph->texel_stride;
	}
}
