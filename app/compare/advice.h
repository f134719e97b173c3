/*
 * Which technique to take, by a stated rule.
 *
 * Of the rows that keep within the error, the memory and the time, the advice
 * is the one with the least sum of two prices: its time as a share of the
 * board's frame, and its memory, where board_profile.bytes_per_percent are
 * worth a hundredth of the frame. So a technique that saves a hundredth of the
 * frame may take at most that much more memory.
 *
 * A mixed plan plays each clip by its own technique. It is recommended if its
 * price, with everything shared counted once, is lower than that of the best
 * row.
 */
#ifndef APP_COMPARE_ADVICE_H
#define APP_COMPARE_ADVICE_H

#include "app/compare/comparison.h"

/*
 * Sets the members that struct comparison lists under advice_give(). All cells
 * and totals must be set.
 */
void advice_give(struct comparison *comparison);

#endif
