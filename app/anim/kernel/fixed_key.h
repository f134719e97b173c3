/*
 * Key frames in fixed point, and the way from one to the next (AN4044,
 * section 1; app/anim/morph.h is the same in float).
 *
 *   load:     fixed_range_of() over all key frames, fixed_key_positions() each
 *   trigger:  fixed_lerp_prepare(count, temporal, destiny, pair)
 *   frame:    loops->lerp(count, pair, fixed_lerp_weights(omega), temporal)
 *
 * At omega 0 and 1 the lerp gives its key frames' bits. A sinusoidal curve's
 * offset is the same for all vertices: add it to the placement's.
 */
#ifndef APP_ANIM_KERNEL_FIXED_KEY_H
#define APP_ANIM_KERNEL_FIXED_KEY_H

#include "app/anim/kernel/fixed.h"

/* A box that grows. */
struct fixed_range {
	float low[3], high[3];
};

/* An empty box. */
struct fixed_range fixed_range_empty(void);

/* Takes positions into the box. */
void fixed_range_add(
	struct fixed_range *range, int count, const float (*position)[3]);

/*
 * What all key frames within the range are written with: it fills 15 bits, of
 * which a lerp makes the most. 0, or -ERANGE for what are not finite numbers
 * of sensible size.
 */
int fixed_range_placement(
	const struct fixed_range *range, struct fixed_placement *placement);

/* A key frame's positions, and its normals with 16383 for 1. */
void fixed_key_positions(int count, const float (*position)[3],
	const struct fixed_placement *placement, struct fixed_vector *out);
void fixed_key_normals(
	int count, const float (*normal)[3], struct fixed_vector *out);

/*
 * Source and destiny, interleaved for the lerp, of which both numbers have to
 * be within -16383..16383, as those above are.
 */
void fixed_lerp_prepare(int count, const struct fixed_vector *source,
	const struct fixed_vector *destiny, struct fixed_pair (*pair)[3]);

/* omega is clamped to 0..1. */
struct fixed_weights fixed_lerp_weights(float omega);

/*
 * By frames (1.2.2): each of frame_count updates goes on by the same step,
 * and the last one arrives exactly. Steps are rounded, so that on the way it
 * may be up to half a bit a frame off the straight line; where that matters,
 * the lerp is the better way.
 */
struct fixed_walk {
	int vertex_count;
	int frames_left;
	const struct fixed_vector *destiny; /* not owned */
	struct fixed_vector *step;          /* [vertex_count], the caller's */
};

/* Sets out from temporal; frame_count below 1 arrives at the next update. */
void fixed_walk_begin(struct fixed_walk *walk,
	const struct fixed_vector *temporal, const struct fixed_vector *destiny,
	int frame_count);

/* One frame. Returns true when temporal changed, false once it has arrived. */
bool fixed_walk_update(struct fixed_walk *walk, const struct fixed_loops *loops,
	struct fixed_vector *temporal);

#endif
