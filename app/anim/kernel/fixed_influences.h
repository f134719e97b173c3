/*
 * A vertex's influences with weights in 16 bits.
 */
#ifndef APP_ANIM_KERNEL_FIXED_INFLUENCES_H
#define APP_ANIM_KERNEL_FIXED_INFLUENCES_H

#include "app/anim/skin.h"

enum {
	FIXED_WEIGHT_ONE_Q14 = 16384
};

struct fixed_influences {
	int count; /* at least 1 */
	uint16_t joint[SKIN_INFLUENCES_MAX];
	int16_t weight_q14[SKIN_INFLUENCES_MAX]; /* they sum to one exactly */
};

/*
 * By descending weight, without those that are naught in Q14; at most cap of
 * them (0: all), the weights of which are scaled to sum to one.
 */
void fixed_influences_gather(const struct model_primitive *primitive,
	uint32_t vertex, int cap, struct fixed_influences *out);

/* Into the order in which a run has them: by joint. */
void fixed_influences_by_joint(struct fixed_influences *influences);

#endif
