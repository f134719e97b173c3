#include "app/character/show/character_in_place.h"

#include "app/anim/clip.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

static bool moves_root(
	const struct character *character, const struct model_channel *channel)
{
	return channel->node == character->motion.root &&
		channel->path == MODEL_TRANSLATION &&
		channel->interpolation != MODEL_STEP && !channel->constant;
}

/* A cubic key: in-tangent (per second), value, out-tangent (per second). */
static void take_from_key(
	float *key, bool cubic, const float travel[3], float passed, float rate)
{
	float *value = cubic ? key + 3 : key;

	for (int axis = 0; axis < 3; axis++) {
		value[axis] -= travel[axis] * passed;
		if (cubic) {
			key[axis] -= travel[axis] * rate;
			key[6 + axis] -= travel[axis] * rate;
		}
	}
}

/* As the states do: from the clip's first key on. */
static int take_way(const struct model_clip *clip, struct model_channel *channel,
	const float travel[3], struct arena *arena)
{
	bool cubic = channel->interpolation == MODEL_CUBICSPLINE;
	size_t size = cubic ? 9 : 3;
	size_t count = (size_t)channel->key_count;
	float *value = ARENA_ARRAY(arena, float, count *size);

	if (!value) {
		return -ENOMEM;
	}
	memcpy(value, channel->value, count * size * sizeof(*value));
	for (size_t key = 0; key < count; key++) {
		take_from_key(value + key * size, cubic, travel,
			clip_share(clip, channel->time_s[key]),
			1.0f / (clip->duration_s - clip->lead_s));
	}
	channel->value = value;
	return 0;
}

static int copy_clip(const struct character *character, int clip,
	struct model_clip *out, struct arena *arena, float *way_m)
{
	const struct character_clip *of = &character->clip[clip];
	size_t count = (size_t)out->channel_count;
	struct model_channel *channel;
	int error = 0;

	if (of->carried_m[0] == 0.0f && of->carried_m[1] == 0.0f) {
		return 0;
	}
	channel = ARENA_ARRAY(arena, struct model_channel, count);
	if (!channel) {
		return -ENOMEM;
	}
	memcpy(channel, out->channel, count * sizeof(*channel));
	out->channel = channel;
	for (size_t i = 0; i < count && !error; i++) {
		if (moves_root(character, &channel[i])) {
			*way_m = scalar_sqrt(of->carried_m[0] * of->carried_m[0] +
				of->carried_m[1] * of->carried_m[1]);
			error = take_way(out, &channel[i], of->travel, arena);
		}
	}
	return error;
}

int character_in_place(const struct character *character,
	const struct model *model, struct arena *arena, struct model *out,
	float *way_m)
{
	size_t count = (size_t)model->clip_count;
	struct model_clip *clip = ARENA_ARRAY(arena, struct model_clip, count);
	int error = 0;

	if (!clip) {
		return -ENOMEM;
	}
	memcpy(clip, model->clip, count * sizeof(*clip));
	*out = *model;
	out->clip = clip;
	for (int i = 0; i < model->clip_count && !error; i++) {
		way_m[i] = 0.0f;
		error = copy_clip(character, i, &clip[i], arena, &way_m[i]);
	}
	return error;
}
