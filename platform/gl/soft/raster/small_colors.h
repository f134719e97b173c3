/*
 * Colours, alpha and fog of a small triangle, as its runs have them. Included
 * by list_small.c alone.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_SMALL_COLORS_H
#define PLATFORM_GL_SOFT_RASTER_SMALL_COLORS_H

#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/small_list.h"
#include "platform/gl/soft/span/sample.h"

enum {
	/* Columns and rows: edges are exact enough for any steepness. */
	EXACT_SIZE = 16,
	WHITE = 0xFF80,
};

/* Steps of 255 a pixel, 8.16, for which edges are exact enough. */
#define STEEP       (1 << 21)
#define STEEP_EXACT (1 << 24)

/* A triangle on its way into a list. */
struct small {
	struct frame frame;
	const int32_t *color[3]; /* attributes of corners */
	int32_t steep;           /* a colour's step may be */
	bool is_steep;
};

static ALWAYS_INLINE struct delta find_delta(
	const int32_t *const corner[3], int name)
{
	int32_t first = corner[0][name];

	return (struct delta){
		first, corner[1][name] - first, corner[2][name] - first};
}

static ALWAYS_INLINE bool moves(const struct delta *delta)
{
	return (delta->d1 | delta->d2) != 0;
}

static ALWAYS_INLINE struct run find_run(
	const struct small *small, const struct delta *delta)
{
	return frame_find_run(&small->frame, delta->first, delta->d1, delta->d2);
}

/* From the vertex's column to column 0. */
static ALWAYS_INLINE struct small_value enter(
	const struct small *small, struct run run)
{
	return (struct small_value){(uint32_t)run.start -
			(uint32_t)run.right * (uint32_t)small->frame.column,
		(uint32_t)run.right, (uint32_t)run.down};
}

/* How a colour becomes a run's: its scale, and that over the area. */
struct color_scale {
	int32_t half, scale, inverse, round;
	int shift;
};

static ALWAYS_INLINE struct color_scale find_scale(
	const struct small *small, int32_t half, int32_t scale)
{
	/* Areas below 256 have no inverse: colours stay the first corner's. */
	int shift = small->frame.zeros < 24 ? 24 - small->frame.zeros : 1;

	return (struct color_scale){half, scale,
		mul_high(small->frame.inverse_area, scale * 64),
		1 << (shift - 1), shift};
}

static ALWAYS_INLINE struct small_value find_color(const struct small *small,
	const struct color_scale *by, const struct delta *delta, uint32_t *size)
{
	const struct frame *f = &small->frame;
	int32_t across = frame_find_right(f, delta->d1, delta->d2);
	int32_t along = frame_find_down(f, delta->d1, delta->d2);
	int32_t right = (mul_high(across, by->inverse) + by->round) >> by->shift;
	int32_t down = (mul_high(along, by->inverse) + by->round) >> by->shift;
	uint32_t start = (uint32_t)((right * f->off_x + down * f->off_y) >> 4);

	start += (uint32_t)mul_high_add(by->half, delta->first * 256, by->scale);
	*size |= (uint32_t)(right ^ right >> 31);
	return enter(small, (struct run){(int32_t)start, right, down});
}

static ALWAYS_INLINE struct small_value pair_values(
	const struct small_value *high, const struct small_value *low)
{
	return (struct small_value){(high->start << 16) + low->start,
		(high->right << 16) + low->right,
		(high->down << 16) + low->down};
}

/* Alpha that moves is exact, so that alpha tests are; whether it is steep. */
static NEVER_INLINE bool begin_alpha(
	struct small_list *list, const struct small small)
{
	const struct delta delta = find_delta(small.color, ALPHA);
	const struct run run = find_run(&small, &delta);

	list->rare = list->alpha_moves = true;
	list->alpha = enter(&small, run);
	list->draw->spans.run.green_alpha_right +=
		(uint32_t)soft_alpha_step(run.right) << 16;
	return raster_size(run.right) >= (uint32_t)small.steep;
}

