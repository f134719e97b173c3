/*
 * Which techniques are compared on a model, and their sums over its clips.
 */
#ifndef APP_COMPARE_COMPARISON_ROWS_H
#define APP_COMPARE_COMPARISON_ROWS_H

#include "app/compare/comparison.h"

/* Fills comparison->row with names, kinds and settings. 0 or -ENOMEM. */
int comparison_rows_choose(struct comparison *comparison);

/* Sums up the measured cells of all rows; names the morphs by their keys. */
void comparison_rows_sum_up(struct comparison *comparison);

#endif
