#include "app/anim/clip_join.h"

#include "app/anim/pose_blend.h"
#include "platform/base/scalar.h"

enum {
	SAMPLED_KEYS_MIN = 8
};

#define SAMPLED_GAP_MAX_S 0.101f

/*
 * Frame rates in the order in which they are tried: the rate of the second
 * document (30 Hz), those of films, video and screens, and their multiples.
 */
static const float rates_hz[] = {30, 24, 25, 60, 50, 48, 120, 100, 240};
/* Exporters round key times: 3ds Max to 1/4800 s. */
static const float rounding_s = 5e-4f;

static bool is_on_frame(float time_s, float rate_hz)
{
	float frame = time_s * rate_hz;
	float off = frame - scalar_floor(frame + 0.5f);

	return scalar_abs(off) <= rounding_s * rate_hz + 1e-6f * frame;
}

static bool has_rate(const struct model_clip *clip, float rate_hz)
{
	for (int c = 0; c < clip->channel_count; c++) {
		const struct model_channel *channel = &clip->channel[c];

		for (int k = 0; k < channel->key_count; k++) {
			if (!is_on_frame(channel->time_s[k], rate_hz)) {
				return false;
			}
		}
	}
	return true;
}

/* The gap between the keys of a channel that was sampled evenly, else 0. */
static float sampled_gap_s(const struct model_channel *channel)
{
	const float *time_s = channel->time_s;
	float gap = channel->key_count < SAMPLED_KEYS_MIN
		? 0
		: time_s[1] - time_s[0];

	for (int k = 2; gap > 0 && k < channel->key_count; k++) {
		float off = time_s[k] - time_s[k - 1] - gap;

		if (scalar_abs(off) > rounding_s) {
			gap = 0;
		}
	}
	return gap <= SAMPLED_GAP_MAX_S ? gap : 0;
}

float clip_join_frame_s(const struct model_clip *clip)
{
	float least = 0;

	for (int c = 0; c < clip->channel_count; c++) {
		float gap = sampled_gap_s(&clip->channel[c]);

		least = gap > 0 && (least == 0 || gap < least) ? gap : least;
	}
	if (least > 0) {
		return least;
	}
	for (size_t i = 0; i < ARRAY_COUNT(rates_hz); i++) {
		if (has_rate(clip, rates_hz[i])) {
			return 1.0f / rates_hz[i];
		}
	}
	return 1.0f / rates_hz[0];
}

struct clip_join clip_join_frames(
	const struct model_clip *from, const struct model_clip *to, int frames)
{
	float shorter = from->duration_s < to->duration_s ? from->duration_s
							  : to->duration_s;

	return (struct clip_join){
		.from = from,
		.to = to,
		.overlap_s = scalar_clamp(
			(float)frames * clip_join_frame_s(from), 0, shorter),
		.ease = EASE_CUBIC,
		.interpolation = CLIP_AUTO,
	};
}

void clip_join_sample(const struct clip_join *join, float time_s,
	struct clip_cursor *from_cursor, struct clip_cursor *to_cursor,
	struct pose *scratch, struct pose *pose)
{
	float into_s = time_s - (join->from->duration_s - join->overlap_s);

	if (!(into_s > 0)) {
		clip_pose(join->from, time_s, join->interpolation, from_cursor,
			pose);
		return;
	}
	clip_pose(join->to, into_s, join->interpolation, to_cursor, pose);
	if (into_s < join->overlap_s) {
		clip_pose(join->from, time_s, join->interpolation, from_cursor,
			scratch);
		pose_mix(scratch, pose,
			ease_at(join->ease, into_s / join->overlap_s), NULL,
			pose);
	}
}
