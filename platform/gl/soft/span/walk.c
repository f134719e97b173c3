/*
 * The rows of a triangle, cut into runs for the span functions. Values run
 * linearly along a row where perspective bends them too little to be seen, see
 * raster.c; else they are divided exactly every 16 or 32 pixels.
 */
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/texels.h"
#include "platform/gl/soft/vertex/number.h"

/* 32 steps of 255 a pixel, 8.16. */
#define STEEP (1u << 21)

/* What moves in a triangle, and is divided by 1 / w; constants of the walk. */
struct walk_kind {
	bool textured, colored;
	bool texels_divided, colors_divided;
	bool mild; /* as rows_find_mild_w() has it */
};

/* A row under way; row counts from the triangle's first one. */
struct line {
	struct draw *draw;
	int row;
	uint16_t *depth; /* of column 0 */
	uint8_t *pixel;
};

/* Colours and fog, 8.16; their values at a pixel, or their steps. */
struct colors {
	int32_t red, green, blue, alpha, fog;
};

struct row_point {
	struct point divisor; /* q and its reciprocal alone */
	struct texels texels;
	struct colors colors;
};

/* A plane's value at column x of the row. */
static ALWAYS_INLINE int32_t find_value(
	const struct line *line, int plane, int x)
{
	const struct plane *p = &line->draw->raster.plane[plane];

	return (int32_t)(p->start + (uint32_t)p->dy * (uint32_t)line->row +
		(uint32_t)p->dx * (uint32_t)x);
}

/* Coordinates far outside of the texture wrap around. */
static ALWAYS_INLINE int32_t step_by(int32_t at, int32_t step, int count)
{
	return (int32_t)((uint32_t)at + (uint32_t)step * (uint32_t)count);
}

/* Cut towards zero, so that what moves stays between its ends. */
static ALWAYS_INLINE uint32_t scale_step(int32_t step, int32_t scale)
{
	return (uint32_t)mul_high(step, scale) + ((uint32_t)step >> 31);
}

/* Alpha and fog stay what they are, see set_still(), unless they move. */
static ALWAYS_INLINE void set_colors(
	struct soft_spans *spans, int32_t red, int32_t green, int32_t blue)
{
	struct soft_run *run = &spans->run;
	int32_t scale = spans->scales.red_blue,
		half = spans->scales.red_blue_half;

	run->red_blue = ((uint32_t)mul_high_add(half, blue, scale) << 16) +
		(uint32_t)mul_high_add(half, red, scale);
	run->green_alpha = (uint32_t)mul_high_add(
		spans->green_start, green, spans->scales.green);
}

static ALWAYS_INLINE void set_more_colors(
	struct soft_spans *spans, const struct colors *at)
{
	struct soft_run *run = &spans->run;

	if (spans->alpha_moves) {
		run->green_alpha += (uint32_t)at->alpha >> 9 << 16;
	}
	if (spans->fog_moves) {
		run->fog = (uint32_t)mul_high(at->fog, SOFT_FOG_SCALE);
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
	if (spans->alpha_moves) {
		run->green_alpha_right += (uint32_t)soft_alpha_step(step->alpha)
			<< 16;
	}
	if (spans->fog_moves) {
		run->fog_right = scale_step(step->fog, SOFT_FOG_SCALE);
	}
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
 * Alpha and fog that move, and colours that are steep: these run from one end
 * of the run to the other, both in range.
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
		set_colors(spans, from.red, from.green, from.blue);
	}
	set_more_colors(spans, &from);
}

/* Colours that run linearly in all of the triangle. */
static ALWAYS_INLINE void place_colors(const struct line *line, int x, int count)
{
	struct soft_spans *spans = &line->draw->spans;

	set_colors(spans, find_value(line, RED, x), find_value(line, GREEN, x),
		find_value(line, BLUE, x));
	if (spans->rare) {
		place_rare_colors(line, x, count);
	}
}

/* Draws a run of so many pixels from x on, whose values and steps are set. */
static ALWAYS_INLINE void draw_run(
	const struct line *line, const struct walk_kind kind, int x, int count)
{
	struct soft_spans *spans = &line->draw->spans;
	struct soft_run *run = &spans->run;

	run->count = (uint32_t)count;
	run->depth = line->depth + x;
	run->pixel = line->pixel + (x << spans->pixel_log2);
	run->z = (uint32_t)find_value(line, DEPTH, x) << 6;
	if (!kind.textured ||
		soft_find_window(&spans->window, spans->view.texel_log2, run)) {
		spans->draw(run);
	} else {
		soft_draw_across(spans);
	}
}

