/*
 * Reduces the keys of one channel of an animation.
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
	float bound_px; /* the largest error; 0: only rounding */
};

/* Whether b is close enough to replace a value a of the track. */
bool optimize_track_is_near(
	const struct optimize_track *track, const float *a, const float *b);

/* The value of a key, without tangents. */
const float *optimize_track_value(const struct optimize_track *track, int key);

/*
 * Whether two rotations are half a turn apart: rounding decides which way a
 * player takes between them.
 */
bool optimize_track_is_half_turn(const float a[4], const float b[4]);

/* Whether all keys are close enough to the first one, so that it suffices. */
bool optimize_track_is_constant(const struct optimize_track *track);

/*
 * Writes to kept the indices of the keys that suffice for all count tracks,
 * including the first and the last key, and returns their number. Keys that are
 * left out bring no two rotations half a turn apart. The tracks
 * have the same times and are all MODEL_LINEAR or all MODEL_STEP.
 */
int optimize_track_reduce(
	const struct optimize_track *const *track, int count, int *kept);

#endif
