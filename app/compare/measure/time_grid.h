/*
 * The moments of a clip between which its motion is smooth.
 *
 * They are the key times of all channels that change, and moments between them
 * where keys are far apart. Errors are measured at and between these moments,
 * and the key frames of a morph are chosen from them.
 */
#ifndef APP_COMPARE_MEASURE_TIME_GRID_H
#define APP_COMPARE_MEASURE_TIME_GRID_H

#include "app/model/model.h"

struct time_grid {
	int count;     /* at least 2 */
	float *time_s; /* [count], increasing, from 0 to the clip's end */
	bool thinned;  /* by time_grid_thin() */
};

/*
 * Two moments are at most 1/60 s apart; of keys closer than 1/80 s only one
 * becomes a moment. A key at which a value jumps always becomes a moment, and
 * so does the last float before its time. The clip's duration must be above 0.
 * Returns 0, -E2BIG when the clip lasts longer than five hours, or -ENOMEM. The
 * caller releases the grid with time_grid_release().
 */
int time_grid_make(const struct model_clip *clip, struct time_grid *out);

/*
 * Adds count moments within the clip in any order; times that the grid has
 * already are left out. If the grid is empty, count is not 0. Returns 0 or
 * -ENOMEM.
 */
int time_grid_add(struct time_grid *grid, const float *time_s, int count);

/*
 * Keeps a share of the intervals between moments, spread evenly over the clip,
 * and both ends of the clip. What is left out becomes gaps.
 */
void time_grid_thin(struct time_grid *grid, double share);

/* Whether time_grid_thin() left out what is between moment i and the next. */
bool time_grid_is_gap(const struct time_grid *grid, int i);

void time_grid_release(struct time_grid *grid);

#endif
