/*
 * A vertex's influences with weights in 16 bits.
 */
#ifndef APP_ANIM_KERNEL_LAYOUT_FIXED_INFLUENCES_H
#define APP_ANIM_KERNEL_LAYOUT_FIXED_INFLUENCES_H

#include "app/anim/skin.h"

enum {
	FIXED_WEIGHT_ONE_Q14 = 16384
};

struct fixed_influences {
	int count; /* at least 1 */
	uint16_t joint[SKIN_INFLUENCES_MAX];
	int16_t weight_q14[SKIN_INFLUENCES_MAX]; /* their sum is exactly 1 */
};

/*
 * Writes a vertex's influences by descending weight, without those that become
 * 0 in Q14, and at most cap of them (0: all). Weights are scaled to sum to 1.
 */
void fixed_influences_gather(const struct model_primitive *primitive,
	uint32_t vertex, int cap, struct fixed_influences *out);

/* Sorts the influences by joint, which is their order within a run. */
void fixed_influences_by_joint(struct fixed_influences *influences);

#endif
