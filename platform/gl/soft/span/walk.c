/*
 * The rows of a triangle, cut into runs for the span functions. Values run
 * linearly along a row where perspective bends them too little to be seen, see
 * raster.c; else they are divided exactly every 16 or 32 pixels.
 */
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/depth_ways.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/vertex/number.h"

/* What a run across a texture's edge is cut into. */
enum {
	PIECE_PIXELS = 8
};

/* 32 steps of 255 a pixel, 8.16. */
#define STEEP (1u << 21)

/* What moves in a triangle, and is divided by 1 / w; constants of the walk. */
struct walk_kind {
	bool textured, colored;
	bool texels_divided, colors_divided;
};

/* Colours and fog, 8.16; their values at a pixel, or their steps. */
struct colors {
	int32_t red, green, blue, alpha, fog;
};

/* Coordinates in the base's texels, 16.16. */
struct texels {
	int32_t s, t;
};

struct row_point {
	int32_t q;
	struct texels texels;
	struct colors colors;
};

/* Coordinates far outside of the texture wrap around. */
static ALWAYS_INLINE int32_t step_by(int32_t at, int32_t step, int32_t count)
{
	return (int32_t)((uint32_t)at + (uint32_t)step * (uint32_t)count);
}

/* The level and filter for a level of detail, if they are not set already. */
static NEVER_INLINE void set_level(struct draw *draw, int lod)
{
	struct soft_spans *spans = &draw->spans;
	const struct texture_input *input = &draw->texture[0];
	const struct texture *texture = input->texture;
	GLenum min = texture->min_filter;
	bool sharp = texture->mag_filter == GL_LINEAR &&
		(min == GL_NEAREST_MIPMAP_NEAREST ||
			min == GL_NEAREST_MIPMAP_LINEAR);
	bool small = lod > (sharp ? 128 : 0);
	int number =
		small ? clamp_int((lod + 127) >> 8, 0, input->levels - 1) : 0;
	const struct level *level = &texture->level[number];
	struct soft_run *run = &spans->run;
	bool linear = small ? min == GL_LINEAR || min == GL_LINEAR_MIPMAP_NEAREST
			    : texture->mag_filter == GL_LINEAR;
	int32_t s_most = (1 << level->width_log2) - 1;
	int32_t t_most = (1 << level->height_log2) - 1;
	bool s_repeats = texture->wrap_s == GL_REPEAT;
	bool t_repeats = texture->wrap_t == GL_REPEAT;

	if (number == spans->level && small == spans->small) {
		return;
	}
	spans->level = number;
	spans->small = small;
	spans->function = small ? spans->min : spans->mag;
	spans->s_shift = input->width_log2 - level->width_log2 + 16 -
		SOFT_TEXEL_FRACTION;
	spans->t_shift = input->height_log2 - level->height_log2 + 16 -
		SOFT_TEXEL_FRACTION;
	spans->s_half = soft_half_texel(level->format, linear, true);
	spans->t_half = soft_half_texel(level->format, linear, false);
	spans->s_last = s_most - linear;
	spans->t_last = t_most - linear;
	spans->has_inside = spans->function[0] != spans->function[1] &&
		spans->s_last >= 0 && spans->t_last >= 0;
	spans->splits = spans->has_inside && s_repeats && t_repeats &&
		s_most >= SOFT_RUN_PIXELS && t_most >= SOFT_RUN_PIXELS;
	spans->s_repeat = s_repeats ? s_most : -1;
	spans->t_repeat = t_repeats ? t_most : -1;
	spans->texel_log2 = soft_texel_bytes_log2(level->format);
	run->stride_log2 = (uint32_t)(level->width_log2 + spans->texel_log2);
	run->texels = level->texels;
	run->wrap_s = (struct soft_wrap){s_repeats ? INT32_MIN : 0,
		s_repeats ? INT32_MAX : s_most, (uint32_t)s_most};
	run->wrap_t = (struct soft_wrap){t_repeats ? INT32_MIN : 0,
		t_repeats ? INT32_MAX : t_most, (uint32_t)t_most};
}

