/*
 * Which technique to take, by a stated rule.
 *
 * Of the rows that keep within the error, the memory and the time, the advice
 * is the one with the least sum of two prices: its time as a share of the
 * board's frame, and its memory, where board_profile.bytes_per_percent are
 * worth a hundredth of the frame. So no more memory than that is traded for
 * each hundredth of the frame that a technique saves.
 *
 * A mixed plan plays each clip by its own technique. It is recommended where
 * the sum of the prices, with everything shared counted once, is lower still.
 */
#ifndef APP_COMPARE_ADVICE_H
#define APP_COMPARE_ADVICE_H

#include "app/compare/comparison.h"

/* Sets the members of comparison that struct comparison names. */
void advice_give(struct comparison *comparison);

#endif
