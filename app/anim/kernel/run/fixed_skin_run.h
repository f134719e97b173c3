/*
 * The morph targets of a skinned primitive in one frame, before
 * fixed_palette_make() and the skinning loop.
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_SKIN_RUN_H
#define APP_ANIM_KERNEL_RUN_FIXED_SKIN_RUN_H

#include "app/anim/kernel/layout/fixed_skin.h"

/*
 * Sets the frame's target weights, for a skin with targets, and rewrites the
 * base vectors that targets move if the weights have changed. Weights beyond
 * the limit, which is 1 at first, lay the skin out again. fixed_skin_set_cap()
 * makes all weights 0, so it is called first. 0, or -ERANGE as for
 * fixed_morph_set_weights().
 */
int fixed_skin_set_weights(struct fixed_skin *skin,
	const struct fixed_loops *loops, const float *weight);

#endif
