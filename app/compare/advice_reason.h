/*
 * Writes the reason of the advice in one sentence.
 */
#ifndef APP_COMPARE_ADVICE_REASON_H
#define APP_COMPARE_ADVICE_REASON_H

#include "app/compare/comparison.h"

/* Sets comparison->reason, without a full stop. All other members are set. */
void advice_reason_write(struct comparison *comparison);

#endif
