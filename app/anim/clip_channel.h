/*
 * One channel of a clip at a time: what clip.c does for all of them.
 *
 * Finding the time among the keys and going from key to key are apart, because
 * channels in a row often share their times. The commonest case of both is here
 * to be part of the loop.
 */
#ifndef APP_ANIM_CLIP_CHANNEL_H
#define APP_ANIM_CLIP_CHANNEL_H

#include "app/anim/clip.h"
#include "app/anim/math/transform_inline.h"

/* u of a moment that is exactly at its key. */
#define CLIP_AT_KEY (-1.0f)

/* Where a time is among keys. */
struct clip_moment {
	const float *time_s; /* whose; NULL: nobody's yet */
	int key_count;
	int key;
	float u; /* 0..1 of the way to the next key, or CLIP_AT_KEY */
};

/* From anywhere; NaN counts as before the first key. */
struct clip_moment clip_moment_search(
	const struct model_channel *channel, float time_s, int cached);

/*
 * Any interpolation. Cubic rotations come out unit length, others as unit as
 * the file's keys.
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
 * The same as clip_moment_search(). cached may be anything; most often it is
 * the key that held a frame ago, and still holds or the next one does.
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

/* Along the arc between unit rotations. */
static ALWAYS_INLINE bool clip_channel_is_slerp(
	const struct model_channel *channel)
{
	return channel->unit && channel->interpolation == MODEL_LINEAR;
}

/* For such a channel, in its own interpolation. */
static ALWAYS_INLINE void clip_channel_slerp(
	const struct model_channel *channel, int key, float u, float *out)
{
	const float *from = channel->value + key * 4;

	if (u >= 0) {
		inline_quat_slerp(from, from + 4, u, out);
	} else {
		set_column(out, from[0], from[1], from[2], from[3]);
	}
}

#endif
