#include "app/model/model_keys.h"

#include "app/model/model_deltas.h"

static const float tolerance = 1e-5f;

/*
 * The shapes that two neighbouring keys show together: up to two targets and,
 * if the weights of a key sum to less than 1, the mesh without targets (base).
 */
struct shown {
	int target[2]; /* numbers of the first two targets */
	int target_count;
	bool base;
};

/*
 * Adds the shapes that one key shows. Returns false for a third target, and for
 * weights that are negative or sum to more than 1.
 */
static bool add_key(struct shown *shown, const float *weight, int count)
{
	float sum = 0.0f;

	for (int t = 0; t < count; t++) {
		sum += weight[t];
		if (weight[t] < -tolerance) {
			return false;
		}
		if (weight[t] <= tolerance ||
			(shown->target_count > 0 && shown->target[0] == t) ||
			(shown->target_count > 1 && shown->target[1] == t)) {
			continue;
		}
		if (shown->target_count == 2) {
			return false;
		}
		shown->target[shown->target_count++] = t;
	}
	shown->base = shown->base || sum < 1.0f - tolerance;
	return sum <= 1.0f + tolerance;
}

/* Whether the channel shows a mix of at most two shapes at each moment. */
static bool has_key_weights(const struct model_channel *channel)
{
	int width = channel->width;
	bool steps = channel->interpolation == MODEL_STEP;

	if (channel->interpolation == MODEL_CUBICSPLINE) {
		return false;
	}
	for (int k = 0; k < channel->key_count; k++) {
		const float *weight = channel->value + (size_t)k * (size_t)width;
		struct shown shown = {.target_count = 0};
		bool last = k + 1 == channel->key_count;

		if (!add_key(&shown, weight, width) ||
			(!steps && !last &&
				!add_key(&shown, weight + width, width)) ||
			shown.target_count + shown.base > 2) {
			return false;
		}
	}
	return true;
}

/*
 * Whether each clip that has weights for the node has such weights, and at
 * least one clip has any.
 */
static bool clips_have_key_weights(const struct model *model, int node)
{
	bool found = false;

	for (int c = 0; c < model->clip_count; c++) {
		const struct model_clip *clip = &model->clip[c];

		for (int i = 0; i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];

			if (channel->node != node ||
				channel->path != MODEL_WEIGHTS) {
				continue;
			}
			if (!has_key_weights(channel)) {
				return false;
			}
			found = true;
		}
	}
	return found;
}

static long count_moved(const struct model_primitive *primitive, int target)
{
	const struct model_target *deltas = &primitive->target[target];
	long moved = 0;

	for (int v = 0; v < primitive->vertex_count; v++) {
		moved += model_deltas_moves(&deltas->position, v) ||
			model_deltas_moves(&deltas->normal, v);
	}
	return moved;
}

static bool moves_half(const struct model_mesh *mesh)
{
	double moved = 0.0, total = 0.0;

	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		for (int t = 0; t < mesh->target_count; t++) {
			moved += (double)count_moved(primitive, t);
			total += (double)primitive->vertex_count;
		}
	}
	return moved >= 0.5 * total;
}

bool model_has_key_frames(const struct model *model, int node)
{
	int mesh = model->node[node].mesh;

	return mesh >= 0 && model->mesh[mesh].target_count > 1 &&
		clips_have_key_weights(model, node) &&
		(model->mesh[mesh].key_frames || moves_half(&model->mesh[mesh]));
}