/* Cut towards zero, so that what moves stays between its ends. */
static ALWAYS_INLINE uint32_t scale_step(int32_t step, int32_t scale)
{
	return (uint32_t)mul_high(step, scale) + ((uint32_t)step >> 31);
}

static ALWAYS_INLINE void set_colors(
	struct soft_spans *spans, const struct colors *at)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->red_blue_scale, half = spans->red_blue_half;
	uint32_t red = (uint32_t)(mul_high(at->red, scale) + half);
	uint32_t blue = (uint32_t)(mul_high(at->blue, scale) + half);

	run->red_blue = (blue << 16) + red;
	run->green_alpha = (uint32_t)(mul_high(at->green, spans->green_scale) +
		spans->green_half);
	if (spans->alpha_read) {
		run->green_alpha += (uint32_t)at->alpha >> 9 << 16;
	}
	if (spans->fogged) {
		run->fog = (uint32_t)mul_high(at->fog, SOFT_FOG_SCALE);
	}
}

static ALWAYS_INLINE void set_color_steps(
	struct soft_spans *spans, const struct colors *step)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->red_blue_scale;

	run->red_blue_right = (scale_step(step->blue, scale) << 16) +
		scale_step(step->red, scale);
	run->green_alpha_right = scale_step(step->green, spans->green_scale);
	if (spans->alpha_read) {
		run->green_alpha_right += (uint32_t)soft_alpha_step(step->alpha)
			<< 16;
	}
	if (spans->fogged) {
		run->fog_right = scale_step(step->fog, SOFT_FOG_SCALE);
	}
}

static ALWAYS_INLINE void set_texel_steps(
	struct soft_spans *spans, struct texels step)
{
	struct soft_run *run = &spans->run;

	run->s_right = soft_texel_step(step.s, spans->s_shift);
	run->t_right = soft_texel_step(step.t, spans->t_shift);
	spans->s_rest = soft_texel_rest(step.s, spans->s_shift);
	spans->t_rest = soft_texel_rest(step.t, spans->t_shift);
	run->texel_right =
		((uint32_t)run->t_right << 16) + (uint32_t)run->s_right;
}

/* The texels from at on, by so many steps: the first, as far as it goes on. */
static ALWAYS_INLINE bool find_texels(int32_t at, int32_t step, int32_t steps,
	int32_t repeat, int32_t last, int32_t *first, uint32_t *offset)
{
	int32_t low = at, high = step_by(at, step, steps);
	int32_t span;

	if (step < 0) {
		low = high;
		high = at;
	}
	low >>= SOFT_TEXEL_FRACTION;
	span = (high >> SOFT_TEXEL_FRACTION) - low;
	*offset = (uint32_t)at - ((uint32_t)low << SOFT_TEXEL_FRACTION);
	low &= repeat;
	*first = low;
	/* low may be negative: then it is large */
	return (uint32_t)low + (uint32_t)span <= (uint32_t)last &&
		(uint32_t)low <= (uint32_t)last && span < SOFT_RUN_TEXELS - 1;
}

/* Sets the run's texels where all of them lie inside of the level. */
static ALWAYS_INLINE bool find_inside(struct soft_spans *spans)
{
	struct soft_run *run = &spans->run;
	int32_t steps = (int32_t)run->count - 1, x, y;
	uint32_t s_off, t_off;

	if (!spans->has_inside ||
		!find_texels(run->s, run->s_right, steps, spans->s_repeat,
			spans->s_last, &x, &s_off) ||
		!find_texels(run->t, run->t_right, steps, spans->t_repeat,
			spans->t_last, &y, &t_off)) {
		return false;
	}
	run->first_texel = run->texels + ((uint32_t)y << run->stride_log2) +
		((uint32_t)x << spans->texel_log2);
	run->texel = (t_off << 16) + s_off;
	return true;
}

