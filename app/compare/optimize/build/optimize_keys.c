#include "app/compare/optimize/build/optimize_keys.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A constant channel has a key at 0, at the clip's end, or at both. */
static float constant_time_s(const struct optimize_keys *keys,
	const struct optimize_channel *channel, int key)
{
	return channel->ends && key == channel->kept_count - 1 ? keys->end_s
							       : 0.0f;
}

static int put_times(const struct optimize_keys *keys,
	const struct optimize_channel *channel)
{
	struct optimize_array array = {
		.count = channel->kept_count,
		.width = 1,
		.component = GLB_FLOAT,
		.bounded = true,
	};
	float *time_s = malloc((size_t)array.count * sizeof(*time_s));
	int accessor = -1;

	for (int k = 0; time_s && k < array.count; k++) {
		time_s[k] = channel->constant
			? constant_time_s(keys, channel, k)
			: channel->time_s[channel->kept[k]];
	}
	if (time_s) {
		array.value = time_s;
		accessor = optimize_output_add(
			&keys->build->output, OPTIMIZE_DATA, &array);
	}
	free(time_s);
	return accessor;
}

/*
 * Whether two successive keys are half a turn apart: after rounding, the
 * shorter way between them could be the opposite one.
 */
static bool turns_half(const struct optimize_channel *channel,
	const float *value, size_t count)
{
	if (channel->track.path != MODEL_ROTATION) {
		return false;
	}
	for (size_t i = 4; i < count; i += 4) {
		if (optimize_track_is_half_turn(value + i - 4, value + i)) {
			return true;
		}
	}
	return false;
}

/*
 * Stores rotations and weights as integers if they are within -1 to 1. *one is
 * the number that stands for 1.
 */
static void choose_component(const struct optimize_keys *keys,
	const struct optimize_channel *channel, const float *value,
	size_t count, struct optimize_array *array, float *one)
{
	bool positive = true, small = true;

	*one = channel->unit;
	array->component = (enum glb_component)channel->output.component;
	array->normalized = channel->output.normalized;
	if (array->component != GLB_FLOAT || !keys->build->plan->rotations ||
		channel->track.path == MODEL_TRANSLATION ||
		channel->track.path == MODEL_SCALE ||
		turns_half(channel, value, count)) {
		return;
	}
	for (size_t i = 0; i < count; i++) {
		positive = positive && value[i] >= 0.0f;
		small = small && value[i] >= -1.0f && value[i] <= 1.0f;
	}
	if (small) {
		array->normalized = true;
		array->component =
			positive && channel->track.path == MODEL_WEIGHTS
			? GLB_USHORT
			: GLB_SHORT;
		*one = array->component == GLB_SHORT ? 32767.0f : 65535.0f;
	}
}

static int put_values(const struct optimize_keys *keys,
	const struct optimize_channel *channel)
{
	const struct optimize_track *track = &channel->track;
	bool cubic =
		track->interpolation == MODEL_CUBICSPLINE && !channel->constant;
	size_t width = (size_t)track->width * (cubic ? 3 : 1);
	size_t count = (size_t)channel->kept_count * width;
	bool scalars = track->path == MODEL_WEIGHTS;
	struct optimize_array array = {
		.width = scalars ? 1 : track->width,
		.sparse = scalars,
	};
	float *value = malloc(count * sizeof(*value));
	int accessor = -1;
	float one;

	for (size_t i = 0; value && i < count; i++) {
		int key = channel->constant ? 0 : channel->kept[i / width];

		value[i] = cubic ? track->value[(size_t)key * width + i % width]
				 : optimize_track_value(track, key)[i % width];
	}
	if (value) {
		choose_component(keys, channel, value, count, &array, &one);
		for (size_t i = 0; array.component != GLB_FLOAT && i < count;
			i++) {
			value[i] = rintf(value[i] * one);
		}
		array.count = (int)(count / (size_t)array.width);
		array.value = value;
		accessor = optimize_output_add(
			&keys->build->output, OPTIMIZE_DATA, &array);
	}
	free(value);
	return accessor;
}

static enum model_interpolation interpolation_of(
	const struct optimize_channel *channel)
{
	return channel->constant && channel->track.interpolation != MODEL_LINEAR
		? MODEL_STEP
		: channel->track.interpolation;
}

