/*
 * Makes a time grid finer where vertices move along a curve between two moments.
 */
#ifndef APP_COMPARE_MEASURE_GRID_REFINE_H
#define APP_COMPARE_MEASURE_GRID_REFINE_H

#include "app/compare/measure/screen_view.h"

/*
 * Adds moments, so that the straight line between two moments next to each
 * other is off by at most about bound_px, as far as the middle between them
 * tells; at most 63 moments between two, and none where a value jumps. The
 * view's box grows to contain the middles. Returns 0 or -ENOMEM.
 */
int grid_refine(struct reference *reference, struct screen_view *screen,
	float bound_px, struct time_grid *grid);

#endif
