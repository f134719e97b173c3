#include "app/compare/candidate/capped_influences.h"

static void insert(struct capped_influences *kept, uint16_t joint, float weight)
{
	int at = kept->count++;

	while (at > 0 && kept->weight[at - 1] < weight) {
		kept->joint[at] = kept->joint[at - 1];
		kept->weight[at] = kept->weight[at - 1];
		at--;
	}
	kept->joint[at] = joint;
	kept->weight[at] = weight;
}

struct capped_influences capped_influences_of(
	const struct model_primitive *primitive, int vertex, int max)
{
	struct capped_influences kept = {.count = 0};
	size_t first = (size_t)vertex * (size_t)primitive->influences;
	float sum = 0.0f;

	for (int i = 0; i < primitive->influences; i++) {
		if (primitive->weight[first + (size_t)i] > 0.0f) {
			insert(&kept, primitive->joint[first + (size_t)i],
				primitive->weight[first + (size_t)i]);
		}
	}
	kept.count = max > 0 && kept.count > max ? max : kept.count;
	for (int i = 0; i < kept.count; i++) {
		sum += kept.weight[i];
	}
	for (int i = 0; i < MODEL_INFLUENCES_MAX; i++) {
		bool used = i < kept.count;

		kept.weight[i] = used ? kept.weight[i] / sum : 0.0f;
		kept.joint[i] = used ? kept.joint[i] : 0;
	}
	return kept;
}