static void advance(struct soft_run *run, uint32_t count, int pixel_log2)
{
	run->depth += count;
	run->pixel += count << pixel_log2;
	run->z += run->z_right * count;
	run->red_blue += run->red_blue_right * count;
	run->green_alpha += run->green_alpha_right * count;
	run->fog += run->fog_right * count;
	run->s = step_by(run->s, run->s_right, (int32_t)count);
	run->t = step_by(run->t, run->t_right, (int32_t)count);
}

/* A run across the texture's edge: what of it lies inside goes faster. */
static NEVER_INLINE void draw_across(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	int pixel_log2 = raster_pixel_log2(draw);

	for (uint32_t left = run->count; left > 0; left -= run->count) {
		run->count = left < PIECE_PIXELS ? left : PIECE_PIXELS;
		spans->function[find_inside(spans)](run);
		advance(run, run->count, pixel_log2);
	}
}

/* Draws a run from x on, whose values and steps are set. */
static ALWAYS_INLINE void draw_run(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int x,
	int count)
{
	struct soft_spans *spans = &draw->spans;
	struct soft_run *run = &spans->run;
	bool inside = false;

	run->count = (uint32_t)count;
	run->depth = line->depth + x;
	run->pixel = line->pixel + (x << line->pixel_log2);
	run->z = line->z + run->z_right * (uint32_t)x;
	if (kind.textured) {
		inside = find_inside(spans);
	}
	if (spans->depth_way != SOFT_DEPTH_DIRECT) {
		soft_draw_tested(draw, spans->function[inside], x, line->y);
	} else if (kind.textured && !inside && spans->splits &&
		count > PIECE_PIXELS) {
		draw_across(draw);
	} else {
		spans->function[inside](run);
	}
}

static ALWAYS_INLINE void set_texels(
	struct soft_spans *spans, struct texels at, int count)
{
	spans->run.s =
		soft_texel_start(at.s, spans->s_rest, count, spans->s_shift) -
		spans->s_half;
	spans->run.t =
		soft_texel_start(at.t, spans->t_rest, count, spans->t_shift) -
		spans->t_half;
}

static ALWAYS_INLINE struct colors find_colors(
	const struct soft_spans *spans, const struct raster *raster, int x)
{
	struct colors at = {
		.red = (int32_t)plane_at(raster, RED, x),
		.green = (int32_t)plane_at(raster, GREEN, x),
		.blue = (int32_t)plane_at(raster, BLUE, x),
	};

	if (spans->alpha_read) {
		at.alpha = (int32_t)plane_at(raster, ALPHA, x);
	}
	if (spans->fogged) {
		at.fog = (int32_t)plane_at(raster, FOG, x);
	}
	return at;
}

static ALWAYS_INLINE struct texels find_texels_at(
	const struct raster *raster, int x)
{
	return (struct texels){(int32_t)plane_at(raster, TEX_S, x),
		(int32_t)plane_at(raster, TEX_S + 1, x)};
}

static ALWAYS_INLINE int32_t limit_color(int32_t color)
{
	return clamp_int(color, ROWS_LEAST_COLOR, ROWS_MOST_COLOR);
}

static ALWAYS_INLINE int32_t divide_color(const struct point *at, int32_t color)
{
	return limit_color(rows_divide(at, color, 24));
}

static ALWAYS_INLINE struct row_point find_point(
	const struct draw *draw, const struct walk_kind kind, int x)
{
	const struct raster *raster = &draw->raster;
	const struct soft_spans *spans = &draw->spans;
	int32_t q = (int32_t)plane_at(raster, INVERSE_W, x);
	struct row_point out = {.q = q > 0 ? q : 1};
	struct point divisor;

	divisor.zeros = LEADING_ZEROS_32((uint32_t)out.q);
	divisor.inverse = reciprocal((uint32_t)out.q << divisor.zeros);
	if (kind.textured) {
		struct texels t = find_texels_at(raster, x);

		out.texels.s =
			rows_divide(&divisor, t.s, raster->tex_shift[0] + 8);
		out.texels.t =
			rows_divide(&divisor, t.t, raster->tex_shift[1] + 8);
	}
	if (kind.colors_divided) {
		struct colors c = find_colors(spans, raster, x);

		out.colors.red = divide_color(&divisor, c.red);
		out.colors.green = divide_color(&divisor, c.green);
		out.colors.blue = divide_color(&divisor, c.blue);
		if (spans->alpha_read) {
			out.colors.alpha = divide_color(&divisor, c.alpha);
		}
		if (spans->fogged) {
			out.colors.fog = divide_color(&divisor, c.fog);
		}
	}
	return out;
}