/* Returns the sampler of an earlier channel that has the same keys, or -1. */
static int find_sampler(const struct optimize_keys *keys,
	const struct optimize_channel *channel, int bucket)
{
	for (int i = keys->bucket[bucket]; i >= 0; i = keys->channel[i].next) {
		const struct optimize_channel *known = &keys->channel[i];

		if (known->times == channel->times &&
			known->values == channel->values &&
			interpolation_of(known) == interpolation_of(channel)) {
			return known->sampler;
		}
	}
	return -1;
}

static void put_sampler(struct optimize_keys *keys,
	struct optimize_channel *channel, json_t *samplers)
{
	/* Few samplers share their values but not their times. */
	int bucket = channel->values >= 0 ? channel->values % keys->count : 0;
	json_t *sampler;

	channel->sampler = find_sampler(keys, channel, bucket);
	if (channel->sampler >= 0) {
		return;
	}
	channel->sampler = (int)json_array_size(samplers);
	channel->next = keys->bucket[bucket];
	keys->bucket[bucket] = (int)(channel - keys->channel);
	sampler = json_pack("{s:i, s:i}", "input", channel->times, "output",
		channel->values);
	if (interpolation_of(channel) != MODEL_LINEAR) {
		json_object_set_new(sampler, "interpolation",
			json_string(optimize_interpolation_name[interpolation_of(
				channel)]));
	}
	json_array_append_new(samplers, sampler);
}

/*
 * Groups channels by their times, so that the player finds a key once for all.
 */
static int compare_channels(const void *a, const void *b)
{
	const struct optimize_channel *p = a, *q = b;

	return p->times != q->times
		? (p->times > q->times) - (p->times < q->times)
		: (p->number > q->number) - (p->number < q->number);
}

static void check(struct optimize_keys *keys, int accessor)
{
	struct glb *glb = &keys->build->output.glb;

	if (accessor < 0 && !glb->error) {
		glb->error = -ENOMEM;
	}
}

/*
 * Times are added, and so numbered, first: optimizing the result again gives
 * the same order.
 */
static int put_channels(struct optimize_keys *keys)
{
	json_t *samplers = json_array(), *channels = json_array();

	for (int i = 0; i < keys->count; i++) {
		struct optimize_channel *channel = &keys->channel[i];

		if (!channel->dropped) {
			channel->times = put_times(keys, channel);
			check(keys, channel->times);
		}
	}
	qsort(keys->channel, (size_t)keys->count, sizeof(*keys->channel),
		compare_channels);
	memset(keys->bucket, 0xFF, (size_t)keys->count * sizeof(*keys->bucket));
	for (int i = 0; i < keys->count; i++) {
		struct optimize_channel *channel = &keys->channel[i];

		if (!channel->dropped) {
			channel->values = put_values(keys, channel);
			check(keys, channel->values);
			put_sampler(keys, channel, samplers);
			json_array_append_new(channels,
				json_pack("{s:i, s:O}", "sampler",
					channel->sampler, "target",
					channel->target));
		}
	}
	json_object_set_new(keys->json, "samplers", samplers);
	json_object_set_new(keys->json, "channels", channels);
	return keys->build->output.glb.error;
}

static int find_moved(struct optimize_build *build, bool *moved)
{
	json_t *animation;
	size_t i;
	int error = 0;

	json_array_foreach(
		json_object_get(build->root, "animations"), i, animation)
	{
		struct optimize_keys keys = {.count = 0};

		error = error ? error
			      : optimize_keys_read(build, animation, i, &keys);
		if (!error) {
			optimize_keys_find_moved(&keys, moved);
		}
		optimize_keys_release(&keys);
	}
	return error;
}

static int build_animation(struct optimize_build *build, json_t *animation,
	size_t index, const bool *moved)
{
	struct optimize_keys keys;
	int error = optimize_keys_read(build, animation, index, &keys);

	if (!error) {
		error = build->reach ? optimize_keys_choose(&keys, moved)
				     : optimize_keys_keep_all(&keys);
	}
	error = error ? error : put_channels(&keys);
	optimize_keys_release(&keys);
	return error;
}

int optimize_build_animations(struct optimize_build *build)
{
	json_t *animations = json_object_get(build->root, "animations");
	size_t nodes = json_array_size(json_object_get(build->root, "nodes"));
	bool *moved = calloc(4 * nodes + 4, sizeof(*moved));
	int error = moved ? 0 : -ENOMEM;
	json_t *animation;
	size_t i;

	if (!error && build->reach) {
		error = find_moved(build, moved);
	}
	json_array_foreach(animations, i, animation)
	{
		error = error ? error
			      : build_animation(build, animation, i, moved);
	}
	free(moved);
	if (error == -ENOMEM) {
		build->output.glb.error = error;
	}
	return error;
}
