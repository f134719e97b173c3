/*
 * Two clips played as one: the end of the first overlaps the start of the
 * second and is blended into it. The joined clip is as long as both together
 * less the overlap. It is computed from both clips while it plays.
 */
#ifndef APP_ANIM_CLIP_JOIN_H
#define APP_ANIM_CLIP_JOIN_H

#include "app/anim/clip.h"
#include "app/anim/ease.h"

enum {
	CLIP_JOIN_FRAMES = 4 /* the default overlap, in original frames */
};

struct clip_join {
	const struct model_clip *from;
	const struct model_clip *to;
	float overlap_s;
	enum ease ease;
	enum clip_interpolation interpolation;
};

/*
 * The time between a clip's original frames. If a channel has eight keys or
 * more at even distances of up to 0.1 s, the clip was sampled at that rate.
 * Otherwise the exporter has left out keys, and the gaps between the others say
 * little. Then it is the first of the rates 30, 24, 25, 60, 50, 48, 120, 100
 * and 240 Hz for which all keys lie on frames, to half a millisecond; if none
 * fits, 30 Hz.
 */
float clip_join_frame_s(const struct model_clip *clip);

/*
 * Joins two clips with an overlap of the given number of the first clip's
 * original frames, but at most as long as the shorter clip. Easing is cubic,
 * and channels are interpolated as the file says. The clips are not copied.
 */
struct clip_join clip_join_frames(
	const struct model_clip *from, const struct model_clip *to, int frames);

/*
 * Writes the joined clip at time_s, 0 to both durations less the overlap, into
 * pose. Nodes without a channel get their rest transform. scratch is another
 * pose of the model, which is overwritten.
 */
void clip_join_sample(const struct clip_join *join, float time_s,
	struct clip_cursor *from_cursor, struct clip_cursor *to_cursor,
	struct pose *scratch, struct pose *pose);

#endif
