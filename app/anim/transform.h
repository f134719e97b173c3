/*
 * Small pure functions over struct transform and quaternions.
 *
 * Quaternions are x y z w. None of these calls the C library's maths: on a
 * soft-float C library one call costs hundreds of instructions.
 */
#ifndef APP_ANIM_TRANSFORM_H
#define APP_ANIM_TRANSFORM_H

#include "app/model/model.h"

struct transform transform_identity(void);

/* out = T * R * S as four columns. */
void transform_to_matrix(const struct transform *transform, mat4 out);

/*
 * Spherical interpolation along the shorter arc, t in 0..1; out may alias an
 * input. Unit inputs give a unit output to 1e-6. glTF 2.0, appendix C.4.
 */
void quat_slerp(const float a[4], const float b[4], float t, float out[4]);

/* Normalises; a zero quaternion becomes the identity. */
void quat_normalize(float q[4]);

/* out = a * b: b's rotation first, then a's. out may alias an input. */
void quat_multiply(const float a[4], const float b[4], float out[4]);

/* Rotation by angle_rad about a unit axis. */
void quat_from_axis_angle(const float axis[3], float angle_rad, float out[4]);

#endif
