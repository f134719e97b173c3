/*
 * Makes a time grid finer where vertices move along curves between two moments.
 */
#ifndef APP_COMPARE_MEASURE_GRID_REFINE_H
#define APP_COMPARE_MEASURE_GRID_REFINE_H

#include "app/compare/measure/screen_view.h"

/*
 * Adds moments, so that linear interpolation between two adjacent moments is
 * off by at most about bound_px. The error is estimated from the pose halfway
 * between them. It adds at most 63 moments between two, and none where a value
 * jumps. The view's box grows to contain the poses halfway. Returns 0 or
 * -ENOMEM.
 */
int grid_refine(struct reference *reference, struct screen_view *screen,
	float bound_px, struct time_grid *grid);

#endif
