#include "app/compare/advice.h"

#include "app/compare/advice_plan.h"
#include "app/compare/advice_price.h"
#include "app/compare/advice_reason.h"

/* The price, in percent, must fall by this to make converting worth it. */
static const double worth_converting = 0.3;

static bool is_no_worse(const struct comparison *comparison, int row, int than)
{
	const struct comparison_total *a = &comparison->row[row].total;
	const struct comparison_total *b = &comparison->row[than].total;

	return advice_row_us(comparison, row) <=
		advice_row_us(comparison, than) &&
		a->memory_bytes <= b->memory_bytes && a->peak_px <= b->peak_px;
}

/*
 * Finds the Pareto front: rows for which no other is at least as good in
 * everything. Of equal rows, the first is on the front.
 */
static void find_front(struct comparison *comparison)
{
	for (int i = 0; i < comparison->row_count; i++) {
		struct comparison_row *row = &comparison->row[i];

		row->front = row->listed;
		for (int j = 0; j < comparison->row_count; j++) {
			if (j != i && comparison->row[j].listed &&
				is_no_worse(comparison, j, i) &&
				(j < i || !is_no_worse(comparison, i, j))) {
				row->front = false;
			}
		}
	}
}

/*
 * Whether row a is the better choice: memory is the hardest limit, since
 * without it nothing runs, then the error, then the time. If no row keeps
 * within the time, because drawing alone takes longer, prices decide as usual.
 */
static bool is_better(const struct comparison *comparison, int a, int b)
{
	const struct comparison_total *x = &comparison->row[a].total;
	const struct comparison_total *y = &comparison->row[b].total;

	if (advice_fits_memory(comparison, a) !=
		advice_fits_memory(comparison, b)) {
		return advice_fits_memory(comparison, a);
	}
	if (!advice_fits_memory(comparison, a)) {
		return x->memory_bytes < y->memory_bytes;
	}
	if (advice_fits_error(comparison, a) !=
		advice_fits_error(comparison, b)) {
		return advice_fits_error(comparison, a);
	}
	if (!advice_fits_error(comparison, a)) {
		return x->peak_px < y->peak_px;
	}
	if (advice_fits_time(comparison, a) != advice_fits_time(comparison, b)) {
		return advice_fits_time(comparison, a);
	}
	return advice_row_price(comparison, a) < advice_row_price(comparison, b) -
		(b == 0 ? worth_converting : 0.0); /* the model is row 0 */
}

static void set_limits(struct comparison *comparison)
{
	const struct comparison_request *request = &comparison->request;
	const struct board_profile *board = request->board;
	double frame_ms =
		request->frame_ms > 0.0 ? request->frame_ms : board->frame_ms;

	comparison->memory_limit_bytes = request->memory_bytes > 0
		? request->memory_bytes
		: board->ram_bytes - board->taken_bytes;
	comparison->time_limit_us = frame_ms * 1000.0;
}

void advice_give(struct comparison *comparison)
{
	int best = 0;

	set_limits(comparison);
	find_front(comparison);
	for (int i = 1; i < comparison->row_count; i++) {
		if (comparison->row[i].listed && is_better(comparison, i, best)) {
			best = i;
		}
	}
	comparison->advised = best;
	advice_plan_mix(comparison);
	advice_reason_write(comparison);
}