/* inverse is 2^31 over the number of steps. */
static ALWAYS_INLINE int32_t find_step(int32_t from, int32_t to, int64_t inverse)
{
	return (int32_t)((int32_t)((uint32_t)to - (uint32_t)from) * inverse >>
		31);
}

static ALWAYS_INLINE void find_color_steps(struct soft_spans *spans,
	const struct colors *from, const struct colors *to, int64_t inverse,
	struct colors *step)
{
	step->red = find_step(from->red, to->red, inverse);
	step->green = find_step(from->green, to->green, inverse);
	step->blue = find_step(from->blue, to->blue, inverse);
	if (spans->alpha_read) {
		step->alpha = find_step(from->alpha, to->alpha, inverse);
	}
	if (spans->fogged) {
		step->fog = find_step(from->fog, to->fog, inverse);
	}
	set_color_steps(spans, step);
}

static ALWAYS_INLINE struct texels find_texel_steps(struct soft_spans *spans,
	struct texels from, struct texels to, int64_t inverse)
{
	const struct texels step = {find_step(from.s, to.s, inverse),
		find_step(from.t, to.t, inverse)};

	set_texel_steps(spans, step);
	return step;
}

static ALWAYS_INLINE void add_steps(struct soft_spans *spans, struct colors *at,
	const struct colors *step, int count)
{
	at->red = step_by(at->red, step->red, count);
	at->green = step_by(at->green, step->green, count);
	at->blue = step_by(at->blue, step->blue, count);
	if (spans->alpha_read) {
		at->alpha = step_by(at->alpha, step->alpha, count);
	}
	if (spans->fogged) {
		at->fog = step_by(at->fog, step->fog, count);
	}
}

/* Values that run linearly by their steps, which the run has too. */
static ALWAYS_INLINE void draw_linear(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int left,
	int right, struct texels texels, struct texels texel_step,
	struct colors *colors, const struct colors *color_step)
{
	struct soft_spans *spans = &draw->spans;
	const int most = kind.textured ? SOFT_RUN_PIXELS : spans->plain_pixels;

	for (int x = left;; x += most) {
		int count = right - x;

		if (kind.textured) {
			set_texels(spans, texels, count < most ? count : most);
		}
		if (kind.colored) {
			set_colors(spans, colors);
		}
		if (count <= most) {
			draw_run(draw, kind, line, x, count);
			return;
		}
		draw_run(draw, kind, line, x, most);
		texels.s = step_by(texels.s, texel_step.s, SOFT_RUN_PIXELS);
		texels.t = step_by(texels.t, texel_step.t, SOFT_RUN_PIXELS);
		if (kind.colored) {
			add_steps(spans, colors, color_step, most);
		}
	}
}

/* From one end of the row to the other, both in range. */
static NEVER_INLINE void limit_colors(struct draw *draw, int left, int right,
	struct colors *at, struct colors *step)
{
	struct soft_spans *spans = &draw->spans;
	struct colors to = find_colors(spans, &draw->raster, right - 1);

	at->red = limit_color(at->red);
	at->green = limit_color(at->green);
	at->blue = limit_color(at->blue);
	at->alpha = limit_color(at->alpha);
	at->fog = limit_color(at->fog);
	to.red = limit_color(to.red);
	to.green = limit_color(to.green);
	to.blue = limit_color(to.blue);
	to.alpha = limit_color(to.alpha);
	to.fog = limit_color(to.fog);
	find_color_steps(
		spans, at, &to, draw->inverse_q31[right - left - 1], step);
}