static ALWAYS_INLINE void row_linear(
	const struct line *line, const struct walk_kind kind, int x, int right)
{
	struct draw *draw = line->draw;
	const struct plane *plane = draw->raster.plane;
	const int most =
		kind.textured ? SOFT_RUN_PIXELS : draw->spans.plain_pixels;

	for (; x < right; x += most) {
		int count = right - x < most ? right - x : most;

		if (kind.textured) {
			soft_set_texels(&draw->spans,
				(struct texels){find_value(line, TEX_S, x),
					find_value(line, TEX_S + 1, x)},
				(struct texels){
					plane[TEX_S].dx, plane[TEX_S + 1].dx},
				(uint32_t)count);
		}
		if (kind.colored) {
			place_colors(line, x, count);
		}
		draw_run(line, kind, x, count);
	}
}

/* plane is the attribute's; of textures it tells the scale, too. */
static ALWAYS_INLINE int32_t divide(const struct line *line,
	const struct walk_kind kind, const struct point *divisor, int plane,
	int x)
{
	const struct raster *raster = &line->draw->raster;
	int32_t value = find_value(line, plane, x);

	if (kind.mild) {
		value = rows_divide_mild(value, divisor->inverse);
	} else {
		value = rows_divide(divisor, value,
			plane >= TEX_S ? raster->tex_shift[plane - TEX_S] + 8
				       : 24);
	}
	return plane >= TEX_S ? value : limit_color(value);
}

static ALWAYS_INLINE struct row_point find_point(
	const struct line *line, const struct walk_kind kind, int x)
{
	const struct soft_spans *spans = &line->draw->spans;
	int32_t q = find_value(line, INVERSE_W, x);
	struct row_point out;
	struct point *by = &out.divisor;

	if (kind.mild) {
		by->inverse = rows_find_mild_w(q, find_value(line, LINEAR_W, x));
	} else {
		rows_find_divisor(q, by);
	}
	if (kind.textured) {
		out.texels.s = divide(line, kind, by, TEX_S, x);
		out.texels.t = divide(line, kind, by, TEX_S + 1, x);
	}
	if (kind.colors_divided) {
		out.colors.red = divide(line, kind, by, RED, x);
		out.colors.green = divide(line, kind, by, GREEN, x);
		out.colors.blue = divide(line, kind, by, BLUE, x);
		if (spans->alpha_moves) {
			out.colors.alpha = divide(line, kind, by, ALPHA, x);
		}
		if (spans->fog_moves) {
			out.colors.fog = divide(line, kind, by, FOG, x);
		}
	}
	return out;
}

