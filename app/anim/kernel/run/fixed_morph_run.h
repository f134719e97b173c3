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

/* Returns true if the frame's weights and the pair's deltas move vertices. */
static inline bool fixed_deltas_active(const struct fixed_deltas *deltas)
{
	return deltas->span_count > 0 &&
		(deltas->weights.a != 0 || deltas->weights.b != 0);
}

/*
 * Returns the index of the first of a pair's spans that ends after the given
 * vertex, span_count if none does. Adds the steps of the search to *steps, so
 * that board_cost.h can predict its time.
 */
static inline int fixed_deltas_find(
	const struct fixed_deltas *deltas, int vertex, int *steps)
{
	int low = 0, high = deltas->span_count;

	while (low < high) {
		int middle = low + (high - low) / 2;
		const struct fixed_span *span = &deltas->span[middle];

		if (span->first + span->count <= vertex) {
			low = middle + 1;
		} else {
			high = middle;
		}
		++*steps;
	}
	return low;
}

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
