/*
 * Functions over struct transform: translation, rotation and scale.
 *
 * Sums are written out in one order, so that every machine computes the same
 * floats. Outputs may alias inputs.
 */
#ifndef APP_ANIM_MATH_TRANSFORM_H
#define APP_ANIM_MATH_TRANSFORM_H

#include "app/model/model.h"

struct transform transform_identity(void);

/* out = T * R * S, the matrices of translation, rotation and scale. */
void transform_to_matrix(const struct transform *transform, mat4 out);

/*
 * out = parent * child. The result is exact if the parent has the same scale on
 * all axes or the child has no rotation; otherwise the shear of the product is
 * dropped.
 */
void transform_compose(const struct transform *parent,
	const struct transform *child, struct transform *out);

/* Interpolates translation and scale linearly, rotation by quat_slerp(). */
void transform_mix(const struct transform *a, const struct transform *b,
	float t, struct transform *out);

#endif
