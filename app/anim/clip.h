/*
 * Reading a clip at a time: sampler evaluation and the clock of a playback.
 */
#ifndef APP_ANIM_CLIP_H
#define APP_ANIM_CLIP_H

#include "app/anim/pose.h"

/*
 * Where the last sample was found in each channel, so that playing on costs no
 * search. One per playback; any content is valid, only slower.
 */
struct clip_cursor {
	int channel_count;
	int *key; /* [channel_count] */
};

/* Room for the largest clip of the model. 0 or -ENOMEM. */
int clip_cursor_init(struct clip_cursor *cursor, const struct model *model,
	struct arena *arena);

/*
 * Writes the clip's values at time_s into the pose and leaves nodes without a
 * channel alone, so callers that change clips call pose_rest() first. Times
 * before the first and after the last key are clamped to them, channel by
 * channel. Formulas: glTF 2.0, appendix C.
 */
void clip_sample(const struct model_clip *clip, float time_s,
	struct clip_cursor *cursor, struct pose *pose);

/*
 * One channel's value: width floats into out. key is its cached position.
 * Rotations come out unit length whatever the keys' precision.
 */
void clip_sample_channel(const struct model_channel *channel, float time_s,
	int *key, float *out);

enum clip_repeat {
	CLIP_ONCE, /* stays at the end */
	CLIP_LOOP,
};

/*
 * The clip's time for a playback time, in 0..duration_s. A loop begins again
 * at duration_s itself. Double, as a playback may run for days.
 */
float clip_time(double time_s, float duration_s, enum clip_repeat repeat);

#endif
