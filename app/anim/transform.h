/*
 * Small pure functions over vectors, quaternions and struct transform.
 *
 * Quaternions are x y z w. None of these calls the C library's maths: on a
 * soft-float C library one call costs hundreds of instructions. Sums are
 * written out in one order, so that every machine computes the same floats.
 * Outputs may alias inputs.
 */
#ifndef APP_ANIM_TRANSFORM_H
#define APP_ANIM_TRANSFORM_H

#include "app/model/model.h"
#include "platform/base/scalar.h"

struct transform transform_identity(void);

/* out = T * R * S as four columns. */
void transform_to_matrix(const struct transform *transform, mat4 out);

/*
 * parent * child as a transform. Exact where the parent's scale is the same
 * along all axes or the child does not turn; a shear is dropped otherwise.
 */
void transform_compose(const struct transform *parent,
	const struct transform *child, struct transform *out);

/* Translation and scale linearly, rotation by quat_slerp. */
void transform_mix(const struct transform *a, const struct transform *b,
	float t, struct transform *out);

/* out = a * b of matrices whose fourth row is 0 0 0 1. */
void matrix_multiply(mat4 a, mat4 b, mat4 out);

/* The point carried by such a matrix; and a direction, which does not move. */
void matrix_apply(mat4 matrix, const float point[3], float out[3]);
void matrix_turn(mat4 matrix, const float direction[3], float out[3]);

/*
 * The rotation of such a matrix, its scale and mirroring taken out. The
 * identity where a column is zero.
 */
void matrix_rotation(mat4 matrix, float out[4]);

/*
 * Spherical interpolation along the shorter arc, t in 0..1. Unit inputs give
 * a unit output to 1e-6. glTF 2.0, appendix C.4.
 */
void quat_slerp(const float a[4], const float b[4], float t, float out[4]);

/* Normalises; a zero quaternion, or one with a NaN, becomes the identity. */
void quat_normalize(float q[4]);

/* out = a * b: b's rotation first, then a's. */
void quat_multiply(const float a[4], const float b[4], float out[4]);

/* The opposite rotation of a unit quaternion. */
void quat_conjugate(const float q[4], float out[4]);

/* Rotates a vector by a unit quaternion. */
void quat_rotate(const float q[4], const float v[3], float out[3]);

/* Rotation by angle_rad about a unit axis. */
void quat_from_axis_angle(const float axis[3], float angle_rad, float out[4]);

/*
 * The smallest rotation that turns direction from into direction to; they
 * need not be unit length. Half a turn about any normal axis where they are
 * opposite, the identity where one is zero.
 */
void quat_between(const float from[3], const float to[3], float out[4]);

/* The angle of a unit quaternion's rotation, 0..pi. */
float quat_angle(const float q[4]);

/* These are a few instructions, and loops over cloth are made of them. */

static inline float vec_dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline float vec_length(const float v[3])
{
	return scalar_sqrt(vec_dot(v, v));
}

static inline void vec_cross(const float a[3], const float b[3], float out[3])
{
	float x = a[1] * b[2] - a[2] * b[1];
	float y = a[2] * b[0] - a[0] * b[2];
	float z = a[0] * b[1] - a[1] * b[0];

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

static inline void vec_subtract(const float a[3], const float b[3], float out[3])
{
	float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* out = a + b * factor. */
static inline void vec_add_scaled(
	const float a[3], const float b[3], float factor, float out[3])
{
	float x = a[0] + b[0] * factor;
	float y = a[1] + b[1] * factor;
	float z = a[2] + b[2] * factor;

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* out = a + (b - a) * t, and exactly b at t = 1. */
static inline void vec_mix(
	const float a[3], const float b[3], float t, float out[3])
{
	float x = a[0] * (1 - t) + b[0] * t;
	float y = a[1] * (1 - t) + b[1] * t;
	float z = a[2] * (1 - t) + b[2] * t;

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* Makes v unit length and returns its length; a zero vector stays zero. */
float vec_normalize(float v[3]);

#endif
