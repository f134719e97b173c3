/*
 * The weights for one frame between two key frames:
 *
 *   loops->lerp(count, pair, fixed_lerp_weights(omega), temporal)
 *
 * layout/fixed_key.h makes the pairs. At omega 0 and 1 the result has the same
 * bits as the key frame. The offset of a sinusoidal curve is the same for all
 * vertices: the caller adds it to the placement's offset.
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_LERP_H
#define APP_ANIM_KERNEL_RUN_FIXED_LERP_H

#include "app/anim/kernel/fixed.h"
#include "platform/base/scalar.h"

/* The weights are omega - 1 and -omega in Q15. omega is clamped to 0..1. */
static inline struct fixed_weights fixed_lerp_weights(float omega)
{
	const int one_q15 = 32768;
	int b = (int)(scalar_clamp(omega, 0, 1) * (float)one_q15 + 0.5f);

	/* Weights are negative, as Q15 can hold -1 but not 1. */
	return (struct fixed_weights){(int16_t)(b - one_q15), (int16_t)-b};
}

#endif
