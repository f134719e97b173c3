/*
 * The step of a frame that applies morph targets to a skinned primitive, before
 * fixed_palette_make() and the skinning loop.
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_SKIN_RUN_H
#define APP_ANIM_KERNEL_RUN_FIXED_SKIN_RUN_H

#include "app/anim/kernel/layout/fixed_skin.h"

/*
 * Sets the frame's target weights of a skin with targets. If they have changed,
 * it rewrites the base vectors that targets move. Weights beyond the limit, 1
 * at first, make it lay the skin out again. Call fixed_skin_set_cap() before,
 * since that makes all weights 0. Returns 0, or -ERANGE as
 * fixed_morph_set_weights() does.
 */
int fixed_skin_set_weights(struct fixed_skin *skin,
	const struct fixed_loops *loops, const float *weight);

#endif
