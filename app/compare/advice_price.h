/*
 * What a row of a comparison costs, and whether it keeps within the limits.
 *
 * The caller has set memory_limit_bytes and time_limit_us.
 */
#ifndef APP_COMPARE_ADVICE_PRICE_H
#define APP_COMPARE_ADVICE_PRICE_H

#include "app/compare/comparison.h"

/*
 * The predicted time of a whole frame on the board, in microseconds: the mean
 * of a row's clips, or of one clip. Times measured on this machine are not
 * used, because they differ from run to run.
 */
double advice_row_us(const struct comparison *comparison, int row);
double advice_cell_us(const struct comparison *comparison, int row, int clip);

/* Whether a time is at most the limit plus 2%, as predictions are not exact. */
bool advice_is_in_time(const struct comparison *comparison, double us);

/* Whether a row keeps within one limit. */
bool advice_fits_memory(const struct comparison *comparison, int row);
bool advice_fits_time(const struct comparison *comparison, int row);
bool advice_fits_error(const struct comparison *comparison, int row);

/* Whether a row is listed and keeps within all limits. */
bool advice_fits(const struct comparison *comparison, int row);

/* The sum of the prices of time and memory, in percent of the board's frame. */
double advice_price(
	const struct comparison *comparison, double us, size_t bytes);
double advice_row_price(const struct comparison *comparison, int row);

#endif
