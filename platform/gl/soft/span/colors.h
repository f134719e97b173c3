/*
 * The row under way, and its colours in the number formats of struct soft_run.
 * Its functions are inlined into each walk over rows.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_COLORS_H
#define PLATFORM_GL_SOFT_SPAN_COLORS_H

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

/* The row under way. */
struct line {
	struct draw *draw;
	int row;         /* counted from the triangle's first row */
	int top;         /* the triangle's first row in the picture */
	uint16_t *depth; /* the row's column 0 */
	uint8_t *pixel;
};

/* Colours and fog, 8.16: their values at a pixel, or their steps a pixel. */
struct colors {
	int32_t red, green, blue, alpha, fog;
};

/* A plane's value at column x of the row. */
static ALWAYS_INLINE int32_t find_value(
	const struct line *line, int plane, int x)
{
	const struct plane *p = &line->draw->raster.plane[plane];

	return (int32_t)(p->start + (uint32_t)p->dy * (uint32_t)line->row +
		(uint32_t)p->dx * (uint32_t)x);
}

/* at + step * count; wraps around far outside of the texture. */
static ALWAYS_INLINE int32_t step_by(int32_t at, int32_t step, int count)
{
	return (int32_t)((uint32_t)at + (uint32_t)step * (uint32_t)count);
}

/* Scales a step, rounding towards zero, so that values stay between their ends. */
static ALWAYS_INLINE uint32_t scale_step(int32_t step, int32_t scale)
{
	return (uint32_t)mul_high(step, scale) + ((uint32_t)step >> 31);
}

/* Sets a run's red, green and blue; and alpha if it is constant: set_still(). */
static ALWAYS_INLINE void set_colors(
	struct soft_spans *spans, int32_t red, int32_t green, int32_t blue)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->scales.red_blue,
		half = spans->scales.red_blue_half;

	run->row.red_blue = ((uint32_t)mul_high_add(half, blue, scale) << 16) +
		(uint32_t)mul_high_add(half, red, scale);
	run->row.green_alpha = (uint32_t)mul_high_add(
		spans->green_start, green, spans->scales.green);
}

static ALWAYS_INLINE void set_more_colors(const struct soft_spans *spans,
	struct soft_row *row, int32_t alpha, int32_t fog)
{
	if (spans->alpha_moves) {
		row->green_alpha += (uint32_t)alpha >> 9 << 16;
	}
	if (spans->fog_moves) {
		row->fog = (uint32_t)mul_high(fog, SOFT_FOG_SCALE);
	}
}

static ALWAYS_INLINE void set_more_color_steps(
	struct soft_spans *spans, int32_t alpha, int32_t fog)
{
	if (spans->alpha_moves) {
		spans->run.green_alpha_right += (uint32_t)soft_alpha_step(alpha)
			<< 16;
	}
	if (spans->fog_moves) {
		spans->run.fog_right = scale_step(fog, SOFT_FOG_SCALE);
	}
}

static ALWAYS_INLINE void set_color_steps(
	struct soft_spans *spans, const struct colors *step)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->scales.red_blue;

	run->red_blue_right = (scale_step(step->blue, scale) << 16) +
		scale_step(step->red, scale);
	run->green_alpha_right = scale_step(step->green, spans->scales.green);
	set_more_color_steps(spans, step->alpha, step->fog);
}

static ALWAYS_INLINE struct colors find_colors(const struct line *line, int x)
{
	const struct soft_spans *spans = &line->draw->spans;
	struct colors at = {
		.red = find_value(line, RED, x),
		.green = find_value(line, GREEN, x),
		.blue = find_value(line, BLUE, x),
	};

	if (spans->alpha_moves) {
		at.alpha = find_value(line, ALPHA, x);
	}
	if (spans->fog_moves) {
		at.fog = find_value(line, FOG, x);
	}
	return at;
}

/* A step of 8.16 times a scale of struct soft_scales, rounded to the nearest. */
static ALWAYS_INLINE int32_t round_step(int32_t step, int32_t scale)
{
	return (mul_high((int32_t)((uint32_t)step * 2), scale) + 1) >> 1;
}

/* A colour's plane from column on, in the run's number format from column 0 on. */
static ALWAYS_INLINE struct plane scale_color(
	const struct plane *plane, int column, int32_t half, int32_t scale)
{
	const int32_t right = round_step(plane->dx, scale);

	return (struct plane){
		(uint32_t)mul_high_add(half, (int32_t)plane->start, scale) -
			(uint32_t)right * (uint32_t)column,
		right, round_step(plane->dy, scale)};
}

/* Red and blue in the halves of words. */
static ALWAYS_INLINE struct plane pair_colors(
	struct plane red, struct plane blue)
{
	return (struct plane){(blue.start << 16) + red.start,
		(int32_t)(((uint32_t)blue.dx << 16) + (uint32_t)red.dx),
		(int32_t)(((uint32_t)blue.dy << 16) + (uint32_t)red.dy)};
}

static ALWAYS_INLINE int32_t limit_color(int32_t color)
{
	return clamp_int(color, ROWS_LEAST_COLOR, ROWS_MOST_COLOR);
}

static ALWAYS_INLINE struct colors limit_colors(struct colors colors)
{
	return (struct colors){limit_color(colors.red),
		limit_color(colors.green), limit_color(colors.blue),
		limit_color(colors.alpha), limit_color(colors.fog)};
}

static ALWAYS_INLINE struct colors find_color_steps(
	const struct soft_spans *spans, const struct colors *from,
	const struct colors *to, int32_t inverse)
{
	struct colors step = {
		.red = rows_find_step(from->red, to->red, inverse),
		.green = rows_find_step(from->green, to->green, inverse),
		.blue = rows_find_step(from->blue, to->blue, inverse),
	};

	if (spans->alpha_moves) {
		step.alpha = rows_find_step(from->alpha, to->alpha, inverse);
	}
	if (spans->fog_moves) {
		step.fog = rows_find_step(from->fog, to->fog, inverse);
	}
	return step;
}

/*
 * Sets a run's colours where alpha or fog change, or where colours are steep:
 * steep ones are limited at both ends of the run, and linear between these.
 */
static NEVER_INLINE void place_rare_colors(
	const struct line *line, int x, int count)
{
	struct soft_spans *spans = &line->draw->spans;
	struct colors from = find_colors(line, x), to, step;

	if (spans->steep) {
		from = limit_colors(from);
		to = limit_colors(find_colors(line, x + count - 1));
		step = find_color_steps(
			spans, &from, &to, line->draw->inverse_q31[count - 1]);
		set_color_steps(spans, &step);
	}
	set_colors(spans, from.red, from.green, from.blue);
	set_more_colors(spans, &spans->run.row, from.alpha, from.fog);
}

/* Sets a run's colours, where they are linear in the triangle. */
static ALWAYS_INLINE void place_colors(const struct line *line, int x, int count)
{
	struct soft_spans *spans = &line->draw->spans;

	if (spans->rare) {
		place_rare_colors(line, x, count);
	} else {
		set_colors(spans, find_value(line, RED, x),
			find_value(line, GREEN, x), find_value(line, BLUE, x));
	}
}

#endif