static ALWAYS_INLINE uint32_t distance(int32_t a, int32_t b)
{
	return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

static ALWAYS_INLINE uint32_t larger(uint32_t a, uint32_t b)
{
	return a > b ? a : b;
}

/* The most that a colour changes, in what counts as much of a texel. */
static ALWAYS_INLINE uint32_t find_change(const struct soft_spans *spans,
	const struct colors *from, const struct colors *to)
{
	uint32_t most = larger(distance(from->red, to->red),
		larger(distance(from->green, to->green),
			distance(from->blue, to->blue)));

	if (spans->alpha_moves) {
		most = larger(most, distance(from->alpha, to->alpha));
	}
	if (spans->fog_moves) {
		most = larger(most, distance(from->fog, to->fog));
	}
	return most >> spans->color_tolerance;
}

/*
 * How many pixels apart the exact divisions of a row may be: what runs
 * linearly is off by |dv dq| / 4 q at most, a quarter of that in halves of it.
 */
static ALWAYS_INLINE int find_spacing(const struct draw *draw,
	const struct walk_kind kind, const struct row_point *from,
	const struct row_point *to, int steps)
{
	uint32_t q =
		(uint32_t)(from->divisor.q < to->divisor.q ? from->divisor.q
							   : to->divisor.q);
	uint64_t error, allowed = (uint64_t)q << 16;
	uint32_t most = 0;

	if (kind.textured) {
		most = larger(distance(from->texels.s, to->texels.s),
			distance(from->texels.t, to->texels.t));
	}
	if (kind.colors_divided) {
		most = larger(most,
			find_change(&draw->spans, &from->colors, &to->colors));
	}
	error = (uint64_t)most * distance(from->divisor.q, to->divisor.q);
	if (error <= allowed && steps <= SMALL_EXTENT) {
		return steps + 1;
	}
	/* A 2,048th of a row is less than 32 pixels apart */
	return error >> 2 <= (allowed >> 12) * (uint32_t)(steps * steps)
		? SOFT_RUN_PIXELS
		: PERSPECTIVE_STEP;
}

/* How values change between two points. */
struct change {
	struct texels texels;
	struct colors colors;
};

static ALWAYS_INLINE struct change set_steps(const struct line *line,
	const struct walk_kind kind, const struct row_point *from,
	const struct row_point *to, int steps)
{
	struct soft_spans *spans = &line->draw->spans;
	int32_t inverse = line->draw->inverse_q31[steps];
	struct change out;

	if (kind.textured) {
		out.texels.s =
			rows_find_step(from->texels.s, to->texels.s, inverse);
		out.texels.t =
			rows_find_step(from->texels.t, to->texels.t, inverse);
		soft_set_texel_steps(spans, out.texels);
	}
	if (kind.colors_divided) {
		out.colors = find_color_steps(
			spans, &from->colors, &to->colors, inverse);
		set_color_steps(spans, &out.colors);
	}
	return out;
}

/* Draws a run that begins so many pixels behind a point. */
static ALWAYS_INLINE void draw_behind(const struct line *line,
	const struct walk_kind kind, int x, int count,
	const struct row_point *from, const struct change *change, int past)
{
	struct soft_spans *spans = &line->draw->spans;
	const struct colors *c = &from->colors, *step = &change->colors;

	if (kind.textured) {
		const struct texels at = {
			step_by(from->texels.s, change->texels.s, past),
			step_by(from->texels.t, change->texels.t, past)};

		soft_set_texels(spans, at, change->texels, (uint32_t)count);
	}
	if (kind.colors_divided) {
		const struct colors more = {
			.alpha = step_by(c->alpha, step->alpha, past),
			.fog = step_by(c->fog, step->fog, past)};

		set_colors(spans, step_by(c->red, step->red, past),
			step_by(c->green, step->green, past),
			step_by(c->blue, step->blue, past));
		set_more_colors(spans, &more);
	} else if (kind.colored) {
		place_colors(line, x, count);
	}
	draw_run(line, kind, x, count);
}

/*
 * Draws from left to right what runs linearly between two points, so many
 * steps apart.
 */
static ALWAYS_INLINE void draw_between(const struct line *line,
	const struct walk_kind kind, int left, int right,
	const struct row_point *from, const struct row_point *to, int steps)
{
	const int most = kind.textured ? SOFT_RUN_PIXELS
				       : line->draw->spans.plain_pixels;
	const struct change change = set_steps(line, kind, from, to, steps);

	for (int x = left; x < right; x += most) {
		draw_behind(line, kind, x, right - x < most ? right - x : most,
			from, &change, x - left);
	}
}

static NEVER_INLINE void set_row_level(
	struct draw *draw, struct point point, struct texels texels)
{
	struct raster *raster = &draw->raster;

	point.value[TEX_S] = texels.s;
	point.value[TEX_S + 1] = texels.t;
	soft_rows_find_lod(draw, &point, &raster->span);
	soft_set_level(draw, raster->span.lod[0]);
}

static ALWAYS_INLINE void row_divided(const struct line *line,
	const struct walk_kind kind, int left, int right)
{
	int steps = right - left - 1, x = left;
	struct row_point from = find_point(line, kind, left), to, end = from;

	if (steps > 0) {
		end = find_point(line, kind, right - 1);
	}
	if (kind.textured && line->draw->spans.level_by_row) {
		set_row_level(line->draw, from.divisor, from.texels);
	}
	if (steps >= PERSPECTIVE_STEP) {
		int spacing = find_spacing(line->draw, kind, &from, &end, steps);

		for (; right - x > spacing; x += spacing) {
			to = find_point(line, kind, x + spacing);
			draw_between(line, kind, x, x + spacing, &from, &to,
				spacing);
			from = to;
		}
	}
	draw_between(line, kind, x, right, &from, &end, right - x - 1);
}

/* In mild perspective each run leads to the pixel behind it. */
static ALWAYS_INLINE void row_mild(const struct line *line,
	const struct walk_kind kind, int left, int right)
{
	const int most = line->draw->raster.mild_pixels;
	struct row_point from = find_point(line, kind, left);

	for (int x = left; x < right; x += most) {
		int count = right - x < most ? right - x : most;
		struct row_point to = find_point(line, kind, x + count);
		struct change change = set_steps(line, kind, &from, &to, count);

		draw_behind(line, kind, x, count, &from, &change, 0);
		from = to;
	}
}

/* Rows between two edges. */
static ALWAYS_INLINE void walk_part(struct line *line,
	const struct walk_kind kind, struct side *left_side,
	struct side *right_side, int rows)
{
	const struct buffers *buffers = &line->draw->soft->buffers;
	const int width = buffers->width;
	const int stride_bytes = buffers->target.stride_bytes;
	const struct clip_box box = line->draw->box;
	struct side first = *left_side, last = *right_side;

	for (int end = line->row + rows; line->row < end; line->row++) {
		int left = raster_column(first.x);
		int right = raster_column(last.x);

		left = left > box.left ? left : box.left;
		right = right < box.right ? right : box.right;
		if (left < right) {
			if (kind.mild) {
				row_mild(line, kind, left, right);
			} else if (kind.texels_divided || kind.colors_divided) {
				row_divided(line, kind, left, right);
			} else {
				row_linear(line, kind, left, right);
			}
		}
		raster_next_side(&first);
		raster_next_side(&last);
		line->depth += width;
		line->pixel += stride_bytes;
	}
	*left_side = first;
	*right_side = last;
}

/* All rows, above and below the middle vertex. */
static ALWAYS_INLINE void walk(struct draw *draw, const struct setup *setup,
	const struct walk_kind kind)
{
	const struct buffers *buffers = &draw->soft->buffers;
	int y = raster_first_row(draw, setup);
	int bottom = setup->bottom < draw->box.bottom ? setup->bottom
						      : draw->box.bottom;
	struct line line = {
		.draw = draw,
		.row = y - setup->top,
		.depth = buffers->depth + (ptrdiff_t)y * buffers->width,
		.pixel = buffers->target.data +
			(ptrdiff_t)y * buffers->target.stride_bytes,
	};
	struct side side[2]; /* left and right */
	int part = setup->middle_left ? 0 : 1;

	side[!part] = raster_side(draw, setup->v[0], setup->v[2], y);
	for (int i = 0; i < 2; i++) {
		int end = i == 0 && setup->middle < bottom ? setup->middle
							   : bottom;

		if (y < end) {
			side[part] = raster_side(
				draw, setup->v[i], setup->v[i + 1], y);
			walk_part(&line, kind, &side[0], &side[1], end - y);
			y = end;
		}
	}
}

#define WALK(name, ...)                                             \
	static NEVER_INLINE void walk_##name(                       \
		struct draw *draw, const struct setup *setup)       \
	{                                                           \
		walk(draw, setup, (struct walk_kind){__VA_ARGS__}); \
	}

