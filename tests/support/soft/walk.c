/*
 * Walks the rows of a triangle with any attributes. Rows are cut into runs, and
 * attributes divided by w, at the same columns as in the driver, by walk.c and
 * walk_list.c of platform/gl/soft/span.
 */
#include "tests/support/soft/reference.h"

#include <string.h>

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/number.h"

/* A column of a row: what divides its attributes, and these. */
struct column {
	struct point by;
	int32_t value[ATTRIBUTES];
};

/* A triangle under way, and its next run. */
struct walk {
	struct draw *draw;
	struct span span;
};

/* A plane's value at column x of the row in which it starts, the first one. */
static uint32_t plane_at(const struct raster *raster, int plane, int x)
{
	const struct plane *p = &raster->plane[plane];

	return p->start + (uint32_t)p->dx * (uint32_t)x;
}

/* Finds the attributes that move, divided by w if needed, at a row's column x. */
static void find_point(const struct draw *draw, int x, struct column *out)
{
	const struct raster *raster = &draw->raster;
	int32_t q;

	if (!raster->perspective) {
		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			out->value[i] = (int32_t)plane_at(raster, i, x);
		}
		return;
	}
	q = (int32_t)plane_at(raster, INVERSE_W, x);
	rows_find_divisor(q, &out->by);
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];
		int32_t at = (int32_t)plane_at(raster, i, x);

		if (!rows_is_divided(raster, i)) {
			out->value[i] = at;
		} else if (i >= TEX_S) {
			out->value[i] = rows_divide(
				&out->by, at, raster->tex_shift[i - TEX_S] + 8);
		} else {
			out->value[i] = clamp_int(rows_divide(&out->by, at, 24),
				ROWS_LEAST_COLOR, ROWS_MOST_COLOR);
		}
	}
}

/* Draws a run whose attributes begin at value[] and move by the span's steps. */
static void draw_run(
	struct walk *walk, int y, int x, int count, const int32_t value[])
{
	struct draw *draw = walk->draw;
	const struct raster *raster = &draw->raster;
	struct span *span = &walk->span;

	for (int n = 0; n < raster->moving_count; n++) {
		span->value[raster->moving[n]] =
			(uint32_t)value[raster->moving[n]];
	}
	span->x = x;
	span->y = y;
	span->count = count;
	span->value[DEPTH] = plane_at(raster, DEPTH, x);
	if (draw->texture[1].used && raster->perspective) {
		const struct soft_made_at at =
			soft_find_second(draw, 0, x, count, &span->lod[1]);

		span->value[TEX_S + 2] = (uint32_t)at.at.s;
		span->value[TEX_S + 3] = (uint32_t)at.at.t;
		span->step[TEX_S + 2] = at.step.s;
		span->step[TEX_S + 3] = at.step.t;
	}
	reference_draw_span(draw, span);
}

/* Draws runs, each as long as the first texture's coordinates permit. */
static void draw_linear(
	struct walk *walk, int y, int left, int right, int32_t value[])
{
	const struct draw *draw = walk->draw;
	const struct raster *raster = &draw->raster;
	const int32_t *step = walk->span.step;
	int most = draw->texture[0].used
		? rows_find_run_pixels(draw, step[TEX_S], step[TEX_S + 1])
		: SOFT_RUN_PIXELS;

	for (int x = left;; x += most) {
		if (right - x <= most) {
			draw_run(walk, y, x, right - x, value);
			return;
		}
		draw_run(walk, y, x, most, value);
		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			value[i] = (int32_t)((uint32_t)value[i] +
				(uint32_t)step[i] * (uint32_t)most);
		}
	}
}

static void set_steps(struct walk *walk, const struct column *from,
	const struct column *to, int steps)
{
	const struct draw *draw = walk->draw;
	const struct raster *raster = &draw->raster;

	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		walk->span.step[i] = rows_is_divided(raster, i)
			? rows_find_step(from->value[i], to->value[i],
				  draw->inverse_q31[steps])
			: raster->plane[i].dx;
	}
}

static uint32_t distance(int32_t a, int32_t b)
{
	return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

/* The same as find_spacing() of the driver's span/points.h. */
static int find_spacing(const struct draw *draw, const struct column *from,
	const struct column *to, int steps)
{
	const struct raster *raster = &draw->raster;
	int32_t a = from->by.q, b = to->by.q;
	uint32_t q = (uint32_t)(a < b ? a : b), dq = distance(a, b);
	uint64_t error, allowed = (uint64_t)q << 16;
	uint32_t most = 0;

	if (steps < PERSPECTIVE_STEP || dq == 0) {
		return steps <= SMALL_EXTENT ? steps + 1 : SOFT_RUN_PIXELS;
	}
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];
		uint32_t d = distance(to->value[i], from->value[i]);

		if (rows_is_divided(raster, i)) {
			d = i < TEX_S ? d >> rows_color_tolerance(draw) : d;
			most = d > most ? d : most;
		}
	}
	error = (uint64_t)most * dq;
	if (error <= allowed && steps <= SMALL_EXTENT) {
		return steps + 1;
	}
	return rows_find_spacing(error, allowed, steps);
}

