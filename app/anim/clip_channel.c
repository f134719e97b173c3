#include "app/anim/clip_channel.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"

#include <string.h>

float *clip_channel_target(
	const struct model_channel *channel, struct pose *pose)
{
	if (channel->path == MODEL_WEIGHTS) {
		return pose->weight +
			pose->model->node[channel->node].weight_offset;
	}
	pose->animated[channel->node] = true;
	return (float *)((char *)pose->local + clip_channel_offset(channel));
}

static int search_key(const struct model_channel *channel, float time_s)
{
	int low = 0;
	int high = channel->key_count - 1;

	/* Invariant: time_s[low] <= time_s < time_s[high]. */
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
 * Returns the last key that is not after time_s, which lies between the first
 * key and the last. In a playback backward this is mostly the one before the
 * cached key; clip_moment_find() has tried that key and the next one.
 */
static int find_key(
	const struct model_channel *channel, float time_s, int cached)
{
	const float *times = channel->time_s;

	if (cached > 0 && cached < channel->key_count &&
		times[cached - 1] <= time_s && time_s < times[cached]) {
		return cached - 1;
	}
	return search_key(channel, time_s);
}

struct clip_moment clip_moment_search(
	const struct model_channel *channel, float time_s, int cached)
{
	const float *times = channel->time_s;
	int last = channel->key_count - 1;
	struct clip_moment moment = {
		times, channel->key_count, last, CLIP_AT_KEY};

	/* The comparison is negated so that a NaN takes the first key. */
	if (!(time_s > times[0])) {
		moment.key = 0;
	} else if (time_s < times[last]) {
		int key = find_key(channel, time_s, cached);

		moment.key = key;
		moment.u = (time_s - times[key]) / (times[key + 1] - times[key]);
	}
	return moment;
}

/*
 * Returns a channel's value at a key. Packed keys are unpacked into room, and
 * rotations of splines, whose keys may have any length, are normalised there.
 * For other channels room may be NULL; for splines NULL gives the file's value.
 */
static const float *key_value(
	const struct model_channel *channel, int key, float room[4])
{
	size_t width = (size_t)channel->width;
	const float *value;

	if (channel->packed) {
		model_channel_key(channel, key, room);
		return room;
	}
	if (channel->interpolation != MODEL_CUBICSPLINE) {
		return channel->value + (size_t)key * width;
	}
	value = channel->value + (3 * (size_t)key + 1) * width;
	if (!room || channel->path != MODEL_ROTATION) {
		return value;
	}
	memcpy(room, value, 4 * sizeof(*room));
	quat_normalize(room);
	return room;
}

/*
 * The weights of a cubic Hermite spline at one u (glTF 2.0, appendix C.5): of
 * both values and both tangents.
 */
struct hermite {
	float from, out_tangent, to, in_tangent;
};

/* Tangents are per second, so their weights contain the interval's length. */
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
	const float *from = key_value(channel, key, NULL);
	const float *to = key_value(channel, key + 1, NULL);
	const float *out_tangent = from + width;
	const float *in_tangent = to - width;

	for (int i = 0; i < width; i++) {
		out[i] = from[i] * h.from + out_tangent[i] * h.out_tangent +
			to[i] * h.to + in_tangent[i] * h.in_tangent;
	}
}

/*
 * Returns the sign, 1 or -1, to multiply a rotation key by so that it lies in
 * the same half of the sphere as the rotation `of`. For other paths it is 1.
 */
static float side_of(
	const struct model_channel *channel, const float *key, const float *of)
{
	if (channel->path != MODEL_ROTATION) {
		return 1;
	}
	return vec_dot(key, of) + key[3] * of[3] < 0 ? -1 : 1;
}

/* The first key is its own predecessor, the last key its own successor. */
static void sample_catmull_rom(
	const struct model_channel *channel, int key, float u, float *out)
{
	int before = key > 0 ? key - 1 : key;
	int after = key + 2 < channel->key_count ? key + 2 : key + 1;
	const float *time_s = channel->time_s;
	struct hermite h = hermite_at(u, time_s[key + 1] - time_s[key]);
	float room[4][4];
	const float *p0 = key_value(channel, before, room[0]);
	const float *p1 = key_value(channel, key, room[1]);
	const float *p2 = key_value(channel, key + 1, room[2]);
	const float *p3 = key_value(channel, after, room[3]);
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
	float room[2][4];
	const float *from = key_value(channel, key, room[0]);
	const float *to = key_value(channel, key + 1, room[1]);

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
	float room[4];

	memcpy(out, key_value(channel, key, room),
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

static void sample_cubic(
	const struct model_channel *channel, int key, float u, float *out)
{
	if (channel->interpolation == MODEL_CUBICSPLINE) {
		sample_tangents(channel, key, u, out);
	} else {
		sample_catmull_rom(channel, key, u, out);
	}
	if (channel->path == MODEL_ROTATION) {
		quat_normalize(out);
	}
}

void clip_channel_sample(const struct model_channel *channel,
	enum clip_interpolation interpolation, int key, float u, float *out)
{
	if (u < 0) {
		sample_key(channel, key, out);
		return;
	}
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
		sample_cubic(channel, key, u, out);
		break;
	}
}

void clip_sample_channel(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int *key, float *out)
{
	struct clip_moment moment = clip_moment_find(channel, time_s, *key);

	*key = moment.key;
	clip_channel_sample(channel, interpolation, moment.key, moment.u, out);
}
