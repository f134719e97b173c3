/*
 * Sampling a clip at a time, and the repetition of clips.
 */
#ifndef APP_ANIM_CLIP_H
#define APP_ANIM_CLIP_H

#include "app/anim/pose.h"

struct clip_moving; /* a channel whose value changes */
struct clip_part;   /* of a node, that clip_mix() mixes */
struct turn;

/*
 * What a playback keeps from frame to frame, to avoid searching for keys: the
 * key of the last sample in each channel and, for clip_pose() and clip_mix(),
 * which of the clip's channels change at all. A cursor belongs to one model.
 * One that is all zero is valid but slower, except for clip_mix().
 */
struct clip_cursor {
	int channel_count;
	int *key; /* [channel_count]; any values are valid */
	/*
	 * [node_count] or NULL, set before the first use: weights from 0 to 1
	 * for clip_mix(). clip_pose() lets channels of nodes where it is 0 rest
	 * at their first key.
	 */
	const float *only;
	/*
	 * [node_count] or NULL, set before the first use: bits 1 << enum
	 * model_path for what clip_mix() mixes; NULL for everything.
	 */
	const uint8_t *paths;

	bool begun;                    /* the members below are valid */
	const struct model_clip *clip; /* theirs; NULL: none, the rest pose */
	struct pose still;             /* rest pose and constant channels */
	int turn_count, moving_count, part_count;
	int float_turn_count;       /* of turn; packed ones follow */
	struct turn *turn;          /* [channel_count], rotations by slerp */
	struct clip_moving *moving; /* [channel_count], all others */
	struct clip_part *part;     /* [node_count], without these rotations */
};

/* How values between two keys are computed. */
enum clip_interpolation {
	CLIP_AUTO,    /* as the file says for each channel */
	CLIP_NEAREST, /* the key closer in time; the later one of a tie */
	CLIP_STEP,    /* the earlier key */
	CLIP_LINEAR,  /* linearly; rotations along the shorter arc */
	CLIP_CUBIC,   /* with the file's tangents or, if it has none, those of
			 Catmull-Rom: (next - previous) / time between them */
};

/* The enum value of "auto", "nearest" and so on, or -1 for another name. */
int clip_interpolation_find(const char *name);

/* Makes a cursor for all clips of the model. 0 or -ENOMEM. */
int clip_cursor_init(struct clip_cursor *cursor, const struct model *model,
	struct arena *arena);

/*
 * Writes the clip's values at time_s into the pose. It does not change nodes
 * without a channel, so callers that change clips call pose_rest() first. Times
 * before a channel's first key or after its last one give that key. Formulas:
 * glTF 2.0, appendix C.
 */
void clip_sample(const struct model_clip *clip, float time_s,
	struct clip_cursor *cursor, struct pose *pose);

/* The same with a given interpolation. */
void clip_sample_as(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * Writes the whole pose: the rest values where the clip has no channel, and the
 * first key of channels that never change (model_channel.constant). The result
 * is that of pose_rest() and clip_sample_as(), but for rounding in constant
 * channels and the lengths of packed rotations (turns.h), and takes less time.
 */
void clip_pose(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * Mixes the clip into a pose of the model: pose = pose + (clip - pose) *
 * amount, for what cursor->paths has, and with amount multiplied by
 * cursor->only. Rotations are mixed linearly, with the sign that lies in the
 * pose's half of the sphere, and normalised. clip may be NULL for the rest
 * pose. cursor is one of clip_cursor_init().
 */
void clip_mix(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, float amount,
	struct clip_cursor *cursor, struct pose *pose);

/*
 * Adds to paths, as in struct clip_cursor, what the clip may change from rest.
 * clip may be NULL.
 */
void clip_add_paths(const struct model_clip *clip, const struct model *model,
	uint8_t *paths);

/*
 * Writes one channel's value, channel->width floats. key caches the last key,
 * as in struct clip_cursor. Cubic rotations are normalised; others are as long
 * as the file's keys.
 */
void clip_sample_channel(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int *key, float *out);

enum clip_repeat {
	CLIP_ONCE, /* stops at the end */
	CLIP_LOOP,
	CLIP_PING_PONG, /* forward, backward, and so on */
};

/*
 * The time in the clip, 0..duration_s, for a playback time, which is double as
 * a playback may run for days. In a loop duration_s itself becomes 0.
 */
float clip_time(double time_s, float duration_s, enum clip_repeat repeat);

#endif
