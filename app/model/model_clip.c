#include "app/model/model_loader.h"

#include "platform/base/scalar.h"

#include <errno.h>
#include <math.h>
#include <string.h>

/*
 * The tolerance of a constant channel, relative to the largest value on the
 * same path. It is larger than the rounding errors of exporters.
 */
static const float NOISE = 2e-6f;

static float largest_value(const struct model_clip *clip, enum model_path path)
{
	float largest = 0;

	for (int c = 0; c < clip->channel_count; c++) {
		const struct model_channel *channel = &clip->channel[c];
		size_t count =
			(size_t)channel->key_count * (size_t)channel->width;

		if (channel->path != path) {
			continue;
		}
		if (!channel->value) {
			largest = largest > 1 ? largest : 1;
			continue;
		}
		for (size_t i = 0; i < count; i++) {
			float size = scalar_abs(channel->value[i]);

			largest = scalar_max(size, largest);
		}
	}
	return largest;
}

static bool holds_still(const struct model_channel *channel, float tolerance)
{
	int width = channel->width;

	for (int key = 1; key < channel->key_count; key++) {
		const float *value =
			channel->value + (size_t)key * (size_t)width;

		for (int i = 0; i < width; i++) {
			/* NaN fails this comparison. */
			if (!(scalar_abs(value[i] - channel->value[i]) <=
				    tolerance)) {
				return false;
			}
		}
	}
	return true;
}

/* Sets constant. Exporters write keys for all bones, but few of them move. */
static void find_constant(struct model_clip *clip)
{
	float tolerance[MODEL_WEIGHTS + 1];

	for (int path = 0; path <= MODEL_WEIGHTS; path++) {
		tolerance[path] =
			NOISE * largest_value(clip, (enum model_path)path);
	}
	for (int c = 0; c < clip->channel_count; c++) {
		struct model_channel *channel = &clip->channel[c];

		channel->constant = channel->value &&
			channel->interpolation != MODEL_CUBICSPLINE &&
			holds_still(channel, tolerance[channel->path]);
	}
}

/* Returns how many floats all keys have together. */
static size_t number_count(const struct model_channel *channel)
{
	return (size_t)channel->key_count * (size_t)channel->width *
		(channel->interpolation == MODEL_CUBICSPLINE ? 3 : 1);
}

static int keep_floats(struct model_channel *channel, struct arena *arena)
{
	size_t count = number_count(channel);
	float *value = ARENA_ARRAY(arena, float, count);

	if (!value) {
		return -ENOMEM;
	}
	channel->value = memcpy(value, channel->value, count * sizeof(*value));
	channel->packed = NULL;
	return 0;
}

static int64_t packed_dot(const int16_t a[4], const int16_t b[4])
{
	return (int64_t)a[0] * b[0] + (int64_t)a[1] * b[1] +
		(int64_t)a[2] * b[2] + (int64_t)a[3] * b[3];
}

/* Whether all keys have the length that model_channel.packed promises. */
static bool can_pack(const struct model_channel *channel)
{
	const float one = (float)MODEL_PACKED_UNIT * (float)MODEL_PACKED_UNIT;

	for (int k = 0; k < channel->key_count; k++) {
		const int16_t *q = channel->packed[k];
		float length2 = (float)packed_dot(q, q);

		if (!(scalar_abs(length2 - one) <= 8e-5f * one)) {
			return false;
		}
	}
	return true;
}

static int keep_packed(struct model_channel *channel, struct arena *arena)
{
	size_t count = (size_t)channel->key_count;
	int16_t(*packed)[4] = arena_alloc(arena, count, sizeof(*packed));

	if (!packed) {
		return -ENOMEM;
	}
	memcpy(packed, channel->packed, count * sizeof(*packed));
	for (size_t k = 1; k < count; k++) {
		if (packed_dot(packed[k - 1], packed[k]) < 0) {
			for (int i = 0; i < 4; i++) {
				packed[k][i] = (int16_t)-packed[k][i];
			}
		}
	}
	channel->packed = (const int16_t(*)[4])packed;
	channel->value = NULL;
	return 0;
}

int model_keep_clip(
	struct model_clip *clip, struct arena *keys, struct arena *arena)
{
	int error = 0;

	find_constant(clip);
	for (int i = 0; !error && i < clip->channel_count; i++) {
		struct model_channel *channel = &clip->channel[i];
		bool packs = !channel->constant && channel->packed &&
			can_pack(channel);

		channel->key_count = channel->constant ? 1 : channel->key_count;
		error = packs ? keep_packed(channel, arena)
			      : keep_floats(channel, arena);
		arena_release(&keys[i]);
	}
	return error;
}

void model_channel_key(const struct model_channel *channel, int key, float *out)
{
	size_t width = (size_t)channel->width;
	double length2 = 0;

	if (!channel->packed) {
		memcpy(out, channel->value + (size_t)key * width,
			width * sizeof(*out));
		return;
	}
	for (size_t i = 0; i < width; i++) {
		out[i] = (float)channel->packed[key][i] / MODEL_PACKED_UNIT;
		length2 += (double)out[i] * out[i];
	}
	for (size_t i = 0; i < width; i++) {
		out[i] = (float)(out[i] / sqrt(length2));
	}
}

static bool is_unit(const struct model_channel *channel)
{
	if (channel->packed) {
		return true;
	}
	if (channel->path != MODEL_ROTATION ||
		channel->interpolation == MODEL_CUBICSPLINE) {
		return false;
	}
	for (int key = 0; key < channel->key_count; key++) {
		const float *q = channel->value + (size_t)key * 4;
		float length2 =
			q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];

		if (!(length2 > 1 - 2e-6f && length2 < 1 + 2e-6f)) {
			return false;
		}
	}
	return true;
}

static void find_unit(struct model_clip *clip)
{
	for (int c = 0; c < clip->channel_count; c++) {
		clip->channel[c].unit = is_unit(&clip->channel[c]);
	}
}

static void find_lead(struct model_clip *clip)
{
	float first_s = clip->duration_s;

	for (int c = 0; c < clip->channel_count; c++) {
		const struct model_channel *channel = &clip->channel[c];

		if (!channel->constant && channel->time_s[0] < first_s) {
			first_s = channel->time_s[0];
		}
	}
	clip->lead_s =
		first_s > 0 && first_s <= 0.1f && first_s < clip->duration_s
		? first_s
		: 0;
}

/*
 * Lets channels with equal key times share one array, since exporters repeat
 * the same times for each bone. Equal times are rarely far apart, and a clip
 * may have many thousand channels.
 */
static void share_times(struct model_clip *clip)
{
	const int farthest = 256;

	for (int c = 1; c < clip->channel_count; c++) {
		struct model_channel *channel = &clip->channel[c];
		size_t size =
			(size_t)channel->key_count * sizeof(*channel->time_s);
		const struct model_channel *other = channel;
		const struct model_channel *first =
			clip->channel + (c > farthest ? c - farthest : 0);

		while (other > first) {
			other--;
			if (channel->key_count == other->key_count &&
				memcmp(channel->time_s, other->time_s, size) ==
					0) {
				channel->time_s = other->time_s;
				break;
			}
		}
	}
}

void model_prepare_clips(struct model *model)
{
	for (int i = 0; i < model->clip_count; i++) {
		find_constant(&model->clip[i]);
		find_unit(&model->clip[i]);
		find_lead(&model->clip[i]);
		share_times(&model->clip[i]);
	}
}
