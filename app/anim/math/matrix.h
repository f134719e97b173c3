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

/* Transform a point, and a direction, which translation does not affect. */
void matrix_apply(mat4 matrix, const float point[3], float out[3]);
void matrix_apply_direction(mat4 matrix, const float direction[3], float out[3]);

/*
 * Writes the rotation of a matrix as a unit quaternion, without scale and
 * mirroring. If a column is zero, it writes the identity.
 */
void matrix_rotation(mat4 matrix, float out[4]);

/* The scale of a matrix that has the same scale on all axes: its first column's length. */
float matrix_scale(const mat4 *matrix);

/* The greatest scale along an axis of any of count matrices; 0 for none. */
float matrix_greatest_scale(const mat4 *matrix, int count);

/*
 * Whether the matrix changes all lengths by one factor, to 1 in 256. Such a
 * matrix only rotates, mirrors, moves and scales evenly, and so transforms
 * normals as it transforms positions.
 */
bool matrix_is_even(const mat4 *matrix);

/*
 * Writes the matrix that transforms normals, without translation: the inverse
 * transpose times a positive factor, which gives it the size of the matrix. For
 * an even matrix this is the matrix itself. A matrix that flattens one axis is
 * allowed; one that flattens two or three is copied.
 */
void matrix_normals(const mat4 *matrix, mat4 *out);

/*
 * Returns the determinant of the matrix without translation. If it is below 0,
 * the matrix mirrors, which reverses the winding of triangles.
 */
float matrix_determinant(const mat4 *matrix);

#endif
