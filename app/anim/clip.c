#include "app/anim/clip.h"

#include "app/anim/transform.h"
#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

static const char *const INTERPOLATION_NAME[] = {
	[CLIP_AUTO] = "auto",
	[CLIP_NEAREST] = "nearest",
	[CLIP_STEP] = "step",
	[CLIP_LINEAR] = "linear",
	[CLIP_CUBIC] = "cubic",
};

const char *clip_interpolation_name(enum clip_interpolation interpolation)
{
	return INTERPOLATION_NAME[interpolation];
}

int clip_interpolation_find(const char *name)
{
	for (size_t i = 0; i < ARRAY_COUNT(INTERPOLATION_NAME); i++) {
		if (strcmp(INTERPOLATION_NAME[i], name) == 0) {
			return (int)i;
		}
	}
	return -1;
}

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

/* The four Hermite weights at u of an interval; glTF 2.0, appendix C.5. */
struct hermite {
	float from, out_tangent, to, in_tangent;
};

/* Tangents are per second, hence the interval. */
static struct hermite hermite_at(float u, float interval_s)
{
	float u2 = u * u;
	float u3 = u2 * u;
	float to = 3 * u2 - 2 * u3;

	return (struct hermite){
		.from = 1 - to,
		.out_tangent = (u3 - 2 * u2 + u) * interval_s,
		.to = to,
		.in_tangent = (u3 - u2) * interval_s,
	};
}

static void sample_tangents(
	const struct model_channel *channel, int key, float u, float *out)
{
	float interval_s = channel->time_s[key + 1] - channel->time_s[key];
	struct hermite h = hermite_at(u, interval_s);
	int width = channel->width;
	const float *from = key_value(channel, key);
	const float *to = key_value(channel, key + 1);
	const float *out_tangent = from + width;
	const float *in_tangent = to - width;

	for (int i = 0; i < width; i++) {
		out[i] = from[i] * h.from + out_tangent[i] * h.out_tangent +
			to[i] * h.to + in_tangent[i] * h.in_tangent;
	}
}

/* -1 where a rotation key has to change sign to be on the other's side. */
static float side_of(
	const struct model_channel *channel, const float *key, const float *of)
{
	if (channel->path != MODEL_ROTATION) {
		return 1;
	}
	return vec_dot(key, of) + key[3] * of[3] < 0 ? -1 : 1;
}

/* At the ends, where a neighbour is missing, the key takes its place. */
static void sample_catmull_rom(
	const struct model_channel *channel, int key, float u, float *out)
{
	int before = key > 0 ? key - 1 : key;
	int after = key + 2 < channel->key_count ? key + 2 : key + 1;
	const float *time_s = channel->time_s;
	struct hermite h = hermite_at(u, time_s[key + 1] - time_s[key]);
	const float *p0 = key_value(channel, before);
	const float *p1 = key_value(channel, key);
	const float *p2 = key_value(channel, key + 1);
	const float *p3 = key_value(channel, after);
	float side0 = side_of(channel, p0, p1);
	float side2 = side_of(channel, p2, p1);
	float side3 = side_of(channel, p3, p2) * side2;
	float out_rate = h.out_tangent / (time_s[key + 1] - time_s[before]);
	float in_rate = h.in_tangent / (time_s[after] - time_s[key]);

	for (int i = 0; i < channel->width; i++) {
		float to = side2 * p2[i];

		out[i] = p1[i] * h.from + to * h.to +
			(to - side0 * p0[i]) * out_rate +
			(side3 * p3[i] - p1[i]) * in_rate;
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

static enum clip_interpolation own_interpolation(
	const struct model_channel *channel)
{
	switch (channel->interpolation) {
	case MODEL_STEP:
		return CLIP_STEP;
	case MODEL_LINEAR:
		return CLIP_LINEAR;
	case MODEL_CUBICSPLINE:
		break;
	}
	return CLIP_CUBIC;
}

/* time_s is at or after the key and before the next one. */
static void sample_between(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int key, float *out)
{
	float start_s = channel->time_s[key];
	float u = (time_s - start_s) / (channel->time_s[key + 1] - start_s);

	if (interpolation == CLIP_AUTO) {
		interpolation = own_interpolation(channel);
	}
	switch (interpolation) {
	case CLIP_AUTO:
	case CLIP_STEP:
		sample_key(channel, key, out);
		break;
	case CLIP_NEAREST:
		sample_key(channel, u < 0.5f ? key : key + 1, out);
		break;
	case CLIP_LINEAR:
		sample_linear(channel, key, u, out);
		break;
	case CLIP_CUBIC:
		if (channel->interpolation == MODEL_CUBICSPLINE) {
			sample_tangents(channel, key, u, out);
		} else {
			sample_catmull_rom(channel, key, u, out);
		}
		if (channel->path == MODEL_ROTATION) {
			quat_normalize(out);
		}
		break;
	}
}

void clip_sample_channel(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int *key, float *out)
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
		*key = find_key(channel, time_s, *key);
		sample_between(channel, time_s, interpolation, *key, out);
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
	clip_sample_as(clip, time_s, CLIP_AUTO, cursor, pose);
}

void clip_sample_as(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose)
{
	for (int i = 0; i < clip->channel_count; i++) {
		const struct model_channel *channel = &clip->channel[i];
		int start = 0;
		int *key = i < cursor->channel_count ? &cursor->key[i] : &start;

		clip_sample_channel(channel, time_s, interpolation, key,
			channel_target(channel, pose));
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
	if (repeat == CLIP_PING_PONG) {
		double there_and_back_s = 2.0 * duration_s;
		double phase_s = wrap(time_s, there_and_back_s);

		return (float)(phase_s <= duration_s
				? phase_s
				: there_and_back_s - phase_s);
	}
	if (time_s > (double)duration_s) {
		return duration_s;
	}
	return time_s > 0 ? (float)time_s : 0;
}
