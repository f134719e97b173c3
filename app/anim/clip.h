/*
 * Reading a clip at a time: sampler evaluation and the clock of a playback.
 */
#ifndef APP_ANIM_CLIP_H
#define APP_ANIM_CLIP_H

#include "app/anim/pose.h"

struct clip_moving; /* a channel that does not hold still */

/*
 * What a playback keeps from frame to frame, so that playing on costs no
 * search: where the last sample was found in each channel and, for clip_pose(),
 * what of the clip moves at all. Of one model. All zero is valid, only slower.
 */
struct clip_cursor {
	int channel_count;
	int *key; /* [channel_count]; any content is valid */

	const struct model_clip *clip; /* that the rest is about; or NULL */
	struct pose still;             /* at rest, and what holds still */
	int moving_count;
	struct clip_moving *moving; /* [channel_count] */
};

/* How to go from key to key. */
enum clip_interpolation {
	CLIP_AUTO,    /* as the file says, channel by channel */
	CLIP_NEAREST, /* the key that is closer in time; a tie goes forward */
	CLIP_STEP,    /* the key before */
	CLIP_LINEAR,  /* straight; rotations along the shorter arc */
	CLIP_CUBIC,   /* by the file's tangents, else by Catmull-Rom ones:
			 (next - previous) / their distance in time */
};

/* "auto", "nearest" and so on; and back: the value, or -1 when unknown. */
const char *clip_interpolation_name(enum clip_interpolation interpolation);
int clip_interpolation_find(const char *name);

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

/* The same with another interpolation than the file's. */
void clip_sample_as(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * The whole pose: rest where the clip has no channel. As pose_rest() followed
 * by clip_sample_as(), but for channels that hold still (model_channel.constant)
 * the first key's value. Does less, so it is what a frame wants.
 */
void clip_pose(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * One channel's value: width floats into out. key is its cached position.
 * Cubic rotations come out unit length, others as unit as the file's keys.
 */
void clip_sample_channel(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int *key, float *out);

enum clip_repeat {
	CLIP_ONCE, /* stays at the end */
	CLIP_LOOP,
	CLIP_PING_PONG, /* to the end, back to the start, and again */
};

/*
 * The clip's time for a playback time, in 0..duration_s. A loop begins again
 * at duration_s itself. Double, as a playback may run for days.
 */
float clip_time(double time_s, float duration_s, enum clip_repeat repeat);

#endif
