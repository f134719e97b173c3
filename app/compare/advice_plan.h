/*
 * Mixed plans: each clip by its own technique.
 */
#ifndef APP_COMPARE_ADVICE_PLAN_H
#define APP_COMPARE_ADVICE_PLAN_H

#include "app/compare/comparison.h"

/*
 * Sets clip[].row, mixed, mixed_bytes and mixed_us. comparison->advised, the
 * limits and the cost are set.
 */
void advice_plan_mix(struct comparison *comparison);

#endif
