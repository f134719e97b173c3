/*
 * Predicts what drawing costs the board.
 */
#ifndef APP_COMPARE_COMPARISON_DRAW_H
#define APP_COMPARE_COMPARISON_DRAW_H

#include "app/compare/comparison.h"

/*
 * Sets board.draw of all cells, whose other members are set. It draws a few
 * moments of each clip: of the model, which has its levels of detail, for
 * itself and for key frames; for the other rows, of what is exported. Returns
 * 0, or -errno after logging an error.
 */
int comparison_draw_predict(
	struct comparison *comparison, const struct log *log);

#endif
