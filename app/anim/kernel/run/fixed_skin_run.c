#include "app/anim/kernel/run/fixed_skin_run.h"

#include "app/anim/kernel/run/fixed_morph_run.h"

#include <string.h>

int fixed_skin_set_weights(struct fixed_skin *skin,
	const struct fixed_loops *loops, const float *weight)
{
	struct fixed_skin_targets *targets = &skin->targets;
	size_t size =
		(size_t)targets->deltas.target_count * sizeof(*targets->weight);
	float limit = targets->deltas.weight_limit;
	int error;

	if (memcmp(targets->weight, weight, size) == 0) {
		return 0;
	}
	error = fixed_morph_set_weights(&targets->deltas, weight);
	if (error) {
		return error;
	}
	if (targets->deltas.weight_limit > limit) {
		fixed_skin_extend_weights(skin, limit);
	}
	memcpy(targets->weight, weight, size);
	for (int a = 0; a < FIXED_ATTRIBUTES; a++) {
		if (targets->rebase[a]) {
			fixed_morph_run(&targets->deltas, loops,
				(enum fixed_attribute)a, targets->delta);
			loops->rebase(targets->rebase_count, targets->rebase[a],
				targets->delta, skin->base[a]);
		}
	}
	return 0;
}
