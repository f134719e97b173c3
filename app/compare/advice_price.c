#include "app/compare/advice_price.h"

/* Where instructions are counted: those of an ARM1136 in a microsecond. */
static const double instructions_per_us = 300.0;

static double time_us(const struct comparison *comparison, double frame_us,
	double instructions, const struct board_cost *board,
	const struct board_cost *draw)
{
	switch (comparison->cost) {
	case COMPARISON_COST_INSTRUCTIONS:
		return instructions / instructions_per_us + board_cost_us(draw);
	case COMPARISON_COST_TIME:
		return frame_us + board_cost_us(draw);
	default:
		return board_cost_us(board);
	}
}

double advice_row_us(const struct comparison *comparison, int row)
{
	const struct comparison_total *total = &comparison->row[row].total;

	return time_us(comparison, total->frame_us, total->instructions,
		&total->board, &total->draw);
}

double advice_cell_us(const struct comparison *comparison, int row, int clip)
{
	const struct comparison_cell *cell = &comparison->row[row].cell[clip];
	struct board_cost board = board_frame_sum(&cell->board);

	return time_us(comparison, cell->time.frame_us, cell->time.instructions,
		&board, &cell->board.draw);
}

bool advice_fits_memory(const struct comparison *comparison, int row)
{
	return comparison->row[row].total.memory_bytes <=
		comparison->memory_limit_bytes;
}

bool advice_fits_time(const struct comparison *comparison, int row)
{
	return advice_row_us(comparison, row) <= comparison->time_limit_us;
}

bool advice_fits_error(const struct comparison *comparison, int row)
{
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
