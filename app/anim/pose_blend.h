/*
 * Poses made of other poses: interpolation, additive layers, masks.
 *
 * All poses of one call belong to the same model. A mask has one weight from 0
 * to 1 for each node, which also applies to the node's morph weights. NULL
 * stands for a mask of ones.
 */
#ifndef APP_ANIM_POSE_BLEND_H
#define APP_ANIM_POSE_BLEND_H

#include "app/anim/pose.h"

/*
 * out = a + (b - a) * t: translation, scale and morph weights linearly,
 * rotation along the shorter arc. t is multiplied by the node's mask weight.
 * The result is exactly a where that gives 0 and b where it gives 1. out may
 * be a or b.
 */
void pose_mix(const struct pose *a, const struct pose *b, float t,
	const float *mask, struct pose *out);

/*
 * Adds the difference between layer and reference to pose, times weight and
 * mask: differences of translation and morph weights, the rotation from
 * reference to layer in the node's own frame, ratios of scale. A scale of 0 in
 * reference adds nothing. reference is usually the rest pose or the layer's
 * first frame.
 */
void pose_add(struct pose *pose, const struct pose *layer,
	const struct pose *reference, float weight, const float *mask);

#endif
