#include "app/character/state/blend.h"

#include "app/anim/math/vec.h"

static void mix_turn(float *a, const float *b, float t)
{
	float x = a[0], y = a[1], z = a[2], w = a[3];
	float cosine = x * b[0] + y * b[1] + z * b[2] + w * b[3];
	float u = cosine < 0 ? -t : t, v = 1 - t;
	float length2, scale;

	x = x * v + b[0] * u;
	y = y * v + b[1] * u;
	z = z * v + b[2] * u;
	w = w * v + b[3] * u;
	length2 = x * x + y * y + z * z + w * w;
	if (length2 > 1e-12f) {
		scale = 1 / scalar_sqrt(length2);
		a[0] = x * scale;
		a[1] = y * scale;
		a[2] = z * scale;
		a[3] = w * scale;
	}
}

static void mix_weights(
	struct pose *pose, const struct pose *other, int node, float t)
{
	const struct model_node *of = &pose->model->node[node];
	int last = of->weight_offset + pose->model->mesh[of->mesh].target_count;

	for (int i = of->weight_offset; i < last; i++) {
		pose->weight[i] =
			pose->weight[i] * (1 - t) + other->weight[i] * t;
	}
}

void character_blend(struct pose *pose, const struct pose *other, float t,
	const uint8_t *differs)
{
	for (int i = 0; i < pose->node_count; i++) {
		struct transform *local = &pose->local[i];
		const struct transform *to = &other->local[i];

		if (!differs[i]) {
			continue;
		}
		pose->animated[i] = pose->animated[i] || other->animated[i];
		if (differs[i] & CHARACTER_DIFFERS_TURN) {
			mix_turn(local->rotation, to->rotation, t);
		}
		if (differs[i] & CHARACTER_DIFFERS_PLACE) {
			vec_mix(local->translation, to->translation, t,
				local->translation);
			vec_mix(local->scale, to->scale, t, local->scale);
		}
		if (differs[i] & CHARACTER_DIFFERS_WEIGHTS) {
			mix_weights(pose, other, i, t);
		}
	}
}

static uint8_t flag_of(enum model_path path)
{
	return path == MODEL_ROTATION   ? CHARACTER_DIFFERS_TURN
		: path == MODEL_WEIGHTS ? CHARACTER_DIFFERS_WEIGHTS
					: CHARACTER_DIFFERS_PLACE;
}

/* Whether the channel holds what the node has at rest. */
static bool is_at_rest(
	const struct model_channel *channel, const struct model *model)
{
	const struct transform *rest = &model->node[channel->node].rest;
	const float *value = channel->path == MODEL_TRANSLATION
		? rest->translation
		: channel->path == MODEL_ROTATION ? rest->rotation
						  : rest->scale;

	if (!channel->constant || channel->path == MODEL_WEIGHTS) {
		return false;
	}
	for (int i = 0; i < channel->width; i++) {
		if (channel->value[i] != value[i]) {
			return false;
		}
	}
	return true;
}

void character_blend_find(const struct character_state *state,
	const struct model *model, uint8_t *differs)
{
	for (int e = 0; e < state->entry_count; e++) {
		const struct model_clip *clip = state->entry[e].of->clip;

		for (int i = 0; clip && i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];

			if (!is_at_rest(channel, model)) {
				differs[channel->node] |= flag_of(channel->path);
			}
		}
	}
}
