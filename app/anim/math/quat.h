/*
 * Quaternions as rotations, in the order x y z w.
 *
 * Sums are written out in one order, so that every machine computes the same
 * floats. Outputs may alias inputs.
 */
#ifndef APP_ANIM_MATH_QUAT_H
#define APP_ANIM_MATH_QUAT_H

#include <stdbool.h>

static inline void quat_set_identity(float out[4])
{
	out[0] = out[1] = out[2] = 0;
	out[3] = 1;
}

/*
 * Interpolates along the shorter arc, t in 0..1. If the inputs have unit
 * length, the output has too, to 1e-6. Formula: glTF 2.0, appendix C.4.
 */
void quat_slerp(const float a[4], const float b[4], float t, float out[4]);

/*
 * The weights of both rotations in a slerp: sin((1 - t) angle) / sin(angle) and
 * sin(t angle) / sin(angle). angle is the one between the quaternions, half of
 * the rotation's, and x, -1..0, is cos(angle) - 1.
 */
void quat_slerp_weights(float x, float t, float weight[2]);

/*
 * Makes q unit length. A quaternion that is nearly zero, that is not finite or
 * whose squared length is 1e30 or more becomes the identity.
 */
void quat_normalize(float q[4]);

/* out = a * b: b's rotation first, then a's. */
void quat_multiply(const float a[4], const float b[4], float out[4]);

/* The inverse of a unit quaternion. */
void quat_conjugate(const float q[4], float out[4]);

/* Rotates a vector by a unit quaternion. */
void quat_rotate(const float q[4], const float v[3], float out[3]);

/* The rotation by angle_rad about a unit axis. */
void quat_from_axis_angle(const float axis[3], float angle_rad, float out[4]);

/*
 * The smallest rotation that turns the direction `from` into the direction
 * `to`. Neither needs unit length. For opposite directions it is half a turn
 * about some axis at right angles to them; if a direction is zero, it is the
 * identity.
 */
void quat_between(const float from[3], const float to[3], float out[4]);

/*
 * The rotation from up, 0 1 0, to the normal of a ground whose height rises by
 * rise_x per unit along x and by rise_z per unit along z.
 */
void quat_from_slope(float rise_x, float rise_z, float out[4]);

/* The angle of a unit quaternion's rotation, 0..pi. */
float quat_angle(const float q[4]);

/*
 * Reduces the angle between two unit rotations, base and q, to limit_rad by
 * changing q; the axis from base to q stays. Returns true if q was changed.
 */
bool quat_limit(float q[4], const float base[4], float limit_rad);

#endif
