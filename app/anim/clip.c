#include "app/anim/clip.h"

#include "app/anim/transform.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

int clip_cursor_init(struct clip_cursor *cursor, const struct model *model,
	struct arena *arena)
{
	int most = 0;

	for (int i = 0; i < model->clip_count; i++) {
		int count = model->clip[i].channel_count;

		most = count > most ? count : most;
	}
	cursor->channel_count = most;
	cursor->key = ARENA_ARRAY(arena, int, (size_t)most);
	return cursor->key ? 0 : -ENOMEM;
}

static bool holds(const struct model_channel *channel, int key, float time_s)
{
	return key >= 0 && key < channel->key_count - 1 &&
		channel->time_s[key] <= time_s &&
		time_s < channel->time_s[key + 1];
}

static int search_key(const struct model_channel *channel, float time_s)
{
	int low = 0;
	int high = channel->key_count - 1;

	/* time_s[low] <= time_s < time_s[high] */
	while (high - low > 1) {
		int middle = low + (high - low) / 2;

		if (channel->time_s[middle] <= time_s) {
			low = middle;
		} else {
			high = middle;
		}
	}
	return low;
}

/*
 * The key at or before time_s, which is inside the channel's range. Playing
 * on, either way, finds it among the cached key and its neighbours.
 */
static int find_key(
	const struct model_channel *channel, float time_s, int cached)
{
	if (holds(channel, cached, time_s)) {
		return cached;
	}
	/* Compared first, as any content of the cache is valid. */
	if (cached >= 0 && cached < channel->key_count) {
		if (holds(channel, cached + 1, time_s)) {
			return cached + 1;
		}
		if (holds(channel, cached - 1, time_s)) {
			return cached - 1;
		}
	}
	return search_key(channel, time_s);
}

static const float *key_value(const struct model_channel *channel, int key)
{
	size_t width = (size_t)channel->width;

	if (channel->interpolation == MODEL_CUBICSPLINE) {
		return channel->value + (3 * (size_t)key + 1) * width;
	}
	return channel->value + (size_t)key * width;
}

/* glTF 2.0, appendix C.5; tangents are per second, hence the interval. */
static void sample_cubic(const struct model_channel *channel, int key, float u,
	float interval_s, float *out)
{
	int width = channel->width;
	const float *from = key_value(channel, key);
	const float *to = key_value(channel, key + 1);
	const float *out_tangent = from + width;
	const float *in_tangent = to - width;
	float u2 = u * u;
	float u3 = u2 * u;
	float to_factor = 3 * u2 - 2 * u3;
	float from_factor = 1 - to_factor;
	float out_factor = (u3 - 2 * u2 + u) * interval_s;
	float in_factor = (u3 - u2) * interval_s;

	for (int i = 0; i < width; i++) {
		out[i] = from[i] * from_factor + out_tangent[i] * out_factor +
			to[i] * to_factor + in_tangent[i] * in_factor;
	}
}

static void sample_linear(
	const struct model_channel *channel, int key, float u, float *out)
{
	const float *from = key_value(channel, key);
	const float *to = key_value(channel, key + 1);

	if (channel->path == MODEL_ROTATION) {
		quat_slerp(from, to, u, out);
		return;
	}
	for (int i = 0; i < channel->width; i++) {
		out[i] = from[i] * (1 - u) + to[i] * u;
	}
}

static void sample_key(const struct model_channel *channel, int key, float *out)
{
	memcpy(out, key_value(channel, key),
		(size_t)channel->width * sizeof(*out));
}

void clip_sample_channel(
	const struct model_channel *channel, float time_s, int *key, float *out)
{
	int last = channel->key_count - 1;

	/* Written so that a NaN takes the first key. */
	if (!(time_s > channel->time_s[0])) {
		*key = 0;
		sample_key(channel, 0, out);
	} else if (time_s >= channel->time_s[last]) {
		*key = last;
		sample_key(channel, last, out);
	} else {
		float start_s, interval_s, u;

		*key = find_key(channel, time_s, *key);
		start_s = channel->time_s[*key];
		interval_s = channel->time_s[*key + 1] - start_s;
		u = (time_s - start_s) / interval_s;
		switch (channel->interpolation) {
		case MODEL_STEP:
			sample_key(channel, *key, out);
			break;
		case MODEL_LINEAR:
			sample_linear(channel, *key, u, out);
			break;
		case MODEL_CUBICSPLINE:
			sample_cubic(channel, *key, u, interval_s, out);
			break;
		}
	}
	if (channel->path == MODEL_ROTATION) {
		quat_normalize(out);
	}
}

/* Where the channel's value belongs; the model's loader checked the bounds. */
static float *channel_target(
	const struct model_channel *channel, struct pose *pose)
{
	struct transform *local = &pose->local[channel->node];

	switch (channel->path) {
	case MODEL_TRANSLATION:
		return local->translation;
	case MODEL_ROTATION:
		return local->rotation;
	case MODEL_SCALE:
		return local->scale;
	case MODEL_WEIGHTS:
		break;
	}
	return pose->weight + pose->model->node[channel->node].weight_offset;
}

void clip_sample(const struct model_clip *clip, float time_s,
	struct clip_cursor *cursor, struct pose *pose)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		int start = 0;
		int *key = i < cursor->channel_count ? &cursor->key[i] : &start;

		clip_sample_channel(
			channel, time_s, key, channel_target(channel, pose));
		if (channel->path != MODEL_WEIGHTS) {
			pose->animated[channel->node] = true;
		}
	}
}

/* time_s modulo period_s, in 0..period_s without its end. */
static double wrap(double time_s, double period_s)
{
	double turns = time_s / period_s;
	double rest_s;

	/* Past 2^31 turns the phase is noise anyway. */
	if (!(turns > -2147483647.0 && turns < 2147483647.0)) {
		return 0;
	}
	rest_s = time_s - (double)(int32_t)turns * period_s;
	rest_s = rest_s < 0 ? rest_s + period_s : rest_s;
	return rest_s < period_s ? rest_s : 0;
}

float clip_time(double time_s, float duration_s, enum clip_repeat repeat)
{
	if (!(duration_s > 0)) {
		return 0;
	}
	if (repeat == CLIP_LOOP) {
		float wrapped = (float)wrap(time_s, duration_s);

		return wrapped < duration_s ? wrapped : 0;
	}
	if (time_s > (double)duration_s) {
		return duration_s;
	}
	return time_s > 0 ? (float)time_s : 0;
}
