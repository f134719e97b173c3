/*
 * Sampling one channel, for clip.c.
 *
 * Finding the keys around a time and interpolating between them are separate
 * steps, because consecutive channels often have the same key times. The most
 * frequent case of both is inline.
 */
#ifndef APP_ANIM_CLIP_CHANNEL_H
#define APP_ANIM_CLIP_CHANNEL_H

#include "app/anim/clip.h"
#include "platform/base/compiler.h"

#include <stddef.h>

/*
 * The value of clip_moment.u for times that take the value of one key: those up
 * to the first key and from the last key on.
 */
#define CLIP_AT_KEY (-1.0f)

/* Where a time lies among a channel's keys. */
struct clip_moment {
	const float *time_s; /* the channel's key times; NULL: nothing was
				searched yet */
	int key_count;
	int key;
	float u; /* 0..1 from this key to the next one, or CLIP_AT_KEY */
};

/*
 * Where a pose has the value of a channel that is not MODEL_WEIGHTS: the offset
 * in bytes from pose.local.
 */
static ALWAYS_INLINE size_t clip_channel_offset(
	const struct model_channel *channel)
{
	static const uint8_t part[] = {
		[MODEL_TRANSLATION] = offsetof(struct transform, translation),
		[MODEL_ROTATION] = offsetof(struct transform, rotation),
		[MODEL_SCALE] = offsetof(struct transform, scale),
	};

	return (size_t)channel->node * sizeof(struct transform) +
		part[channel->path];
}

/*
 * Returns where the pose has the channel's value, and marks the node as
 * animated. The loader has checked the bounds.
 */
float *clip_channel_target(
	const struct model_channel *channel, struct pose *pose);

/*
 * Finds time_s among the keys. cached is the key of the last search and may
 * have any value. A time of NaN gives key 0.
 */
struct clip_moment clip_moment_search(
	const struct model_channel *channel, float time_s, int cached);

/*
 * Writes the value at u between key and the next key, channel->width floats.
 * Rotations by CLIP_CUBIC and those of splines are normalised; others are as
 * long as the file's keys.
 */
void clip_channel_sample(const struct model_channel *channel,
	enum clip_interpolation interpolation, int key, float u, float *out);

static ALWAYS_INLINE struct clip_moment clip_moment_between(
	const struct model_channel *channel, int key, float time_s)
{
	const float *at = channel->time_s + key;

	return (struct clip_moment){channel->time_s, channel->key_count, key,
		(time_s - at[0]) / (at[1] - at[0])};
}

/*
 * The same as clip_moment_search(), with a short way for a cached key that is
 * still the right one or the one before it, as in a playback.
 */
static ALWAYS_INLINE struct clip_moment clip_moment_find(
	const struct model_channel *channel, float time_s, int cached)
{
	int last = channel->key_count - 1;
	const float *at;

	if ((unsigned)cached >= (unsigned)last) {
		return clip_moment_search(channel, time_s, cached);
	}
	at = channel->time_s + cached;
	if (at[0] <= time_s) {
		if (time_s < at[1]) {
			return clip_moment_between(channel, cached, time_s);
		}
		if (cached + 1 < last && time_s < at[2]) {
			return clip_moment_between(channel, cached + 1, time_s);
		}
	}
	return clip_moment_search(channel, time_s, cached);
}

static ALWAYS_INLINE bool clip_moment_fits(
	const struct clip_moment *moment, const struct model_channel *channel)
{
	return channel->time_s == moment->time_s &&
		channel->key_count == moment->key_count;
}

#endif
