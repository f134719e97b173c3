/*
 * Chooses which frames of the reference become key frames of a morph.
 */
#ifndef APP_COMPARE_FIT_H
#define APP_COMPARE_FIT_H

#include "app/compare/screen_view.h"

/*
 * Chooses the fewest frames such that every vertex, interpolated linearly
 * between them, stays within bound_px of the reference at every frame. Writes
 * them to key, which holds up to frame_count numbers, the first and the last
 * frame among them. Returns their number, or -ENOMEM.
 *
 * It finds a shortest path over the frames. From each frame it stops after
 * eight spans in a row that exceed the bound, so it misses longer spans.
 */
int fit_keys(const struct reference *reference,
	const struct screen_view *screen, float bound_px, int *key);

/*
 * Chooses count frames at even distances, or all where there are fewer; count
 * is at least 2. Returns their number.
 */
int fit_even_keys(const struct reference *reference, int count, int *key);

#endif
