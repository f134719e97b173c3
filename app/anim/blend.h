/*
 * Poses out of poses: mixing, cross-fades, joined clips, layers, masks.
 *
 * Everything is computed on the fly; no in-between frame is stored. Poses of
 * one call belong to the same model. A mask is one weight from 0 to 1 a node,
 * which its morph weights share; NULL stands for 1 everywhere.
 */
#ifndef APP_ANIM_BLEND_H
#define APP_ANIM_BLEND_H

#include "app/anim/clip.h"

enum ease {
	EASE_LINEAR,
	EASE_CUBIC, /* 3 u^2 - 2 u^3: sets off and arrives at rest */
};

/* 0 for u <= 0, 1 for u >= 1, in between by the curve. NaN gives 0. */
float ease_at(enum ease ease, float u);

/* Gives every node of the mask that weight. */
void mask_fill(float *mask, int node_count, float weight);

/* Gives a node and all its descendants that weight. */
void mask_subtree(
	float *mask, const struct model *model, int node, float weight);

/*
 * out = a + (b - a) * t: translation, scale and morph weights linearly,
 * rotation along the shorter arc. Exactly a at t * mask = 0 and b at 1. out
 * may be a or b.
 */
void pose_mix(const struct pose *a, const struct pose *b, float t,
	const float *mask, struct pose *out);

/*
 * Adds what layer does to reference, times weight, onto pose: differences of
 * translation and morph weights, the rotation from reference to layer in the
 * node's own frame, ratios of scale. The reference is usually the rest pose
 * or the layer's first frame.
 */
void pose_add(struct pose *pose, const struct pose *layer,
	const struct pose *reference, float weight, const float *mask);

/*
 * A cross-fade from whatever was shown when it began. It keeps a copy of that
 * pose and no clip, so it may begin at any moment, also during another fade
 * and also onto the clip that is playing.
 */
struct fade {
	struct pose from;
	enum ease ease;
	float duration_s;
	float elapsed_s;
	bool running;
};

/* Room for one pose. 0 or -ENOMEM. */
int fade_init(struct fade *fade, const struct model *model, struct arena *arena);

/*
 * Starts from the pose that is shown now. A duration of 0 or less is over at
 * the next update.
 */
void fade_begin(struct fade *fade, const struct pose *shown, float duration_s,
	enum ease ease);

/*
 * Goes on by step_s and mixes the new pose with the old one, which is gone
 * after duration_s; then the pose is left alone. True while fading.
 */
bool fade_update(struct fade *fade, float step_s, struct pose *pose);

/* The overlap of joined clips in original frames, where nobody says more. */
#define JOIN_FRAMES 4

/*
 * Two clips in one run: the end of the first overlaps the start of the second
 * and is blended into it. No frames are added, the overlapping ones are lost.
 */
struct clip_join {
	const struct model_clip *from;
	const struct model_clip *to;
	float overlap_s;
	enum ease ease;
	enum clip_interpolation interpolation;
};

/*
 * The clip's original frame time: its closest two keys of any channel, or
 * 1/30 s where no channel has two.
 */
float clip_frame_s(const struct model_clip *clip);

/*
 * An overlap of that many of the first clip's original frames, at most as
 * long as the shorter clip; eased cubically, as the file interpolates.
 */
struct clip_join clip_join_frames(
	const struct model_clip *from, const struct model_clip *to, int frames);

/* Both durations less the overlap. */
float clip_join_duration(const struct clip_join *join);

/*
 * Writes the joined run at time_s, 0..clip_join_duration(), into pose, nodes
 * without a channel at rest. scratch is any other pose of the model.
 */
void clip_join_sample(const struct clip_join *join, float time_s,
	struct clip_cursor *from_cursor, struct clip_cursor *to_cursor,
	struct pose *scratch, struct pose *pose);

#endif
