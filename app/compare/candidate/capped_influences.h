/*
 * The influences with the largest weights of a vertex, as exported with a cap.
 */
#ifndef APP_COMPARE_CANDIDATE_CAPPED_INFLUENCES_H
#define APP_COMPARE_CANDIDATE_CAPPED_INFLUENCES_H

#include "app/model/model_stats.h"

struct capped_influences {
	int count; /* entries from here on are joint 0 with weight 0 */
	uint16_t joint[MODEL_INFLUENCES_MAX];
	float weight[MODEL_INFLUENCES_MAX]; /* descending; their sum is 1 */
};

/*
 * Returns at most max influences (0: all) of a vertex of a skinned primitive.
 */
struct capped_influences capped_influences_of(
	const struct model_primitive *primitive, int vertex, int max);

#endif
