/*
 * Affine matrices: four columns whose fourth row is 0 0 0 1.
 *
 * Sums are written out in one order, so that every machine computes the same
 * floats. Outputs may alias inputs.
 */
#ifndef APP_ANIM_MATH_MATRIX_H
#define APP_ANIM_MATH_MATRIX_H

#include <cglm/types.h>

#include <stdbool.h>

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

/*
 * Whether the matrix changes all lengths by one factor, to 1 in 256: it turns,
 * mirrors, moves and scales evenly, and so transforms normals as positions.
 */
bool matrix_is_even(const mat4 *matrix);

/*
 * The matrix that transforms normals, without translation: the inverse's
 * transpose, up to a positive factor, which is chosen so that the result has
 * the size of the matrix. For an even matrix it is the matrix itself. A flat
 * matrix is no obstacle; one that leaves a line or a point is copied.
 */
void matrix_normals(const mat4 *matrix, mat4 *out);

/*
 * The determinant of the matrix without translation. Below 0 the matrix
 * mirrors, which turns triangles round.
 */
float matrix_determinant(const mat4 *matrix);

#endif