/* A step of 8.16, to the nearest of what a scale makes of it. */
static int32_t round_step(int32_t step, int32_t scale)
{
	return (mul_high((int32_t)((uint32_t)step * 2), scale) + 1) >> 1;
}

/* Whether fog is steep. */
static NEVER_INLINE bool begin_fog(struct small_list *list,
	const struct setup *setup, const struct small small)
{
	const int32_t *const corner[3] = {setup->v[0]->attribute,
		setup->v[1]->attribute, setup->v[2]->attribute};
	const struct delta delta = find_delta(corner, FOG);
	struct run run = find_run(&small, &delta);
	bool is_steep = raster_size(run.right) >= (uint32_t)small.steep;

	run.start = mul_high(run.start, SOFT_FOG_SCALE);
	run.right = round_step(run.right, SOFT_FOG_SCALE);
	run.down = round_step(run.down, SOFT_FOG_SCALE);
	list->fog = enter(&small, run);
	list->rare |= moves(&delta);
	list->draw->spans.run.fog_right = list->fog.right;
	return is_steep;
}

/* Red, green and blue that move. */
static ALWAYS_INLINE void begin_moving(struct small_list *list,
	struct small *small, const struct delta rgb[3], int32_t green_half)
{
	const struct soft_scales *scales = &list->draw->spans.scales;
	const struct color_scale green =
		find_scale(small, green_half, scales->green);
	struct color_scale by =
		find_scale(small, scales->red_blue_half, scales->red_blue);
	uint32_t five = 0, six = 0;
	const struct small_value red = find_color(small, &by, &rgb[0], &five);
	const struct small_value blue = find_color(small, &by, &rgb[2], &five);

	list->red_blue = pair_values(&blue, &red);
	list->green = find_color(small, &green, &rgb[1], &six);
	small->is_steep =
		five >= (uint32_t)mul_high(small->steep, scales->red_blue) ||
		six >= (uint32_t)mul_high(small->steep, scales->green);
}

static ALWAYS_INLINE void begin_still(
	struct small_list *list, const struct delta rgb[3], int32_t green_half)
{
	const struct soft_scales *scales = &list->draw->spans.scales;
	const int32_t half = scales->red_blue_half, five = scales->red_blue;
	int32_t red = mul_high_add(half, rgb[0].first * 256, five);
	int32_t blue = mul_high_add(half, rgb[2].first * 256, five);

	list->red_blue = (struct small_value){
		((uint32_t)blue << 16) + (uint32_t)red, 0, 0};
	list->green =
		(struct small_value){(uint32_t)mul_high_add(green_half,
					     rgb[1].first * 256, scales->green),
			0, 0};
}

static ALWAYS_INLINE void begin_colors(
	struct small_list *list, const struct setup *setup, struct small *small)
{
	struct soft_spans *spans = &list->draw->spans;
	const uint32_t wanted = list->draw->attributes & ~spans->white_bits;
	const struct delta white = {WHITE, 0, 0};
	struct delta rgb[3] = {white, white, white}, alpha = white;
	int32_t green_half = spans->scales.green_half;

	if (wanted >> RED & 1) {
		rgb[0] = find_delta(small->color, RED);
		rgb[1] = find_delta(small->color, GREEN);
		rgb[2] = find_delta(small->color, BLUE);
	}
	if (wanted >> ALPHA & 1) {
		alpha = find_delta(small->color, ALPHA);
	}
	if (spans->alpha_read && !moves(&alpha)) {
		green_half += alpha.first >> 1 << 16;
	}
	if (moves(&rgb[0]) || moves(&rgb[1]) || moves(&rgb[2])) {
		begin_moving(list, small, rgb, green_half);
	} else {
		begin_still(list, rgb, green_half);
	}
	spans->run.red_blue_right = list->red_blue.right;
	spans->run.green_alpha_right = list->green.right;
	list->rare = spans->made;
	list->alpha_moves = false;
	list->fog.start = 0;
	if (moves(&alpha)) {
		small->is_steep |= begin_alpha(list, *small);
	}
	if (wanted >> FOG & 1) {
		small->is_steep |= begin_fog(list, setup, *small);
	}
}

#endif
