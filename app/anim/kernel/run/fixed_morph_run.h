/*
 * Computes one frame of a morph in fixed point.
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
	/*
	 * How many vertices several pairs are added to at a time, so that the
	 * sums stay in the L1 cache.
	 */
	FIXED_MORPH_CHUNK = 256
};

/*
 * Sets the frame's target_count weights. Weights beyond weight_limit raise this
 * limit for good, which takes about as long as a frame in float. Returns 0, or
 * -ERANGE if a weight is a NaN or its magnitude is above 1024; then nothing has
 * changed.
 */
int fixed_morph_set_weights(struct fixed_morph *morph, const float *weight);

/*
 * out = base + the sum of weight * delta, for vertex_count vectors. out must
 * not be morph's base.
 */
void fixed_morph_run(const struct fixed_morph *morph,
	const struct fixed_loops *loops, enum fixed_attribute attribute,
	struct fixed_vector *out);

#endif