static void row_divided(struct walk *walk, int y, int left, int right)
{
	const struct draw *draw = walk->draw;
	int steps = right - left - 1, spacing, x = left;
	struct column from = {0}, to, end;

	find_point(draw, left, &from);
	end = from;
	if (steps > 0) {
		find_point(draw, right - 1, &end);
	}
	if (draw->texture[0].used &&
		(walk->span.y < 0 || y % ROWS_OF_LEVEL == 0)) {
		walk->span.lod[0] =
			soft_rows_find_lod(&draw->raster, &from.by, 0,
				(struct texels){from.value[TEX_S],
					from.value[TEX_S + 1]});
	}
	spacing = find_spacing(draw, &from, &end, steps);
	if (spacing > steps) {
		set_steps(walk, &from, &end, steps);
		draw_linear(walk, y, left, right, from.value);
		return;
	}
	for (; right - x > spacing; x += spacing) {
		find_point(draw, x + spacing, &to);
		set_steps(walk, &from, &to, spacing);
		draw_linear(walk, y, x, x + spacing, from.value);
		from = to;
	}
	set_steps(walk, &from, &end, right - x - 1);
	draw_linear(walk, y, x, right, from.value);
}

/* Draws a row of polynomials in the same runs as the driver's walk_list.c. */
static void row_bent(struct walk *walk, int y, int left, int right)
{
	const struct raster *raster = &walk->draw->raster;
	int most = raster->bent_pixels;
	int row = y - raster->top;

	for (int x = left; x < right; x += most) {
		int count = right - x < most ? right - x : most;
		int32_t value[ATTRIBUTES];

		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			struct bent at = {(int32_t)plane_at(raster, i, x),
				raster->plane[i].dx};

			if (i >= TEX_S) {
				at = rows_find_bent(raster, i,
					raster->plane[i].start, row, x, count);
			}
			value[i] = at.value;
			walk->span.step[i] = at.step;
		}
		draw_run(walk, y, x, count, value);
	}
}

static void row_linear(struct walk *walk, int y, int left, int right)
{
	const struct raster *raster = &walk->draw->raster;
	int32_t value[ATTRIBUTES];

	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		value[i] = (int32_t)plane_at(raster, i, left);
	}
	draw_linear(walk, y, left, right, value);
}

static void skip(struct plane *plane, int rows)
{
	plane->start += (uint32_t)plane->dy * (uint32_t)rows;
}

/* Moves all plane equations in use down by that many rows. */
static void skip_rows(struct draw *draw, int rows)
{
	struct raster *raster = &draw->raster;

	for (int i = 0; i < raster->moving_count; i++) {
		skip(&raster->plane[raster->moving[i]], rows);
	}
	skip(&raster->plane[DEPTH], rows);
	if (raster->perspective) {
		skip(&raster->plane[INVERSE_W], rows);
	}
}

/* The first column whose centre is at or beyond x. */
static int column_of(int32_t x_q16)
{
	return (x_q16 + 0x7FFF) >> 16;
}

/* Moves an edge to the next row. Below its end x may wrap, but is not read. */
static void move_down(struct side *side)
{
	side->x = (int32_t)((uint32_t)side->x + (uint32_t)side->step);
}

/*
 * Calls row(walk, y, left, right) for each row that has pixels inside of
 * draw->box, and moves the plane equations on from row to row.
 */
static void walk_rows(struct walk *walk, const struct setup *setup,
	void (*row)(struct walk *walk, int y, int left, int right))
{
	struct draw *draw = walk->draw;
	const struct clip_box box = draw->box;
	int y = setup->top, end = setup->bottom, turn = setup->middle;
	struct side whole = {0}, part = {0};

	end = end < box.bottom ? end : box.bottom;
	if (y < box.top) {
		skip_rows(draw, box.top - y);
		y = box.top;
	}
	whole = raster_side(draw, setup->v[0], setup->v[2], y);
	if (y < turn) {
		part = raster_side(draw, setup->v[0], setup->v[1], y);
	}
	turn = turn > y ? turn : y;
	for (; y < end; y++) {
		int left, right;

		if (y == turn) {
			part = raster_side(draw, setup->v[1], setup->v[2], y);
		}
		left = column_of(setup->middle_left ? part.x : whole.x);
		right = column_of(setup->middle_left ? whole.x : part.x);
		left = left > box.left ? left : box.left;
		right = right < box.right ? right : box.right;
		if (left < right) {
			row(walk, y, left, right);
		}
		skip_rows(draw, 1);
		move_down(&whole);
		move_down(&part);
	}
}

void reference_fill(struct draw *draw, struct setup *setup)
{
	const struct raster *raster = &draw->raster;
	struct walk walk = {.draw = draw, .span = {.y = -1 /* no row yet */}};

	soft_raster_set_up(draw, setup);
	for (int i = RED; i <= FOG; i++) {
		walk.span.value[i] = raster->constant[i];
	}
	walk.span.step[DEPTH] = raster->plane[DEPTH].dx;
	if (!raster->perspective) {
		soft_rows_find_affine_lod(draw);
		memcpy(walk.span.lod, raster->lod, sizeof(raster->lod));
	}
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		walk.span.step[i] = raster->plane[i].dx;
	}
	walk_rows(&walk, setup,
		raster->bent                  ? row_bent
			: raster->perspective ? row_divided
					      : row_linear);
}

void reference_use(struct soft *soft, bool on)
{
	soft->fill = on ? reference_fill : NULL;
	soft->changed = GROUP_ALL;
}
