/*
 * Predicts what drawing costs the board.
 */
#ifndef APP_COMPARE_COMPARISON_DRAW_H
#define APP_COMPARE_COMPARISON_DRAW_H

#include "app/compare/comparison.h"

/*
 * Sets board.draw of all cells, whose other members are set. It draws a few
 * moments of each clip, of the model and of its rigid parts, which other
 * techniques share neither vertices nor calls with. Both models are loaded for
 * that, with levels of detail as the player draws them. Returns 0, or -errno
 * after logging an error.
 */
int comparison_draw_predict(
	struct comparison *comparison, const struct log *log);

#endif
