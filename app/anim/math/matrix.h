/*
 * Affine matrices: four columns whose fourth row is 0 0 0 1.
 *
 * Sums are written out in one order, so that every machine computes the same
 * floats. Outputs may alias inputs.
 */
#ifndef APP_ANIM_MATH_MATRIX_H
#define APP_ANIM_MATH_MATRIX_H

#include <cglm/types.h>

/* out = a * b. */
void matrix_multiply(mat4 a, mat4 b, mat4 out);

/* Transforms a point; and a direction, which translation does not affect. */
void matrix_apply(mat4 matrix, const float point[3], float out[3]);
void matrix_apply_direction(mat4 matrix, const float direction[3], float out[3]);

/*
 * The rotation of a matrix as a unit quaternion, without scale and mirroring.
 * If a column is zero it is the identity.
 */
void matrix_rotation(mat4 matrix, float out[4]);

/* The scale of a matrix that has the same scale on all axes: its first column's length. */
float matrix_scale(const mat4 *matrix);

#endif