WALK(plain_still, .textured = false)
WALK(plain, .colored = true)
WALK(plain_divided, .colored = true, .colors_divided = true)
WALK(still, .textured = true)
WALK(still_divided, .textured = true, .texels_divided = true)
WALK(colored, .textured = true, .colored = true)
WALK(colored_by_texels, .textured = true, .colored = true,
	.texels_divided = true)
WALK(colored_divided, .textured = true, .colored = true, .texels_divided = true,
	.colors_divided = true)
WALK(plain_mild, .colored = true, .colors_divided = true, .mild = true)
WALK(still_mild, .textured = true, .texels_divided = true, .mild = true)
WALK(colored_by_texels_mild, .textured = true, .colored = true,
	.texels_divided = true, .mild = true)
WALK(colored_mild, .textured = true, .colored = true, .texels_divided = true,
	.colors_divided = true, .mild = true)

/* What of alpha and fog stays the same; see set_colors(). */
static void set_still(struct draw *draw)
{
	const uint32_t *value = draw->raster.span.value;
	struct soft_spans *spans = &draw->spans;

	spans->green_start = spans->scales.green_half;
	if (spans->alpha_read && !spans->alpha_moves) {
		spans->green_start += (int32_t)(value[ALPHA] >> 9 << 16);
	}
	if (!spans->fog_moves) {
		spans->run.fog =
			(uint32_t)mul_high((int32_t)value[FOG], SOFT_FOG_SCALE);
		spans->run.fog_right = 0;
	}
}

