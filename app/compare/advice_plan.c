#include "app/compare/advice_plan.h"

#include "app/compare/advice_price.h"
#include "app/compare/comparison_rows.h"

/*
 * The price, in percent, must fall by this to make a second technique worth it.
 */
static const double worth_mixing = 1.0;

/* The memory of a plan, in which a morph has the keys of its clips alone. */
static size_t plan_bytes(const struct comparison *comparison)
{
	bool used[COMPARISON_ROWS_MAX] = {false};
	int keys[COMPARISON_ROWS_MAX] = {0};
	size_t bytes = 0;

	for (int c = 0; c < comparison->clip_count; c++) {
		int row = comparison->clip[c].row;
		const struct comparison_cell *cell =
			&comparison->row[row].cell[c];

		bytes += cell->bytes.own + (used[row] ? 0 : cell->bytes.shared);
		keys[row] += cell->keys.count;
		used[row] = true;
	}
	for (int row = 0; row < comparison->row_count; row++) {
		bytes += comparison_rows_weight_bytes(keys[row]);
	}
	return bytes;
}

static double plan_us(const struct comparison *comparison)
{
	double sum = 0.0;

	for (int c = 0; c < comparison->clip_count; c++) {
		sum += advice_cell_us(comparison, comparison->clip[c].row, c);
	}
	return sum / (double)comparison->clip_count;
}

static double plan_price(const struct comparison *comparison)
{
	return advice_price(
		comparison, plan_us(comparison), plan_bytes(comparison));
}

static bool cell_fits(const struct comparison *comparison, int row, int clip)
{
	return comparison->row[row].listed &&
		!comparison_rows_show_inside(comparison, row, clip) &&
		comparison->row[row].cell[clip].error.peak_px <=
		comparison->request.bound_px &&
		advice_is_in_time(
			comparison, advice_cell_us(comparison, row, clip));
}

static bool plan_fits(const struct comparison *comparison)
{
	for (int c = 0; c < comparison->clip_count; c++) {
		if (!cell_fits(comparison, comparison->clip[c].row, c)) {
			return false;
		}
	}
	return plan_bytes(comparison) <= comparison->memory_limit_bytes;
}

/* Gives the clip the row with the cheapest plan; returns whether it changed. */
static bool improve(struct comparison *comparison, int clip)
{
	int *row = &comparison->clip[clip].row;
	int best = *row, before = *row;
	double price = plan_price(comparison);

	for (int r = 0; r < comparison->row_count; r++) {
		if (!cell_fits(comparison, r, clip)) {
			continue;
		}
		*row = r;
		if (!cell_fits(comparison, best, clip) ||
			plan_price(comparison) < price) {
			best = r;
			price = plan_price(comparison);
		}
	}
	*row = best;
	return best != before;
}

static void set_all(struct comparison *comparison, int row)
{
	for (int c = 0; c < comparison->clip_count; c++) {
		comparison->clip[c].row = row;
	}
}

/* Gives clip after clip a better row, until no clip has one. */
static void improve_all(struct comparison *comparison)
{
	bool changed;

	/* It ends, as each change gives a lower price or one more clip that fits. */
	do {
		changed = false;
		for (int c = 0; c < comparison->clip_count; c++) {
			changed = improve(comparison, c) || changed;
		}
	} while (changed);
}

/* Returns the row from which improve_all() finds the cheapest plan, or -1. */
static int find_start(struct comparison *comparison)
{
	int start = -1;
	double least = 0.0;

	for (int row = 0; row < comparison->row_count; row++) {
		if (!comparison->row[row].listed) {
			continue;
		}
		set_all(comparison, row);
		improve_all(comparison);
		if (plan_fits(comparison) &&
			(start < 0 || plan_price(comparison) < least)) {
			start = row;
			least = plan_price(comparison);
		}
	}
	return start;
}

void advice_plan_mix(struct comparison *comparison)
{
	int advised = comparison->advised, start = find_start(comparison);
	double single;

	set_all(comparison, advised);
	single = plan_price(comparison);
	if (start >= 0) {
		set_all(comparison, start);
		improve_all(comparison);
		comparison->mixed = !advice_fits(comparison, advised) ||
			plan_price(comparison) < single - worth_mixing;
	}
	if (!comparison->mixed) {
		set_all(comparison, advised);
	}
	comparison->mixed_bytes = plan_bytes(comparison);
	comparison->mixed_us = plan_us(comparison);
}
