/*
 * Finds a mixed plan, which plays each clip by its own technique.
 */
#ifndef APP_COMPARE_ADVICE_PLAN_H
#define APP_COMPARE_ADVICE_PLAN_H

#include "app/compare/comparison.h"

/*
 * Sets clip[].row, mixed, mixed_bytes and mixed_us. The caller has set advised,
 * the limits, the cells and the totals.
 */
void advice_plan_mix(struct comparison *comparison);

#endif
