/*
 * One frame of a morph in fixed point.
 *
 *   fixed_morph_set_weights(&morph, weight)
 *   fixed_morph_run(&morph, loops, FIXED_POSITION, position)
 *   fixed_morph_run(&morph, loops, FIXED_NORMAL, normal)
 *   morph.placement gives positions their meaning
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_MORPH_RUN_H
#define APP_ANIM_KERNEL_RUN_FIXED_MORPH_RUN_H

#include "app/anim/kernel/layout/fixed_morph.h"

enum {
	/* Vertices whose sums of several pairs stay in the core's L1 cache. */
	FIXED_MORPH_CHUNK = 256
};

/*
 * Sets the frame's target_count weights. Weights beyond the limit raise it for
 * good, which takes about as long as a frame in float. 0, or -ERANGE for
 * weights beyond 1024 and for NaN, in which case nothing has changed.
 */
int fixed_morph_set_weights(struct fixed_morph *morph, const float *weight);

/* out = base + the sum of weight * delta, vertex_count vectors. */
void fixed_morph_run(const struct fixed_morph *morph,
	const struct fixed_loops *loops, enum fixed_attribute attribute,
	struct fixed_vector *out);

#endif
