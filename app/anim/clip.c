#include "app/anim/clip.h"

#include "app/anim/clip_channel.h"
#include "platform/base/scalar.h"

#include <string.h>

static const char *const INTERPOLATION_NAME[] = {
	[CLIP_AUTO] = "auto",
	[CLIP_NEAREST] = "nearest",
	[CLIP_STEP] = "step",
	[CLIP_LINEAR] = "linear",
	[CLIP_CUBIC] = "cubic",
};

int clip_interpolation_find(const char *name)
{
	for (size_t i = 0; i < ARRAY_COUNT(INTERPOLATION_NAME); i++) {
		if (strcmp(INTERPOLATION_NAME[i], name) == 0) {
			return (int)i;
		}
	}
	return -1;
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
			clip_channel_target(channel, pose));
	}
}

/* Returns time_s modulo period_s, at least 0 and below period_s. */
static double wrap(double time_s, double period_s)
{
	double turns = time_s / period_s;
	double rest_s;

	/* Beyond 2^31 periods the phase would be rounding noise. */
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

float clip_round_time(
	const struct model_clip *clip, double time_s, enum clip_repeat repeat)
{
	float duration_s = clip->duration_s, lead_s = clip->lead_s;
	float at_s = clip_time(time_s, duration_s, repeat);
	bool is_first = time_s >= 0 && time_s < (double)duration_s;

	return repeat == CLIP_LOOP && lead_s > 0 && !is_first
		? lead_s + at_s * (1 - lead_s / duration_s)
		: at_s;
}

float clip_share(const struct model_clip *clip, float time_s)
{
	float way_s = clip->duration_s - clip->lead_s;

	return way_s > 0 ? scalar_clamp((time_s - clip->lead_s) / way_s, 0, 1)
			 : 0;
}
