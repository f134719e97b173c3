#include "app/compare/measure/winding.h"

#include "platform/base/interrupt.h"

#include <errno.h>
#include <stdlib.h>

static bool has_sign_of(const float value[3], const float rest[3])
{
	for (int axis = 0; axis < 3; axis++) {
		if ((value[axis] < 0.0f) != (rest[axis] < 0.0f)) {
			return false;
		}
	}
	return true;
}

/* Splines may leave the range of their keys, so they may always. */
static bool may_mirror(
	const struct model_channel *channel, const struct model *model)
{
	const float *rest = model->node[channel->node].rest.scale;

	if (channel->interpolation == MODEL_CUBICSPLINE) {
		return true;
	}
	for (int k = 0; k < channel->key_count; k++) {
		if (!has_sign_of(channel->value + 3 * k, rest)) {
			return true;
		}
	}
	return false;
}

bool winding_may_change(const struct model *model, const struct model_clip *clip)
{
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path == MODEL_SCALE &&
			may_mirror(&clip->channel[i], model)) {
			return true;
		}
	}
	return false;
}

void winding_count(struct reference *reference, const float *time_s, int count,
	int *mirrored)
{
	const struct instance *instance = reference->instance;

	for (int i = 0; i < count && !interrupt_pending(); i++) {
		reference_pose(reference, time_s[i], false);
		for (int p = 0; p < reference->part_count; p++) {
			mirrored[p] += instance_is_mirrored(instance,
				&instance->drawable[reference->part[p].drawable]);
		}
	}
}

int winding_find_turns(
	struct reference *reference, const struct time_grid *grid, bool *turns)
{
	int *mirrored;

	*turns = false;
	if (!winding_may_change(reference->model, reference->clip)) {
		return 0;
	}
	mirrored = calloc((size_t)reference->part_count, sizeof(*mirrored));
	if (!mirrored) {
		return -ENOMEM;
	}
	winding_count(reference, grid->time_s, grid->count, mirrored);
	for (int i = 0; i < reference->part_count; i++) {
		*turns = *turns ||
			(mirrored[i] > 0 && mirrored[i] < grid->count);
	}
	free(mirrored);
	return 0;
}
