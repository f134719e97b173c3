#include "app/compare/advice_reason.h"

#include "app/compare/advice_price.h"

#include <stdio.h>

static double kilobytes(double bytes)
{
	return bytes / 1024.0;
}

static double row_bytes(const struct comparison *comparison, int row)
{
	return (double)comparison->row[row].total.memory_bytes;
}

/* Digits after the point, so that a small figure is not printed as 0. */
static int percent_digits(double percent)
{
	return percent < 0.1 ? 2 : 1;
}

static int figure_digits(double figure)
{
	return figure < 10.0 ? 1 : 0;
}

/* The row with the least of() within all limits, not the advised one; or -1. */
static int find_least(const struct comparison *comparison,
	double (*of)(const struct comparison *comparison, int row))
{
	int best = -1;

	for (int i = 0; i < comparison->row_count; i++) {
		if (i != comparison->advised && advice_fits(comparison, i) &&
			(best < 0 || of(comparison, i) < of(comparison, best))) {
			best = i;
		}
	}
	return best;
}

/*
 * Says why a faster row is not advised: too little saved, or too much memory.
 */
static void weigh_faster(
	const struct comparison *comparison, int other, char *text, size_t size)
{
	const struct board_profile *board = comparison->request.board;
	int advised = comparison->advised;
	double saved_us = advice_row_us(comparison, advised) -
		advice_row_us(comparison, other);
	double more =
		row_bytes(comparison, other) - row_bytes(comparison, advised);
	double share = saved_us / (board->frame_ms * 10.0);

	if (advice_row_price(comparison, other) <=
		advice_row_price(comparison, advised)) {
		snprintf(text, size,
			"\"%s\" would save %.*f us, which is %.2f%% of a frame of %.1f ms and too little to convert the model for",
			comparison->row[other].name, figure_digits(saved_us),
			saved_us, share, board->frame_ms);
		return;
	}
	snprintf(text, size,
		"\"%s\" would save %.0f us, which is %.*f%% of a frame of %.1f ms, but take %.0f KiB more, where 1%% is worth %.0f KiB",
		comparison->row[other].name, saved_us, percent_digits(share),
		share, board->frame_ms, kilobytes(more),
		kilobytes((double)board->bytes_per_percent));
}

static void weigh_smaller(
	const struct comparison *comparison, int other, char *text, size_t size)
{
	const struct board_profile *board = comparison->request.board;
	int advised = comparison->advised;
	double more_us = advice_row_us(comparison, other) -
		advice_row_us(comparison, advised);
	double less =
		row_bytes(comparison, advised) - row_bytes(comparison, other);
	double share = more_us / (board->frame_ms * 10.0);

	snprintf(text, size,
		"\"%s\" would save %.0f KiB but take %.0f us more, which is %.*f%% of a frame of %.1f ms, where 1%% is worth %.0f KiB",
		comparison->row[other].name, kilobytes(less), more_us,
		percent_digits(share), share, board->frame_ms,
		kilobytes((double)board->bytes_per_percent));
}

static void write_fitting(
	const struct comparison *comparison, char *text, size_t size)
{
	int advised = comparison->advised;
	int fastest = find_least(comparison, advice_row_us);
	int smallest = find_least(comparison, row_bytes);

	if (fastest >= 0 &&
		advice_row_us(comparison, fastest) <
			advice_row_us(comparison, advised)) {
		weigh_faster(comparison, fastest, text, size);
	} else if (smallest >= 0 &&
		row_bytes(comparison, smallest) <
			row_bytes(comparison, advised)) {
		weigh_smaller(comparison, smallest, text, size);
	} else if (fastest >= 0) {
		double other_kib = kilobytes(row_bytes(comparison, fastest));

		snprintf(text, size,
			"nothing that keeps within %g px is faster or smaller; \"%s\" takes %.0f us and %.*f KiB",
			(double)comparison->request.bound_px,
			comparison->row[fastest].name,
			advice_row_us(comparison, fastest),
			figure_digits(other_kib), other_kib);
	} else {
		snprintf(text, size,
			"nothing else keeps within %g px, %.0f KiB and %.3g ms",
			(double)comparison->request.bound_px,
			kilobytes((double)comparison->memory_limit_bytes),
			comparison->time_limit_us * 1e-3);
	}
}

/* Says that no row is fast enough, often because drawing alone is not. */
static void write_slow(
	const struct comparison *comparison, char *text, size_t size)
{
	const struct comparison_total *total =
		&comparison->row[comparison->advised].total;
	double draw_ms = board_cost_us(&total->draw) * 1e-3;
	double limit_ms = comparison->time_limit_us * 1e-3;
	double px = (double)comparison->request.bound_px;

	if (draw_ms > limit_ms) {
		snprintf(text, size,
			"drawing alone takes %.1f ms, where a frame may take %.3g ms; of what keeps within %g px, it has the least price of time and memory",
			draw_ms, limit_ms, px);
		return;
	}
	snprintf(text, size,
		"nothing that keeps within %g px is as fast as %.3g ms, and it has the least price of time and memory",
		px, limit_ms);
}

static void write_failing(
	const struct comparison *comparison, char *text, size_t size)
{
	const struct comparison_total *total =
		&comparison->row[comparison->advised].total;

	if (total->memory_bytes > comparison->memory_limit_bytes) {
		snprintf(text, size,
			"nothing fits the memory of %.0f KiB, and it needs the least",
			kilobytes((double)comparison->memory_limit_bytes));
	} else if (total->peak_px > comparison->request.bound_px) {
		snprintf(text, size,
			"nothing that fits the memory of %.0f KiB keeps within %g px, and with %.2f px it comes closest",
			kilobytes((double)comparison->memory_limit_bytes),
			(double)comparison->request.bound_px,
			(double)total->peak_px);
	} else {
		write_slow(comparison, text, size);
	}
}

void advice_reason_write(struct comparison *comparison)
{
	int advised = comparison->advised;
	double memory = kilobytes(row_bytes(comparison, advised));
	char why[COMPARISON_REASON_BYTES - 64];

	if (advice_fits(comparison, advised)) {
		write_fitting(comparison, why, sizeof(why));
	} else {
		write_failing(comparison, why, sizeof(why));
	}
	snprintf(comparison->reason, sizeof(comparison->reason),
		"it takes %.0f us and %.*f KiB; %s",
		advice_row_us(comparison, advised), figure_digits(memory),
		memory, why);
}
