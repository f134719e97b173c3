/*
 * One channel of an animation, and which of its keys suffice.
 */
#ifndef APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_TRACK_H
#define APP_COMPARE_OPTIMIZE_BUILD_OPTIMIZE_TRACK_H

#include "app/compare/optimize/optimize_reach.h"
#include "app/model/model.h"

#include <stdbool.h>

struct optimize_track {
	enum model_path path;
	enum model_interpolation interpolation;
	int width, key_count;
	const float *time_s; /* [key_count] */
	const float *value;  /* as in struct model_channel */
	const struct optimize_reach_node *reach;
	float bound_px; /* the largest error of a key; 0: only of rounding */
};

/* Whether b may stand for a value a of the track. */
bool optimize_track_is_near(
	const struct optimize_track *track, const float *a, const float *b);

/* The value of a key, without tangents. */
const float *optimize_track_value(const struct optimize_track *track, int key);

/* Whether one key would do. */
bool optimize_track_is_constant(const struct optimize_track *track);

/*
 * Writes to kept the numbers of the keys that suffice for all tracks, which
 * have the same times, from the first key to the last. All of them are
 * MODEL_LINEAR or MODEL_STEP. Returns how many there are.
 */
int optimize_track_reduce(
	const struct optimize_track *const *track, int count, int *kept);

#endif
