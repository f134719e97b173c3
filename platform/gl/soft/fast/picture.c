#include "platform/gl/soft/fast/picture.h"
#include "platform/gl/soft/raster/mix.h"

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"

/* Whether the triangle is white, and upright. */
static bool is_upright(const struct draw *draw)
{
	const struct raster *raster = &draw->raster;
	const uint32_t *color = raster->span.value;
	/* From here on 255 is 32/32. */
	const uint32_t white = 252 << 16;

	return !raster->perspective && raster->moving_count == 2 &&
		raster->plane[TEX_S].dy == 0 &&
		raster->plane[TEX_S + 1].dx == 0 &&
		(draw->texture[0].env->mode == GL_REPLACE ||
			(color[RED] >= white && color[GREEN] >= white &&
				color[BLUE] >= white));
}

static uint32_t last_of(int log2)
{
	return (1u << log2) - 1;
}

/* In runs as those of the span functions, so that the texels are the same. */
static void copy_runs(const struct draw *draw, int y, int left, int right,
	const uint16_t *texels)
{
	const struct raster *raster = &draw->raster;
	const int shift = 16 - SOFT_TEXEL_FRACTION;
	int32_t step =
		soft_texel_step(raster->plane[TEX_S].dx, shift) * (1 << shift);
	const int most = rows_find_run_pixels(draw, raster->plane[TEX_S].dx, 0);
	uint8_t *at = pixel_at(&draw->soft->buffers.target, left, y);

	for (int x = left; x < right; x += most) {
		int count = right - x < most ? right - x : most;
		int32_t s = soft_texel_start((int32_t)plane_at(raster, TEX_S, x),
			soft_texel_rest(raster->plane[TEX_S].dx, shift), count,
			shift);

		soft_picture_copy((uint16_t *)(void *)at, texels, count,
			(uint32_t)s << shift, (uint32_t)step);
		at += 2 * most;
	}
}

/* Copies a row of a triangle; false where texels lie outside of the texture. */
static bool draw_row(const struct draw *draw, int y, int left, int right)
{
	const struct texture_input *input = &draw->texture[0];
	const struct raster *raster = &draw->raster;
	const struct plane *down = &raster->plane[TEX_S + 1];
	uint32_t s = plane_at(raster, TEX_S, left);
	uint32_t end = plane_at(raster, TEX_S, right - 1);
	uint32_t t = (down->start +
			     (uint32_t)down->dy * (uint32_t)(y - raster->top)) >>
		16;
	uint32_t last = last_of(input->width_log2);

	/* A run's first texel is off by less than a 16th of one. */
	if ((s - 4096) >> 16 > last || (end + 4096) >> 16 > last ||
		t > last_of(input->height_log2)) {
		return false;
	}
	copy_runs(draw, y, left, right,
		(const uint16_t *)(const void *)input->base->texels +
			(t << input->width_log2));
	return true;
}

/* The row by a span function, which knows what lies outside of a texture. */
static void walk_row(struct draw *draw, const struct setup *setup, int y)
{
	const struct clip_box box = draw->box;

	draw->box.top = y;
	draw->box.bottom = y + 1;
	soft_walk_rows(draw, setup);
	draw->box = box;
}

void soft_picture_copy(uint16_t *pixel, const uint16_t *texels, int count,
	uint32_t s_q16, uint32_t s_right_q16)
{
	const uint8_t *bytes = (const uint8_t *)texels;
	uint32_t even = 0x1FFFE;
	int i = 0;

	/* else it becomes two shifts */
	OPAQUE(even);
	for (; i < count - 1; i += 2) {
		uint32_t left = load_16(bytes + (s_q16 >> 15 & even)), right;

		s_q16 += s_right_q16;
		right = load_16(bytes + (s_q16 >> 15 & even));
		soft_store_two(pixel + i, left | right << 16);
		s_q16 += s_right_q16;
	}
	if (i < count) {
		pixel[i] = texels[s_q16 >> 16];
	}
}

void soft_fill_picture(struct draw *draw, struct setup *setup)
{
	const struct clip_box box = draw->box;

	rows_set_up(draw, setup);
	if (!is_upright(draw)) {
		soft_walk_rows(draw, setup);
		return;
	}
	for (int y = raster_first_row(draw, setup);
		y < setup->bottom && y < box.bottom; y++) {
		int lower = y >= setup->middle;
		int part = raster_column(raster_side(
			draw, setup->v[lower], setup->v[lower + 1], y)
						 .x);
		int whole = raster_column(
			raster_side(draw, setup->v[0], setup->v[2], y).x);
		int left = setup->middle_left ? part : whole;
		int right = setup->middle_left ? whole : part;

		left = left > box.left ? left : box.left;
		right = right < box.right ? right : box.right;
		if (left < right && !draw_row(draw, y, left, right)) {
			walk_row(draw, setup, y);
		}
	}
}
