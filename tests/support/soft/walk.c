/*
 * The rows of a triangle, of any number of attributes: cut, and divided, where
 * platform/gl/soft/span/walk.c does it.
 */
#include "tests/support/soft/reference.h"

#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/walk.h"
#include "platform/gl/soft/vertex/number.h"

/* A run whose values are these, and move by the span's steps. */
static void draw_run(
	struct draw *draw, int y, int x, int count, const int32_t value[])
{
	struct raster *raster = &draw->raster;
	struct span *span = &raster->span;

	for (int n = 0; n < raster->moving_count; n++) {
		span->value[raster->moving[n]] =
			(uint32_t)value[raster->moving[n]];
	}
	span->x = x;
	span->y = y;
	span->count = count;
	span->value[DEPTH] = plane_at(raster, DEPTH, x);
	if (draw->texture[1].used && raster->perspective) {
		soft_rows_find_second(draw, 0, span);
	}
	reference_draw_span(draw, span);
}

/* Runs as long as the first texture's coordinates let them be. */
static void draw_linear(
	struct draw *draw, int y, int left, int right, int32_t value[])
{
	const struct raster *raster = &draw->raster;
	const int32_t *step = raster->span.step;
	int most = draw->texture[0].used
		? rows_find_run_pixels(draw, step[TEX_S], step[TEX_S + 1])
		: SOFT_RUN_PIXELS;

	for (int x = left;; x += most) {
		if (right - x <= most) {
			draw_run(draw, y, x, right - x, value);
			return;
		}
		draw_run(draw, y, x, most, value);
		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			value[i] = (int32_t)((uint32_t)value[i] +
				(uint32_t)step[i] * (uint32_t)most);
		}
	}
}

static void set_steps(struct draw *draw, const struct point *from,
	const struct point *to, int steps)
{
	struct raster *raster = &draw->raster;

	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		raster->span.step[i] = rows_is_divided(raster, i)
			? rows_find_step(from->value[i], to->value[i],
				  draw->inverse_q31[steps])
			: raster->plane[i].dx;
	}
}

static uint32_t distance(int32_t a, int32_t b)
{
	return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

/* As find_spacing() in walk.c. */
static int find_spacing(const struct draw *draw, const struct point *from,
	const struct point *to, int steps)
{
	const struct raster *raster = &draw->raster;
	uint32_t q = (uint32_t)(from->q < to->q ? from->q : to->q);
	uint32_t dq =
		(uint32_t)(from->q < to->q ? to->q - from->q : from->q - to->q);
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
	allowed = (allowed >> 12) * (uint32_t)(steps * steps);
	return error >> 1 <= allowed    ? SOFT_RUN_PIXELS
		: error >> 3 <= allowed ? 2 * PERSPECTIVE_STEP
					: PERSPECTIVE_STEP;
}

static void row_divided(struct draw *draw, int y, int left, int right)
{
	int steps = right - left - 1, spacing, x = left;
	struct point from, to, end;

	soft_rows_find_point(draw, left, &from);
	end = from;
	if (steps > 0) {
		soft_rows_find_point(draw, right - 1, &end);
	}
	if (draw->raster.span.y < 0 ||
		(y - draw->raster.top) % ROWS_OF_LEVEL == 0) {
		soft_rows_find_lod(draw, &from, &draw->raster.span);
	}
	spacing = find_spacing(draw, &from, &end, steps);
	if (spacing > steps) {
		set_steps(draw, &from, &end, steps);
		draw_linear(draw, y, left, right, from.value);
		return;
	}
	for (; right - x > spacing; x += spacing) {
		soft_rows_find_point(draw, x + spacing, &to);
		set_steps(draw, &from, &to, spacing);
		draw_linear(draw, y, x, x + spacing, from.value);
		from = to;
	}
	set_steps(draw, &from, &end, right - x - 1);
	draw_linear(draw, y, x, right, from.value);
}

/* A colour runs from one end to the other, both in range. */
static void place_bent(
	struct draw *draw, int name, int row, int x, int count, int32_t *value)
{
	struct raster *raster = &draw->raster;
	struct bent at = rows_find_bent(
		raster, name, raster->plane[name].start, row, x, count);

	if (name < TEX_S) {
		at = rows_limit_bent(at, count, draw->inverse_q31[count]);
	}
	*value = at.value;
	raster->span.step[name] = at.step;
}

/* As row_bent() in walk.c. */
static void row_bent(struct draw *draw, int y, int left, int right)
{
	struct raster *raster = &draw->raster;
	int most = raster->bent_pixels;
	int row = y - raster->top;

	for (int x = left; x < right; x += most) {
		int count = right - x < most ? right - x : most;
		int32_t value[ATTRIBUTES];

		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			if (rows_is_bent(raster, i)) {
				place_bent(draw, i, row, x, count, &value[i]);
			} else {
				value[i] = (int32_t)plane_at(raster, i, x);
				raster->span.step[i] = raster->plane[i].dx;
			}
		}
		draw_run(draw, y, x, count, value);
	}
}

static void row_linear(struct draw *draw, int y, int left, int right)
{
	const struct raster *raster = &draw->raster;
	int32_t value[ATTRIBUTES];

	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		value[i] = (int32_t)plane_at(raster, i, left);
	}
	draw_linear(draw, y, left, right, value);
}

void reference_fill(struct draw *draw, struct setup *setup)
{
	struct raster *raster = &draw->raster;

	rows_set_up(draw, setup);
	raster->span.y = -1; /* no row is drawn yet */
	if (raster->bent) {
		soft_rows_find_affine_lod(draw, &raster->span);
		raster_walk(draw, setup, row_bent, soft_raster_next_row);
		return;
	}
	if (raster->perspective) {
		raster_walk(draw, setup, row_divided, soft_raster_next_row);
		return;
	}
	for (int n = 0; n < raster->moving_count; n++) {
		int i = raster->moving[n];

		raster->span.step[i] = raster->plane[i].dx;
	}
	soft_rows_find_affine_lod(draw, &raster->span);
	raster_walk(draw, setup, row_linear, soft_raster_next_row);
}

void reference_use(struct soft *soft, bool on)
{
	soft->fill = on ? reference_fill : NULL;
}
