/*
 * Morphing key frames in fixed point (AN4044, section 1; app/anim/morph.h does
 * the same in float).
 *
 *   load:     fixed_range_add() for all key frames, fixed_range_placement(),
 *             fixed_key_positions() for each
 *   trigger:  fixed_lerp_prepare(count, source, destiny, pair)
 *   frame:    run/fixed_lerp.h
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_KEY_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_KEY_H

#include "app/anim/kernel/fixed.h"

/* The box around the positions of key frames. */
struct fixed_range {
	float low[3], high[3];
};

/* An empty box. */
struct fixed_range fixed_range_empty(void);

/* Extends the box by positions. */
void fixed_range_add(
	struct fixed_range *range, int count, const float (*position)[3]);

/*
 * Computes the placement for all key frames within the range. With it their
 * numbers fill 15 bits, the most that a lerp can take. Returns 0, or -ERANGE if
 * a position was not finite or not below 1e18.
 */
int fixed_range_placement(
	const struct fixed_range *range, struct fixed_placement *placement);

/* Convert a key frame's positions, and normals, in which 1 becomes 16383. */
void fixed_key_positions(int count, const float (*position)[3],
	const struct fixed_placement *placement, struct fixed_vector *out);
void fixed_key_normals(
	int count, const float (*normal)[3], struct fixed_vector *out);

/*
 * Interleaves source and destiny for the lerp. Their numbers must be within
 * -16383..16383, as those of the functions above are.
 */
void fixed_lerp_prepare(int count, const struct fixed_vector *source,
	const struct fixed_vector *destiny, struct fixed_pair (*pair)[3]);

#endif
