#include "app/compare/optimize/optimize_search.h"

#include <math.h>

/* Aim below the bound, as the measured error is not proportional to key_px. */
static const float aim = 0.9f;
static const float step_max = 4.0f;
static const float near_enough = 1.1f;

/*
 * The next value would just reach the bound if the error were proportional to
 * it, but is at most the geometric mean of the known good and bad values.
 */
float optimize_search_next(struct optimize_search *search, float key_px,
	float peak_px, float bound_px)
{
	float most_px = aim * bound_px, next_px, middle_px;

	next_px = most_px < step_max * peak_px ? key_px * (most_px / peak_px)
					       : key_px * step_max;
	if (peak_px <= bound_px) {
		search->good_px = key_px;
	} else {
		search->bad_px = key_px;
	}
	middle_px = sqrtf(search->good_px * search->bad_px);
	if (middle_px > 0.0f &&
		(next_px > middle_px || next_px <= search->good_px)) {
		next_px = middle_px;
	}
	search->done = next_px < search->good_px * near_enough;
	return next_px;
}

/* Where few keys are left, a good_px far above the bound may have fitted. */
void optimize_search_keep_more(
	struct optimize_search *search, float peak_px, float bound_px)
{
	float most_px = aim * bound_px;

	if (peak_px > bound_px) {
		search->good_px = search->good_px < peak_px
			? search->good_px * most_px / peak_px
			: most_px;
	}
}
