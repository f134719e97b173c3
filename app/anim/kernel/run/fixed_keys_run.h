/*
 * One frame of targets that are key frames (layout/fixed_keys.h).
 */
#ifndef APP_ANIM_KERNEL_RUN_FIXED_KEYS_RUN_H
#define APP_ANIM_KERNEL_RUN_FIXED_KEYS_RUN_H

#include "app/anim/kernel/layout/fixed_keys.h"

/* What a frame shows. */
struct fixed_keys_frame {
	bool mixed; /* more than two keys: weight is used instead of the rest */
	int source, destiny; /* of key[] */
	struct fixed_weights weights;
	const float *weight; /* [target_count], the caller's */
};

/*
 * Finds the keys of a frame from the weights of the targets, which must stay
 * valid while the frame is run. 0, or -ERANGE when a weight is larger than
 * 1024 or a NaN.
 */
int fixed_keys_find(const struct fixed_keys *keys, const float *weight,
	struct fixed_keys_frame *out);

/*
 * Writes one attribute's vertices. A mix that leaves the box around all keys is
 * clamped to twice the box.
 */
void fixed_keys_run(const struct fixed_keys *keys,
	const struct fixed_loops *loops, const struct fixed_keys_frame *frame,
	enum fixed_attribute attribute, struct fixed_vector *out);

#endif
