/*
 * Draws upright rectangles of two triangles in one colour, blended by the alpha
 * of nearest texels, without tests: text; and panels, all of whose corners have
 * the same texture coordinates.
 */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"

/* Converts an alpha attribute, 8.8, to 0 to 32. */
static uint32_t share_of(int32_t attribute)
{
	return ((uint32_t)attribute + (4 << 8)) >> 11;
}

/* The alpha, 0 to 32, of the texel at coordinates from 0 to 1. */
static uint32_t load_alpha(
	const struct texture_input *input, const int32_t *attribute)
{
	int32_t s = attribute[TEX_S] << input->width_log2 >> 16;
	int32_t t = attribute[TEX_S + 1] << input->height_log2 >> 16;

	return (input->base->texels[(t << input->width_log2) + s] + 4u) >> 3;
}

static bool are_upright(struct vertex *const v[4])
{
	return v[0]->x == v[1]->x && v[2]->x == v[3]->x && v[0]->y == v[2]->y &&
		v[1]->y == v[3]->y && v[0]->x < v[2]->x && v[0]->y < v[1]->y;
}

/* Whether all corners have one colour, and s changes only in x, t only in y. */
static bool are_equal(struct vertex *const v[4])
{
	const int32_t *a = v[0]->attribute, *b = v[1]->attribute;
	const int32_t *c = v[2]->attribute, *d = v[3]->attribute;
	int32_t differ = (a[TEX_S] ^ b[TEX_S]) | (c[TEX_S] ^ d[TEX_S]) |
		(a[TEX_S + 1] ^ c[TEX_S + 1]) | (b[TEX_S + 1] ^ d[TEX_S + 1]);

	for (int i = RED; i <= ALPHA; i++) {
		differ |= (a[i] ^ b[i]) | (a[i] ^ c[i]) | (a[i] ^ d[i]);
	}
	return differ == 0;
}

/*
 * The texel of pixel first along a side from begin to end, in 1/16 pixels; -1
 * unless texels are as wide as pixels and count of them lie in the texture.
 */
static int find_texel(int first, int count, int32_t begin, int32_t end,
	int32_t from_q16, int32_t to_q16, int log2)
{
	int64_t from = (int64_t)from_q16 * (1 << log2);
	int64_t to = (int64_t)to_q16 * (1 << log2);
	int64_t over = to - from - (int64_t)(end - begin) * 4096;
	int64_t texel;

	if (over > 0x4000 || over < -0x4000) {
		return -1;
	}
	texel = (from + (int64_t)(first * 16 + 8 - begin) * 4096) >> 16;
	return texel < 0 || texel + count > 1 << log2 ? -1 : (int)texel;
}

/*
 * Blends a box with a colour by share, 0 to 32. Behind panels, rows often have one
 * colour, as those of a gradient: then one pixel is blended, and fills the row.
 */
static void mix_box(const struct draw *draw, const struct clip_box *box,
	uint16_t color, uint32_t share)
{
	int count = box->right - box->left;

	for (int y = box->top; y < box->bottom && share; y++) {
		uint16_t *pixel = (uint16_t *)(void *)pixel_at(
			&draw->soft->buffers.target, box->left, y);

		if (soft_is_one_color(pixel, count)) {
			soft_mix_color(pixel, color, 1, share);
			soft_fill_pixels(pixel, count, *pixel);
		} else {
			soft_mix_color(pixel, color, count, share);
		}
	}
}

/* Blends a row by its texels' alpha times share / 32. */
static void mix_row(uint16_t *pixel, const uint8_t *texel, int count,
	uint32_t wide_color, uint32_t share)
{
	for (int i = 0; i < count; i++) {
		uint32_t alpha = (texel[i] + 4u) >> 3;

		if (alpha) {
			pixel[i] = narrow(mix_wide(widen(pixel[i]), wide_color,
				alpha * share >> 5));
		}
	}
}

/* Draws a letter; false unless each texel is one pixel. */
static bool draw_letter(const struct draw *draw, struct vertex *const v[4],
	const struct clip_box *box, uint16_t color)
{
	const struct texture_input *input = &draw->texture[0];
	const int32_t *from = v[0]->attribute, *to = v[3]->attribute;
	int columns = box->right - box->left, rows = box->bottom - box->top;
	int s = find_texel(box->left, columns, v[0]->x, v[3]->x, from[TEX_S],
		to[TEX_S], input->width_log2);
	int t = find_texel(box->top, rows, v[0]->y, v[3]->y, from[TEX_S + 1],
		to[TEX_S + 1], input->height_log2);

	if (s < 0 || t < 0) {
		return false;
	}
	for (int row = 0; row < rows; row++) {
		mix_row((uint16_t *)(void *)pixel_at(&draw->soft->buffers.target,
				box->left, box->top + row),
			input->base->texels + ((t + row) << input->width_log2) +
				s,
			columns, widen(color), share_of(from[ALPHA]));
	}
	return true;
}

bool soft_fill_rectangle(struct draw *draw, struct vertex *const v[4])
{
	const int32_t *a = v[0]->attribute, *d = v[3]->attribute;
	struct clip_box box;
	uint16_t color;

	if (v[0]->outcode | v[1]->outcode | v[2]->outcode | v[3]->outcode ||
		!are_upright(v) || draw->cull_front || draw->cull_back ||
		draw->soft->fragment.flat) {
		return false;
	}
	for (int i = 0; i < 4; i++) {
		soft_shade(draw, v[i]);
	}
	if (!are_equal(v)) {
		return false;
	}
	box = raster_clip(draw,
		(struct clip_box){raster_centre(v[0]->x), raster_centre(v[0]->y),
			raster_centre(v[3]->x), raster_centre(v[3]->y)});
	if (box.left >= box.right || box.top >= box.bottom) {
		return true;
	}
	color = color_565((uint32_t)a[RED] << 8, (uint32_t)a[GREEN] << 8,
		(uint32_t)a[BLUE] << 8);
	if (a[TEX_S] != d[TEX_S] || a[TEX_S + 1] != d[TEX_S + 1]) {
		return draw_letter(draw, v, &box, color);
	}
	if ((a[TEX_S] | a[TEX_S + 1]) >> 16 != 0) {
		return false;
	}
	mix_box(draw, &box, color,
		load_alpha(&draw->texture[0], a) * share_of(a[ALPHA]) >> 5);
	return true;
}