/* The steps of a triangle whose colours are linear all over. */
static struct colors find_plane_steps(const struct raster *raster)
{
	return (struct colors){raster->plane[RED].dx, raster->plane[GREEN].dx,
		raster->plane[BLUE].dx, raster->plane[ALPHA].dx,
		raster->plane[FOG].dx};
}

/* What stays the same in all of the triangle. */
static void set_constants(struct draw *draw, uint32_t moving)
{
	const struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;
	const struct plane *plane = raster->plane;

	spans->run.z_right = (uint32_t)plane[DEPTH].dx << 6;
	set_still(draw);
	spans->steep = false;
	if (!moving) {
		const uint32_t *value = raster->span.value;

		set_colors(spans, (int32_t)value[RED], (int32_t)value[GREEN],
			(int32_t)value[BLUE]);
		set_color_steps(spans, &(struct colors){0});
	} else if (!raster->colors_divided) {
		const struct colors step = find_plane_steps(raster);
		const int32_t all[] = {
			step.red, step.green, step.blue, step.alpha, step.fog};

		set_color_steps(spans, &step);
		for (int i = RED; i <= FOG; i++) {
			spans->steep |= (moving >> i & 1) &&
				(uint32_t)all[i] + STEEP > 2 * STEEP;
		}
		spans->rare =
			spans->steep || spans->alpha_moves || spans->fog_moves;
	}
	if (!spans->textured) {
		return;
	}
	spans->level_by_row =
		spans->lod_wanted && raster->perspective && !raster->mild;
	if (!spans->lod_wanted) {
		soft_set_level(draw, 0);
	} else if (!spans->level_by_row) {
		soft_rows_find_affine_lod(draw, &draw->raster.span);
		soft_set_level(draw, raster->span.lod[0]);
	}
	if (!spans->level_by_row && !spans->made) {
		soft_set_window(draw);
	}
	if (!raster->perspective) {
		soft_set_texel_steps(spans,
			(struct texels){plane[TEX_S].dx, plane[TEX_S + 1].dx});
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
		/* as set_mild_plane() and set_perspective() scale products */
		const int down = raster->mild ? 17 : 16;

		plane->start = (uint32_t)((int32_t)q->start * part >> down);
		plane->dx = (int32_t)(q->dx * part >> down);
		plane->dy = (int32_t)(q->dy * part >> down);
	}
	raster->moving[raster->moving_count++] = name;
}

/* Which of colours, alpha and fog move: red, green and blue do so together. */
static uint32_t find_moving(struct draw *draw)
{
	struct raster *raster = &draw->raster;
	struct soft_spans *spans = &draw->spans;
	uint32_t moving = 0;

	for (int n = 0; n < raster->moving_count; n++) {
		moving |= 1u << raster->moving[n];
	}
	moving &= (2u << FOG) - 1;
	spans->alpha_moves = moving >> ALPHA & 1;
	spans->fog_moves = moving >> FOG & 1;
	for (int i = RED; i <= BLUE && moving; i++) {
		if (!(moving >> i & 1)) {
			add_plane(draw, i);
		}
	}
	return moving;
}

void soft_walk_rows(struct draw *draw, const struct setup *setup)
{
	const struct raster *raster = &draw->raster;
	bool bent = raster->perspective, mild = raster->mild;
	uint32_t moving;

	if (!draw->spans.used) {
		soft_walk_general(draw, setup);
		return;
	}
	moving = find_moving(draw);
	set_constants(draw, moving);
	if (!draw->spans.textured) {
		(!moving               ? walk_plain_still
				: mild ? walk_plain_mild
				: bent ? walk_plain_divided
				       : walk_plain)(draw, setup);
	} else if (!moving) {
		(mild                  ? walk_still_mild
				: bent ? walk_still_divided
				       : walk_still)(draw, setup);
	} else if (raster->colors_divided) {
		(mild ? walk_colored_mild : walk_colored_divided)(draw, setup);
	} else {
		(mild                  ? walk_colored_by_texels_mild
				: bent ? walk_colored_by_texels
				       : walk_colored)(draw, setup);
	}
}
