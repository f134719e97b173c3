#include "app/anim/clip_join.h"

#include "app/anim/pose_blend.h"
#include "platform/base/scalar.h"

float clip_join_frame_s(const struct model_clip *clip)
{
	float least = 0;

	for (int c = 0; c < clip->channel_count; c++) {
		const struct model_channel *channel = &clip->channel[c];

		for (int k = 1; k < channel->key_count; k++) {
			float gap = channel->time_s[k] - channel->time_s[k - 1];

			least = least == 0 || gap < least ? gap : least;
		}
	}
	return least > 0 ? least : 1.0f / 30;
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

float clip_join_duration(const struct clip_join *join)
{
	return join->from->duration_s + join->to->duration_s - join->overlap_s;
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