/* The steps of a triangle whose colours are linear all over. */
static ALWAYS_INLINE struct colors find_plane_steps(const struct raster *raster)
{
	return (struct colors){raster->plane[RED].dx, raster->plane[GREEN].dx,
		raster->plane[BLUE].dx, raster->plane[ALPHA].dx,
		raster->plane[FOG].dx};
}

static ALWAYS_INLINE void row_linear(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int left,
	int right)
{
	const struct raster *raster = &draw->raster;
	struct texels texels = {0, 0}, texel_step = {0, 0};
	struct colors colors = {0}, color_step = {0};

	if (kind.textured) {
		texels = find_texels_at(raster, left);
		texel_step.s = raster->plane[TEX_S].dx;
		texel_step.t = raster->plane[TEX_S + 1].dx;
	}
	if (kind.colored) {
		colors = find_colors(&draw->spans, raster, left);
		color_step = find_plane_steps(raster);
		if (draw->spans.steep) {
			limit_colors(draw, left, right, &colors, &color_step);
		}
	}
	draw_linear(draw, kind, line, left, right, texels, texel_step, &colors,
		&color_step);
}

static ALWAYS_INLINE uint32_t distance(int32_t a, int32_t b)
{
	return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

static ALWAYS_INLINE uint32_t larger(uint32_t a, uint32_t b)
{
	return a > b ? a : b;
}

/*
 * How many pixels apart the exact divisions of a row may be: what runs
 * linearly is off by |dv dq| / 4 q at most, a quarter of that in halves of it.
 */
static ALWAYS_INLINE int find_spacing(const struct draw *draw,
	const struct walk_kind kind, const struct row_point *from,
	const struct row_point *to, int steps)
{
	uint32_t q = (uint32_t)(from->q < to->q ? from->q : to->q);
	uint32_t dq = distance(from->q, to->q);
	uint64_t error, allowed = (uint64_t)q << 16;
	uint32_t most = 0;

	if (steps < PERSPECTIVE_STEP || dq == 0) {
		return steps <= SMALL_EXTENT ? steps + 1 : SOFT_RUN_PIXELS;
	}
	if (kind.textured) {
		most = larger(distance(from->texels.s, to->texels.s),
			distance(from->texels.t, to->texels.t));
	}
	if (kind.colors_divided) {
		uint32_t color = larger(
			larger(distance(from->colors.red, to->colors.red),
				distance(from->colors.green, to->colors.green)),
			distance(from->colors.blue, to->colors.blue));

		if (draw->spans.alpha_read) {
			color = larger(color,
				distance(from->colors.alpha, to->colors.alpha));
		}
		if (draw->spans.fogged) {
			color = larger(color,
				distance(from->colors.fog, to->colors.fog));
		}
		most = larger(most, color >> draw->spans.color_tolerance);
	}
	error = (uint64_t)most * dq;
	if (error <= allowed && steps <= SMALL_EXTENT) {
		return steps + 1;
	}
	/* A 2,048th of a row is less than 32 pixels apart */
	return error >> 2 <= (allowed >> 12) * (uint32_t)(steps * steps)
		? SOFT_RUN_PIXELS
		: PERSPECTIVE_STEP;
}

/* A run between two points, the values of the first set by the caller. */
static ALWAYS_INLINE void draw_between(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int x,
	int count, const struct row_point *from, const struct row_point *to,
	int steps)
{
	struct soft_spans *spans = &draw->spans;
	int64_t inverse = draw->inverse_q31[steps];

	if (kind.textured) {
		find_texel_steps(spans, from->texels, to->texels, inverse);
		set_texels(spans, from->texels, count);
	}
	if (kind.colors_divided) {
		struct colors step;

		find_color_steps(
			spans, &from->colors, &to->colors, inverse, &step);
		set_colors(spans, &from->colors);
	} else if (kind.colored) {
		struct colors colors = find_colors(spans, &draw->raster, x);

		set_colors(spans, &colors);
	}
	draw_run(draw, kind, line, x, count);
}

static ALWAYS_INLINE void row_bent(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int left,
	int right, struct row_point from, const struct row_point *end,
	int spacing)
{
	int x = left;

	for (; right - x > spacing; x += spacing) {
		struct row_point to = find_point(draw, kind, x + spacing);

		draw_between(draw, kind, line, x, spacing, &from, &to, spacing);
		from = to;
	}
	draw_between(draw, kind, line, x, right - x, &from, end, right - x - 1);
}

static ALWAYS_INLINE void row_straight(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int left,
	int right, const struct row_point *from, const struct row_point *to)
{
	struct soft_spans *spans = &draw->spans;
	int64_t inverse = draw->inverse_q31[right - left - 1];
	struct texels texel_step = {0, 0};
	struct colors colors = {0}, color_step = {0};

	if (kind.textured) {
		texel_step = find_texel_steps(
			spans, from->texels, to->texels, inverse);
	}
	if (kind.colors_divided) {
		colors = from->colors;
		find_color_steps(spans, &from->colors, &to->colors, inverse,
			&color_step);
	} else if (kind.colored) {
		colors = find_colors(spans, &draw->raster, left);
		color_step = find_plane_steps(&draw->raster);
	}
	draw_linear(draw, kind, line, left, right, from->texels, texel_step,
		&colors, &color_step);
}

static NEVER_INLINE void set_row_level(struct draw *draw, int x)
{
	struct point point;

	soft_rows_find_point(draw, x, &point);
	soft_rows_find_lod(draw, &point, &draw->raster.span);
	set_level(draw, draw->raster.span.lod[0]);
}

static ALWAYS_INLINE void row_divided(struct draw *draw,
	const struct walk_kind kind, const struct soft_line *line, int left,
	int right)
{
	int steps = right - left - 1, spacing;
	struct row_point from, to;

	from = find_point(draw, kind, left);
	to = from;
	if (steps > 0) {
		to = find_point(draw, kind, right - 1);
	}
	if (kind.textured && draw->spans.level_by_row) {
		set_row_level(draw, left);
	}
	spacing = find_spacing(draw, kind, &from, &to, steps);
	if (spacing > steps) {
		row_straight(draw, kind, line, left, right, &from, &to);
	} else {
		row_bent(draw, kind, line, left, right, from, &to, spacing);
	}
}

static ALWAYS_INLINE void next_plane(struct plane *plane)
{
	plane->start += (uint32_t)plane->dy;
}

static ALWAYS_INLINE void next_row(const struct soft_spans *spans,
	struct raster *raster, const struct walk_kind kind)
{
	struct plane *plane = raster->plane;

	next_plane(&plane[DEPTH]);
	if (kind.texels_divided || kind.colors_divided) {
		next_plane(&plane[INVERSE_W]);
	}
	if (kind.textured) {
		next_plane(&plane[TEX_S]);
		next_plane(&plane[TEX_S + 1]);
	}
	if (kind.colored) {
		next_plane(&plane[RED]);
		next_plane(&plane[GREEN]);
		next_plane(&plane[BLUE]);
		if (spans->alpha_read) {
			next_plane(&plane[ALPHA]);
		}
		if (spans->fogged) {
			next_plane(&plane[FOG]);
		}
	}
}

static ALWAYS_INLINE void draw_row(struct draw *draw,
	const struct walk_kind kind, struct soft_line *line, int left, int right)
{
	const struct plane *depth = &draw->raster.plane[DEPTH];

	if (left < right) {
		line->z =
			(depth->start -
				(uint32_t)depth->dx * (uint32_t)draw->raster.x0)
			<< 6;
		if (kind.texels_divided || kind.colors_divided) {
			row_divided(draw, kind, line, left, right);
		} else {
			row_linear(draw, kind, line, left, right);
		}
	}
	next_row(&draw->spans, &draw->raster, kind);
}

SOFT_WALK(plain_still, false, false, false, false)
SOFT_WALK(plain, false, true, false, false)
SOFT_WALK(plain_divided, false, true, false, true)
SOFT_WALK(still, true, false, false, false)
SOFT_WALK(still_divided, true, false, true, false)
SOFT_WALK(colored, true, true, false, false)
SOFT_WALK(colored_by_texels, true, true, true, false)
SOFT_WALK(colored_divided, true, true, true, true)

/* What stays the same in all of the triangle. */
static void set_constants(struct draw *draw, bool colored)
{
	const struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;
	const struct plane *plane = raster->plane;

	spans->run.z_right = (uint32_t)plane[DEPTH].dx << 6;
	if (!colored) {
		const uint32_t *value = raster->span.value;
		const struct colors still = {(int32_t)value[RED],
			(int32_t)value[GREEN], (int32_t)value[BLUE],
			(int32_t)value[ALPHA], (int32_t)value[FOG]};

		set_colors(spans, &still);
		set_color_steps(spans, &(struct colors){0});
	} else if (!raster->colors_divided) {
		const struct colors step = find_plane_steps(raster);
		const int32_t all[] = {
			step.red, step.green, step.blue, step.alpha, step.fog};

		set_color_steps(spans, &step);
		spans->steep = false;
		for (int i = 0; i < 5; i++) {
			spans->steep |= (uint32_t)all[i] + STEEP > 2 * STEEP;
		}
	}
	if (!spans->textured) {
		return;
	}
	spans->level_by_row = spans->lod_wanted && raster->perspective;
	if (!spans->lod_wanted) {
		set_level(draw, 0);
	} else if (!raster->perspective) {
		soft_rows_find_affine_lod(draw, &draw->raster.span);
		set_level(draw, raster->span.lod[0]);
	}
	if (!raster->perspective) {
		const struct texels step = {
			plane[TEX_S].dx, plane[TEX_S + 1].dx};

		set_texel_steps(spans, step);
	}
}

/* A plane for what stays the same, in perspective a part of 1 / w's. */
static void add_plane(struct draw *draw, int name)
{
	struct raster *raster = &draw->raster;
	const struct plane *q = &raster->plane[INVERSE_W];
	struct plane *plane = &raster->plane[name];
	uint32_t value = raster->span.value[name];
	int64_t part = (int64_t)(value >> 8);

	*plane = (struct plane){.start = value};
	if (raster->colors_divided) {
		plane->start = (uint32_t)((int32_t)q->start * part >> 16);
		plane->dx = (int32_t)(q->dx * part >> 16);
		plane->dy = (int32_t)(q->dy * part >> 16);
	}
	raster->moving[raster->moving_count++] = name;
}

/* Colours that move do so together; whether they do. */
static bool join_colors(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	uint32_t wanted = draw->attributes & ((2u << FOG) - 1), moving = 0;

	for (int n = 0; n < raster->moving_count; n++) {
		moving |= 1u << raster->moving[n];
	}
	moving &= wanted;
	for (int i = RED; i <= FOG && moving; i++) {
		if ((wanted & ~moving) >> i & 1) {
			add_plane(draw, i);
		}
	}
	return moving != 0;
}

void soft_walk_rows(struct draw *draw, const struct setup *setup)
{
	const struct raster *raster = &draw->raster;
	bool colored, bent = raster->perspective;

	if (!draw->spans.used) {
		soft_walk_general(draw, setup);
		return;
	}
	colored = join_colors(draw);
	set_constants(draw, colored);
	if (!draw->spans.textured) {
		(!colored              ? walk_plain_still
				: bent ? walk_plain_divided
				       : walk_plain)(draw, setup);
	} else if (!colored) {
		(bent ? walk_still_divided : walk_still)(draw, setup);
	} else {
		(!bent ? walk_colored
				: raster->colors_divided
				? walk_colored_divided
				: walk_colored_by_texels)(draw, setup);
	}
}
