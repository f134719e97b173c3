/*
 * Morph key frames: the fewest that keep within an error, or evenly spread.
 */
#ifndef APP_COMPARE_FIT_H
#define APP_COMPARE_FIT_H

#include "app/compare/screen_error.h"

/*
 * The fewest of the reference's frames such that every vertex, carried in a
 * straight line from key to key, stays within bound_px of the reference at
 * every frame. key takes up to frame_count frame numbers, the first and the
 * last frame among them. Returns how many, or -ENOMEM.
 *
 * A shortest path over frames: from each frame it looks on until eight spans
 * in a row have failed, so a longer span behind eight failing ones is missed.
 */
int fit_keys(const struct reference *reference, const struct screen *screen,
	float bound_px, int *key);

/* count of them, evenly spread; all frames where there are fewer. */
int spread_keys(const struct reference *reference, int count, int *key);

/* How far between two frames a third one is: 0 at from, 1 at to. */
float fit_omega(const struct reference *reference, int from, int to, int frame);

#endif
