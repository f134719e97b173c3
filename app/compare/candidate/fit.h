/*
 * Chooses which moments of a clip become key frames of a morph.
 */
#ifndef APP_COMPARE_CANDIDATE_FIT_H
#define APP_COMPARE_CANDIDATE_FIT_H

#include "app/compare/measure/screen_view.h"

/* The key frames of one clip: the first at its start, the last at its end. */
struct fit_keys {
	int count;
	float *time_s; /* [count], increasing */
};

/*
 * Chooses few moments of the grid as keys, such that every vertex, interpolated
 * linearly between them, stays within bound_px of the reference at every
 * moment. The key after each key is the farthest moment that fits; the search
 * ends after eight moments in a row that do not. A span between keys has at
 * most as many moments as memory_bytes hold. Returns 0, -ENOMEM or -EINTR
 * (base/interrupt.h); release with fit_keys_release().
 */
int fit_keys_within(struct reference *reference,
	const struct screen_view *screen, const struct time_grid *grid,
	float bound_px, size_t memory_bytes, struct fit_keys *out);

/*
 * Chooses count evenly spaced times; count is at least 2. Returns 0 or -ENOMEM.
 */
int fit_keys_evenly(float duration_s, int count, struct fit_keys *out);

void fit_keys_release(struct fit_keys *keys);

#endif
