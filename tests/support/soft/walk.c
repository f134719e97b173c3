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
	if (draw->texture[1].used && !raster->bent) {
		soft_rows_find_second(draw, 0, span);
	}
	reference_draw_span(draw, span);
}

static void draw_linear(
	struct draw *draw, int y, int left, int right, int32_t value[])
{
	const struct raster *raster = &draw->raster;

	for (int x = left;; x += SOFT_RUN_PIXELS) {
		if (right - x <= SOFT_RUN_PIXELS) {
			draw_run(draw, y, x, right - x, value);
			return;
		}
		draw_run(draw, y, x, SOFT_RUN_PIXELS, value);
		for (int n = 0; n < raster->moving_count; n++) {
			int i = raster->moving[n];

			value[i] = (int32_t)((uint32_t)value[i] +
				(uint32_t)raster->span.step[i] * SOFT_RUN_PIXELS);
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

static void row_divided(struct draw *draw, int y, int left, int right)
{
	const struct raster *raster = &draw->raster;
	int spacing =
		rows_find_spacing(raster, plane_at(raster, INVERSE_W, left),
			plane_at(raster, INVERSE_W, right - 1));
	struct point from, to;

	soft_rows_find_point(draw, left, &from);
	soft_rows_find_lod(draw, &from, &draw->raster.span);
	for (int x = left; x < right; x += spacing) {
		int next = right - x > spacing ? x + spacing : right;
		int end = next < right ? next : right - 1;

		soft_rows_find_point(draw, end, &to);
		set_steps(draw, &from, &to, end - x);
		draw_linear(draw, y, x, next, from.value);
		from = to;
	}
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
