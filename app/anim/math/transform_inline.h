/*
 * Functions of this folder as inline bodies, for the loops that run once a
 * joint and frame.
 *
 * Inlined, they keep in registers what one pass of the loop hands to the next.
 * Their sums are interleaved, since VFP11 needs 8 cycles before it can add to
 * the same sum again, and every element is loaded once. ../figures.md says what
 * a joint costs; tests/bench/pose.sh counts it.
 */
#ifndef APP_ANIM_MATH_TRANSFORM_INLINE_H
#define APP_ANIM_MATH_TRANSFORM_INLINE_H

#include "app/anim/math/quat.h"
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "platform/base/scalar.h"

static ALWAYS_INLINE void set_column(
	float out[4], float x, float y, float z, float w)
{
	out[0] = x;
	out[1] = y;
	out[2] = z;
	out[3] = w;
}

static ALWAYS_INLINE void inline_transform_to_matrix(
	const struct transform *transform, mat4 out)
{
	const float *q = transform->rotation;
	const float *s = transform->scale;
	const float *t = transform->translation;
	float x2 = q[0] + q[0], y2 = q[1] + q[1], z2 = q[2] + q[2];
	float xx = q[0] * x2, xy = q[0] * y2, xz = q[0] * z2;
	float yy = q[1] * y2, yz = q[1] * z2, zz = q[2] * z2;
	float wx = q[3] * x2, wy = q[3] * y2, wz = q[3] * z2;

	set_column(out[0], (1 - (yy + zz)) * s[0], (xy + wz) * s[0],
		(xz - wy) * s[0], 0);
	set_column(out[1], (xy - wz) * s[1], (1 - (xx + zz)) * s[1],
		(yz + wx) * s[1], 0);
	set_column(out[2], (xz + wy) * s[2], (yz - wx) * s[2],
		(1 - (xx + yy)) * s[2], 0);
	set_column(out[3], t[0], t[1], t[2], 1);
}

static ALWAYS_INLINE void inline_matrix_multiply(mat4 a, mat4 b, mat4 out)
{
	float p = a[0][0], q = a[0][1], r = a[0][2];
	float x0 = p * b[0][0], y0 = q * b[0][0], z0 = r * b[0][0];
	float x1 = p * b[1][0], y1 = q * b[1][0], z1 = r * b[1][0];
	float x2 = p * b[2][0], y2 = q * b[2][0], z2 = r * b[2][0];
	float x3 = p * b[3][0], y3 = q * b[3][0], z3 = r * b[3][0];

	p = a[1][0], q = a[1][1], r = a[1][2];
	x0 += p * b[0][1], y0 += q * b[0][1], z0 += r * b[0][1];
	x1 += p * b[1][1], y1 += q * b[1][1], z1 += r * b[1][1];
	x2 += p * b[2][1], y2 += q * b[2][1], z2 += r * b[2][1];
	x3 += p * b[3][1], y3 += q * b[3][1], z3 += r * b[3][1];
	p = a[2][0], q = a[2][1], r = a[2][2];
	x0 += p * b[0][2], y0 += q * b[0][2], z0 += r * b[0][2];
	x1 += p * b[1][2], y1 += q * b[1][2], z1 += r * b[1][2];
	x2 += p * b[2][2], y2 += q * b[2][2], z2 += r * b[2][2];
	x3 += p * b[3][2], y3 += q * b[3][2], z3 += r * b[3][2];
	x3 += a[3][0], y3 += a[3][1], z3 += a[3][2];
	set_column(out[0], x0, y0, z0, 0);
	set_column(out[1], x1, y1, z1, 0);
	set_column(out[2], x2, y2, z2, 0);
	set_column(out[3], x3, y3, z3, 1);
}

/*
 * A weight of quat_slerp_weights() by one term of its series. This is right to
 * 3e-7 for rotations up to 8 degrees apart, as neighbouring keys mostly are.
 */
static ALWAYS_INLINE float slerp_weight_near(float t, float x)
{
	return t + t * (t * t - 1) * (x * (1.0f / 3));
}

/* quat_slerp() of unit quaternions, with a shorter way for near ones. */
static ALWAYS_INLINE void inline_quat_slerp(
	const float a[4], const float b[4], float t, float out[4])
{
	float ax = a[0], ay = a[1], az = a[2], aw = a[3];
	float bx = b[0], by = b[1], bz = b[2], bw = b[3];
	float cosine = ax * bx + ay * by + az * bz + aw * bw;
	float x = fabsf(cosine) - 1;
	float weight[2];

	if (x > -0.0025f) {
		weight[0] = slerp_weight_near(1 - t, x);
		weight[1] = slerp_weight_near(t, x);
	} else {
		quat_slerp_weights(x, t, weight);
	}
	weight[1] = cosine < 0 ? -weight[1] : weight[1];
	set_column(out, ax * weight[0] + bx * weight[1],
		ay * weight[0] + by * weight[1], az * weight[0] + bz * weight[1],
		aw * weight[0] + bw * weight[1]);
}

/*
 * q = normalize(q * (1 - t) + to * t), after `to` is negated if it lies in the
 * other half of the sphere. If both are zero, the result is zero.
 */
static ALWAYS_INLINE void inline_quat_mix(float q[4], const float to[4], float t)
{
	float x = q[0], y = q[1], z = q[2], w = q[3];
	float cosine = to[0] * x + to[1] * y + to[2] * z + to[3] * w;
	float rest = 1 - t, scale;

	t = cosine < 0 ? -t : t;
	x = x * rest + to[0] * t;
	y = y * rest + to[1] * t;
	z = z * rest + to[2] * t;
	w = w * rest + to[3] * t;
	scale = 1 / sqrtf(x * x + y * y + z * z + w * w + 1e-30f);
	set_column(q, x * scale, y * scale, z * scale, w * scale);
}

#endif
