/*
 * Clips that mirror a model: a scale below 0 reverses the winding of triangles.
 *
 * Key frames have one winding. It is right in a clip that mirrors the model all
 * the time, but not in one in which a scale changes its sign.
 */
#ifndef APP_COMPARE_MEASURE_WINDING_H
#define APP_COMPARE_MEASURE_WINDING_H

#include "app/compare/measure/reference.h"
#include "app/compare/measure/time_grid.h"

/*
 * Returns false if the winding surely is that of the rest pose throughout the
 * clip.
 */
bool winding_may_change(
	const struct model *model, const struct model_clip *clip);

/*
 * Adds to mirrored, [part_count], at how many of the times each part's winding
 * is reversed. Leaves the reference in any pose.
 */
void winding_count(struct reference *reference, const float *time_s, int count,
	int *mirrored);

/*
 * Finds out whether some part's winding is reversed at some moments of the grid
 * but not at all of them. Returns 0 or -ENOMEM without a message.
 */
int winding_find_turns(
	struct reference *reference, const struct time_grid *grid, bool *turns);

#endif
