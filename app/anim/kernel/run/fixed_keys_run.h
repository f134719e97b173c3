/* Computes one frame of targets that are key frames (layout/fixed_keys.h). */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_KEYS_RUN_H
#define APP_ANIM_KERNEL_RUN_FIXED_KEYS_RUN_H

#include "app/anim/kernel/layout/fixed_keys.h"

/* What a frame shows: a lerp between two keys, or another mix of keys. */
struct fixed_keys_frame {
	bool mixed; /* a mix by weight[]; source, destiny and weights are not
		       used */
	int source, destiny; /* numbers of two keys */
	struct fixed_weights weights;
	const float *weight; /* [target_count]; the caller owns the array */
};

/*
 * Finds the keys of a frame from the targets' weights. The array must stay
 * valid until fixed_keys_run() has run. Returns 0, or -ERANGE if a weight is a
 * NaN or its magnitude is above 1024.
 */
int fixed_keys_find(const struct fixed_keys *keys, const float *weight,
	struct fixed_keys_frame *out);

/*
 * Writes one attribute of all vertices, vertex_count vectors. A mix that leaves
 * the box around all keys is clamped to a box of twice the size.
 */
void fixed_keys_run(const struct fixed_keys *keys,
	const struct fixed_loops *loops, const struct fixed_keys_frame *frame,
	enum fixed_attribute attribute, struct fixed_vector *out);

#endif
