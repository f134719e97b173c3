/*
 * Triangles in one colour through the alpha of a texture's nearest texels,
 * upright, without tests: letters, and the panels and bars beside them, which
 * are a single texel wide.
 */
#include "platform/gl/soft/pixel.h"
#include "platform/gl/soft/raster.h"

bool fill_is_glyph(const struct draw *draw)
{
	const struct soft *soft = draw->soft;
	const struct fragment_state *state = &soft->fragment;
	const struct texture_input *input = &draw->texture[0];
	const GLboolean *mask = state->color_mask;

	return soft->format == PIXELS_RGB565 && input->used &&
		input->base->format == TEXEL_A8 &&
		input->env->mode == GL_MODULATE &&
		input->texture->min_filter == GL_NEAREST &&
		input->texture->mag_filter == GL_NEAREST &&
		!draw->texture[1].used && !draw->fogged && !draw->tests &&
		!state->alpha_test && !draw->shading.lit && !draw->perspective &&
		draw->blended && state->blend_source == GL_SRC_ALPHA &&
		state->blend_destination == GL_ONE_MINUS_SRC_ALPHA && mask[0] &&
		mask[1] && mask[2];
}

static bool is_same(const struct setup *setup, int first, int count)
{
	int32_t differ = 0;

	for (int i = first; i < first + count; i++) {
		int32_t value = setup->v[0]->attribute[i];

		differ |= (setup->v[1]->attribute[i] ^ value) |
			(setup->v[2]->attribute[i] ^ value);
	}
	return differ == 0;
}

/* 0 to 32, of a texel in place or the one where coordinates wrap to. */
static uint32_t load_alpha(const struct texture_input *input, int s, int t)
{
	const struct texture *texture = input->texture;
	int last_s = (1 << input->width_log2) - 1;
	int last_t = (1 << input->height_log2) - 1;

	s = texture->wrap_s == GL_REPEAT ? s & last_s : clamp_int(s, 0, last_s);
	t = texture->wrap_t == GL_REPEAT ? t & last_t : clamp_int(t, 0, last_t);
	return (input->base->texels[(t << input->width_log2) + s] + 4u) >> 3;
}

/* Attributes are 8.8 with a bit to spare at their ends. */
static uint32_t share_of(int32_t attribute)
{
	return ((uint32_t)attribute + (4 << 8)) >> 11;
}

static void row_glyph(struct draw *draw, int y, int left, int right)
{
	const struct texture_input *input = &draw->texture[0];
	const struct raster *raster = &draw->raster;
	const struct flat_band *color = &draw->flat;
	uint16_t *pixel =
		(uint16_t *)(void *)pixel_at(&draw->soft->buffers.target, 0, y);
	uint32_t s = plane_at(raster, TEX_S, left);
	int t = (int32_t)raster->plane[TEX_S + 1].start >> 16;
	uint32_t own = widen(color->opaque);

	for (int x = left; x < right; x++) {
		uint32_t alpha =
			load_alpha(input, (int32_t)s >> 16, t) * color->alpha >>
			5;

		if (alpha) {
			pixel[x] = narrow(mix_wide(widen(pixel[x]), own, alpha));
		}
		s += (uint32_t)raster->plane[TEX_S].dx;
	}
}

static void next_row(struct draw *draw)
{
	raster_skip_rows(draw, 1);
}

static int texel_of(int32_t at_q16, int log2)
{
	return (int)((int64_t)at_q16 << log2 >> 16);
}

void fill_glyph(struct draw *draw, struct setup *setup)
{
	const struct texture_input *input = &draw->texture[0];
	const int32_t *a = setup->v[0]->attribute;
	uint32_t alpha = share_of(a[ALPHA]);

	if (draw->soft->fragment.flat || !is_same(setup, RED, 4)) {
		rows_fill(draw, setup);
		return;
	}
	if (is_same(setup, TEX_S, 2)) {
		alpha = load_alpha(input, texel_of(a[TEX_S], input->width_log2),
				texel_of(a[TEX_S + 1], input->height_log2)) *
				alpha >>
			5;
	}
	fill_flat_color(draw,
		color_565((uint32_t)a[RED] << 8, (uint32_t)a[GREEN] << 8,
			(uint32_t)a[BLUE] << 8),
		alpha);
	if (is_same(setup, TEX_S, 2)) {
		fill_flat(draw, setup);
		return;
	}
	raster_set_up(draw, setup);
	if (draw->raster.plane[TEX_S + 1].dx != 0) {
		rows_fill(draw, setup);
		return;
	}
	raster_walk(draw, setup, row_glyph, next_row);
}
