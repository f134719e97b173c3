/*
 * Two clips played as one: the end of the first overlaps the start of the
 * second and is blended into it. The joined clip is shorter than both together
 * by the overlap; no frame is added or stored.
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
 * Otherwise programs have left out keys, and how far the others are apart says
 * little: of the rates 30, 24, 25, 60, 50, 48, 120, 100 and 240 Hz it is then
 * the first whose frames have all keys, to half a millisecond, or else 30 Hz.
 */
float clip_join_frame_s(const struct model_clip *clip);

/*
 * A join with an overlap of that many original frames of the first clip, at
 * most as long as the shorter clip, with cubic easing and the interpolation of
 * the file.
 */
struct clip_join clip_join_frames(
	const struct model_clip *from, const struct model_clip *to, int frames);

/*
 * Writes the joined clips at time_s into pose: 0 to both durations less the
 * overlap. Nodes without a channel get their rest transform. scratch is another
 * pose of the model, whose content is lost.
 */
void clip_join_sample(const struct clip_join *join, float time_s,
	struct clip_cursor *from_cursor, struct clip_cursor *to_cursor,
	struct pose *scratch, struct pose *pose);

#endif
