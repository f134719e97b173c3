/*
 * The search for the largest key_px (optimize_build.h) with which the keys that
 * a clip keeps lead to an error within a bound. The caller builds a file, and
 * measures it, for each key_px.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_SEARCH_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_SEARCH_H

#include <stdbool.h>

/* Zeros begin a search. */
struct optimize_search {
	float good_px; /* the largest known to fit; 0: none yet */
	float bad_px;  /* the last that did not fit; 0: none yet */
	bool done;     /* the next value is less than a tenth above good_px */
};

/* Notes that key_px led to the error peak_px, and returns the next key_px. */
float optimize_search_next(struct optimize_search *search, float key_px,
	float peak_px, float bound_px);

/*
 * Makes good_px smaller if it has led to an error beyond the bound, at moments
 * that were not measured before or for other clips.
 */
void optimize_search_keep_more(
	struct optimize_search *search, float peak_px, float bound_px);

#endif
