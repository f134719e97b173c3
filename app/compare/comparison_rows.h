/*
 * Which techniques are compared on a model, and their sums over its clips.
 */
#ifndef APP_COMPARE_COMPARISON_ROWS_H
#define APP_COMPARE_COMPARISON_ROWS_H

#include "app/compare/comparison.h"

/* Sets the names, kinds and settings of all rows. Returns 0 or -ENOMEM. */
int comparison_rows_choose(struct comparison *comparison);

/*
 * Returns the memory of a morph's weights: at each key, one for every key frame
 * of all clips.
 */
size_t comparison_rows_weight_bytes(int key_count);

/* Sums up the cells of all rows; names morphs by their number of keys. */
void comparison_rows_sum_up(struct comparison *comparison);

/* Whether the row is a morph, which draws key frames. */
bool comparison_rows_is_morph(const struct comparison_row *row);

/* Whether the row shows a clip's surfaces from inside for a part of the time. */
bool comparison_rows_show_inside(
	const struct comparison *comparison, int row, int clip);

#endif
