#include "platform/gl/soft/picture.h"

#include "platform/gl/soft/pixel.h"

bool picture_takes(const struct draw *draw)
{
	const struct texture_input *input = &draw->texture[0];

	return draw->span == soft_draw_span_565 && !draw->tests &&
		!draw->blended && draw->color_written && input->used &&
		input->base->format == TEXEL_565 &&
		input->texture->min_filter == GL_NEAREST &&
		input->texture->mag_filter == GL_NEAREST &&
		(input->env->mode == GL_MODULATE ||
			input->env->mode == GL_REPLACE);
}

bool picture_begin(const struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	const uint32_t *color = raster->span.value;
	/* From here on 255 is 32/32. */
	const uint32_t white = 252 << 16;

	return !raster->perspective && raster->moving_count == 2 &&
		raster->plane[TEX_S + 1].dx == 0 &&
		(draw->texture[0].env->mode == GL_REPLACE ||
			(color[RED] >= white && color[GREEN] >= white &&
				color[BLUE] >= white));
}

static uint32_t last_of(int log2)
{
	return (1u << log2) - 1;
}

/* Texels outside of the texture are left to those who know where they are. */
void picture_row(struct draw *draw, int y, int left, int right)
{
	const struct texture_input *input = &draw->texture[0];
	const struct raster *raster = &draw->raster;
	uint32_t s = plane_at(raster, TEX_S, left);
	uint32_t end = plane_at(raster, TEX_S, right - 1);
	uint32_t t = raster->plane[TEX_S + 1].start >> 16;
	uint32_t last = last_of(input->width_log2);

	if (s >> 16 > last || end >> 16 > last ||
		t > last_of(input->height_log2)) {
		rows_affine(draw, y, left, right);
		return;
	}
	soft_bands.picture((uint16_t *)(void *)pixel_at(
				   &draw->soft->buffers.target, left, y),
		(const uint16_t *)(const void *)input->base->texels +
			(t << input->width_log2),
		right - left, s, (uint32_t)raster->plane[TEX_S].dx);
}

void picture_copy_c(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16)
{
	for (int i = 0; i < count; i++) {
		pixel[i] = texels[s_q16 >> 16];
		s_q16 += s_right_q16;
	}
}
