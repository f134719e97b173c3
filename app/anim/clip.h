/*
 * Sampling a clip at a time, and the repetition of clips.
 */
#ifndef APP_ANIM_CLIP_H
#define APP_ANIM_CLIP_H

#include "app/anim/pose.h"

struct clip_moving; /* a channel that changes and is no struct turn */
struct clip_part;   /* the paths of one node that clip_mix() mixes */
struct turn;

/*
 * What a playback keeps from frame to frame, to avoid searching for keys: the
 * key of the last sample in each channel and, for clip_pose() and clip_mix(),
 * which of the clip's channels change at all. A cursor belongs to one model.
 * clip_sample() and clip_pose() accept a cursor of zeros, which is slower;
 * clip_mix() needs one from clip_cursor_init().
 */
struct clip_cursor {
	int channel_count;
	int *key; /* [channel_count]; any values are valid */
	/*
	 * NULL or [node_count], which the caller sets before the first use:
	 * weights from 0 to 1 for clip_mix(). Where a weight is 0, clip_pose()
	 * gives the node's channels their first key and does not animate them.
	 */
	const float *only;
	/*
	 * NULL (all paths) or [node_count], which the caller sets before the
	 * first use: a bit 1 << enum model_path for each path that clip_mix()
	 * mixes.
	 */
	const uint8_t *paths;

	bool begun;                    /* whether the members below are valid */
	const struct model_clip *clip; /* the clip they belong to; NULL: the
					  rest pose */
	struct pose still;             /* the rest pose with the constant
					  channels' values */
	int turn_count, moving_count, part_count;
	int float_turn_count;       /* the first ones of turn[] have float keys;
				       packed turns follow */
	struct turn *turn;          /* [channel_count]: rotations that turns.h
				       can sample */
	struct clip_moving *moving; /* [channel_count]: all other channels that
				       change */
	struct clip_part *part;     /* [node_count]: what clip_mix() mixes
				       besides turn[] */
};

/* How values between two keys are computed. */
enum clip_interpolation {
	CLIP_AUTO,    /* as the file says for each channel */
	CLIP_NEAREST, /* the key closer in time; half-way the later one */
	CLIP_STEP,    /* the earlier key */
	CLIP_LINEAR,  /* linearly; rotations along the shorter arc */
	CLIP_CUBIC,   /* with the file's tangents or, if it has none, those of
			 Catmull-Rom: (next - previous) / time between them */
};

/*
 * Returns the enum value of "auto", "nearest", "step", "linear" or "cubic", or
 * -1 for another name.
 */
int clip_interpolation_find(const char *name);

/*
 * Makes a cursor for all clips of the model. The arena owns its arrays. Returns
 * 0 or -ENOMEM.
 */
int clip_cursor_init(struct clip_cursor *cursor, const struct model *model,
	struct arena *arena);

/*
 * Writes the clip's values at time_s into the pose. Nodes without a channel
 * keep their values, so a caller that changes to another clip calls pose_rest()
 * first. Times before a channel's first key or after its last one give that
 * key. Formulas: glTF 2.0, appendix C.
 */
void clip_sample(const struct model_clip *clip, float time_s,
	struct clip_cursor *cursor, struct pose *pose);

/* The same with a given interpolation. */
void clip_sample_as(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * Writes the whole pose: the rest values where the clip has no channel, and the
 * first key of channels that never change (model_channel.constant). This is
 * faster than pose_rest() and clip_sample_as() and gives the same result,
 * except for rounding in constant channels and the lengths of packed rotations
 * (turns.h).
 */
void clip_pose(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, struct clip_cursor *cursor,
	struct pose *pose);

/*
 * Mixes the clip into a pose of the model: pose = pose + (clip - pose) *
 * amount, where amount is multiplied by the node's weight in cursor->only. Only
 * the paths in cursor->paths change. Rotations are mixed linearly along the
 * shorter arc and normalised. clip may be NULL, which stands for the rest pose.
 * cursor must come from clip_cursor_init().
 */
void clip_mix(const struct model_clip *clip, float time_s,
	enum clip_interpolation interpolation, float amount,
	struct clip_cursor *cursor, struct pose *pose);

/*
 * Sets the bits in paths[node_count] (as in struct clip_cursor) of all paths
 * that the clip may change from rest. Other bits stay. clip may be NULL: no
 * change.
 */
void clip_add_paths(const struct model_clip *clip, const struct model *model,
	uint8_t *paths);

/*
 * Writes one channel's value, channel->width floats. *key is the key of the
 * last call (any value is valid) and is updated. Rotations by CLIP_CUBIC and
 * those of splines are normalised; others are as long as the file's keys.
 */
void clip_sample_channel(const struct model_channel *channel, float time_s,
	enum clip_interpolation interpolation, int *key, float *out);

enum clip_repeat {
	CLIP_ONCE, /* stops at the end */
	CLIP_LOOP,
	CLIP_PING_PONG, /* forward, backward, and so on */
};

/*
 * Converts a playback time to a time in the clip, 0..duration_s. time_s is
 * double, as a playback may run for days. In a loop, duration_s itself becomes
 * 0.
 */
float clip_time(double time_s, float duration_s, enum clip_repeat repeat);

/*
 * The same, except that later rounds of a loop begin at the clip's first key
 * (model_clip.lead_s) and are so much slower that a round takes as long. A pose
 * that stood still from 0 to that key would be a jolt in each round.
 */
float clip_round_time(
	const struct model_clip *clip, double time_s, enum clip_repeat repeat);

/*
 * Returns which share of the way from its first key to its end a clip has done
 * at time_s: 0 to 1. 0 for a clip that lasts no time.
 */
float clip_share(const struct model_clip *clip, float time_s);

#endif
