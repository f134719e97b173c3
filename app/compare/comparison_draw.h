/*
 * Predicts what drawing costs the board.
 */
#ifndef APP_COMPARE_COMPARISON_DRAW_H
#define APP_COMPARE_COMPARISON_DRAW_H

#include "app/compare/comparison.h"

/*
 * Sets board.draw of all cells, whose other members are set. It draws a few
 * moments of each clip: the model with its levels of detail for row 0 and for
 * key frames, and the exported model for the other rows. Returns 0, or -errno
 * after logging an error.
 */
int comparison_draw_predict(
	struct comparison *comparison, const struct log *log);

#endif
