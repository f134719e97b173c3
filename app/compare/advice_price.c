#include "app/compare/advice_price.h"

#include "app/compare/comparison_rows.h"

double advice_row_us(const struct comparison *comparison, int row)
{
	return board_cost_us(&comparison->row[row].total.board);
}

double advice_cell_us(const struct comparison *comparison, int row, int clip)
{
	struct board_cost board =
		board_frame_sum(&comparison->row[row].cell[clip].board);

	return board_cost_us(&board);
}

bool advice_fits_memory(const struct comparison *comparison, int row)
{
	return comparison->row[row].total.memory_bytes <=
		comparison->memory_limit_bytes;
}

bool advice_is_in_time(const struct comparison *comparison, double us)
{
	/* Predictions are off by this much on average (figures.md). */
	static const double margin = 0.02;

	return us <= comparison->time_limit_us * (1.0 + margin);
}

bool advice_fits_time(const struct comparison *comparison, int row)
{
	return advice_is_in_time(comparison, advice_row_us(comparison, row));
}

bool advice_fits_error(const struct comparison *comparison, int row)
{
	for (int c = 0; c < comparison->clip_count; c++) {
		if (comparison_rows_show_inside(comparison, row, c)) {
			return false;
		}
	}
	return comparison->row[row].total.peak_px <=
		comparison->request.bound_px;
}

bool advice_fits(const struct comparison *comparison, int row)
{
	return comparison->row[row].listed &&
		advice_fits_memory(comparison, row) &&
		advice_fits_time(comparison, row) &&
		advice_fits_error(comparison, row);
}

double advice_price(const struct comparison *comparison, double us, size_t bytes)
{
	const struct board_profile *board = comparison->request.board;

	return us / (board->frame_ms * 10.0) +
		(double)bytes / (double)board->bytes_per_percent;
}

double advice_row_price(const struct comparison *comparison, int row)
{
	return advice_price(comparison, advice_row_us(comparison, row),
		comparison->row[row].total.memory_bytes);
}
