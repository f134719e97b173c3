/*
 * The errors of one clip that have been measured, so that equal keys are
 * measured once: a search builds the same keys again and again.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_KNOWN_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_KNOWN_H

#include "app/model/model.h"

enum {
	OPTIMIZE_KNOWN_MAX = 16
};

/* Zeros are an empty list. */
struct optimize_known {
	int count;
	uint64_t stamp[OPTIMIZE_KNOWN_MAX];
	float peak_px[OPTIMIZE_KNOWN_MAX];
};

/*
 * Returns a number that differs, but for a chance of 1 in 2^64, between models
 * with the same vertices whose nodes or clip (-1: none) pose them differently.
 */
uint64_t optimize_known_stamp(const struct model *model, int clip);

/* Whether the stamp has been measured; *peak_px is then its error. */
bool optimize_known_find(
	const struct optimize_known *known, uint64_t stamp, float *peak_px);

/* Adds an error, or replaces the last one of a full list. */
void optimize_known_add(
	struct optimize_known *known, uint64_t stamp, float peak_px);

#endif
