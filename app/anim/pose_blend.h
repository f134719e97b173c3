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
 * out = a + (b - a) * t. Translation, scale and morph weights are interpolated
 * linearly, rotation along the shorter arc. t is multiplied by the node's mask
 * weight; where the product is 0 or less the result is exactly a, where it is 1
 * or more exactly b. out may be a or b.
 */
void pose_mix(const struct pose *a, const struct pose *b, float t,
	const float *mask, struct pose *out);

/*
 * Adds what layer differs from reference to pose, times weight and mask: the
 * differences of translation and morph weights, the rotation from reference to
 * layer in the node's own frame, and the ratio of scales. Where the scale in
 * reference is 0, the scale of pose stays. reference is usually the rest pose
 * or the layer's first frame.
 */
void pose_add(struct pose *pose, const struct pose *layer,
	const struct pose *reference, float weight, const float *mask);

#endif
