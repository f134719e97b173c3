#include "app/anim/math/quat.h"

#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

#include <string.h>

static float length2_of(const float q[4])
{
	return vec_dot(q, q) + q[3] * q[3];
}

/*
 * sin(t angle) / sin(angle) is computed as a series in x = cos(angle) - 1
 * (Eberly, "A Fast and Accurate Algorithm for Computing SLERP"), which needs
 * neither the angle nor a division. Three terms are right to 2e-7 up to 36
 * degrees of rotation, that is, for x above SLERP_MIDDLE.
 */
static const float SLERP_MIDDLE = -0.05f;

static float slerp_weight(float t, float x)
{
	float t2 = t * t;
	float p = 1 + (t2 - 9) * (x * (1.0f / 21));

	p = 1 + (t2 - 4) * (x * 0.1f) * p;
	p = 1 + (t2 - 1) * (x * (1.0f / 3)) * p;
	return t * p;
}

void quat_slerp_weights(float x, float t, float weight[2])
{
	float angle, inverse_sine;

	if (x > SLERP_MIDDLE) {
		weight[0] = slerp_weight(1 - t, x);
		weight[1] = slerp_weight(t, x);
		return;
	}
	angle = scalar_acos(1 + x);
	inverse_sine = 1 / scalar_sin(angle);
	weight[0] = scalar_sin((1 - t) * angle) * inverse_sine;
	weight[1] = scalar_sin(t * angle) * inverse_sine;
}

static float distance2_of(const float a[4], const float b[4], float side)
{
	float distance2 = 0;

	for (int i = 0; i < 4; i++) {
		float apart = b[i] * side - a[i];

		distance2 += apart * apart;
	}
	return distance2;
}

void quat_slerp(const float a[4], const float b[4], float t, float out[4])
{
	float cosine = vec_dot(a, b) + a[3] * b[3];
	float side = cosine < 0 ? -1 : 1;
	float x = cosine * side - 1;
	float weight[2];

	/*
	 * If both rotations are close, x is computed from their distance: an
	 * error in their lengths would change the cosine as an angle does.
	 */
	if (x > -0.0005f) {
		x = -0.5f * distance2_of(a, b, side);
	}
	quat_slerp_weights(x, t, weight);
	weight[1] *= side;
	for (int i = 0; i < 4; i++) {
		out[i] = a[i] * weight[0] + b[i] * weight[1];
	}
}

void quat_normalize(float q[4])
{
	float length2 = length2_of(q);
	float scale;

	if (!(length2 > 1e-30f && length2 < 1e30f)) {
		quat_set_identity(q);
		return;
	}
	scale = 1 / scalar_sqrt(length2);
	for (int i = 0; i < 4; i++) {
		q[i] *= scale;
	}
}

void quat_multiply(const float a[4], const float b[4], float out[4])
{
	float x = a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1];
	float y = a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0];
	float z = a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3];
	float w = a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2];

	out[0] = x;
	out[1] = y;
	out[2] = z;
	out[3] = w;
}

void quat_conjugate(const float q[4], float out[4])
{
	out[0] = -q[0];
	out[1] = -q[1];
	out[2] = -q[2];
	out[3] = q[3];
}

/* v + 2 w (u x v) + 2 u x (u x v), u being the vector part. */
void quat_rotate(const float q[4], const float v[3], float out[3])
{
	float once[3], twice[3];

	vec_cross(q, v, once);
	vec_cross(q, once, twice);
	for (int i = 0; i < 3; i++) {
		out[i] = v[i] + 2 * (q[3] * once[i] + twice[i]);
	}
}

void quat_from_axis_angle(const float axis[3], float angle_rad, float out[4])
{
	float sine = scalar_sin(0.5f * angle_rad);

	for (int i = 0; i < 3; i++) {
		out[i] = axis[i] * sine;
	}
	out[3] = scalar_cos(0.5f * angle_rad);
}

/* Half a turn about some axis at right angles to a unit direction. */
static void half_turn(const float direction[3], float out[4])
{
	float least[3] = {0, 0, 0};
	int i = scalar_abs(direction[1]) < scalar_abs(direction[0]) ? 1 : 0;

	i = scalar_abs(direction[2]) < scalar_abs(direction[i]) ? 2 : i;
	least[i] = 1;
	vec_cross(direction, least, out);
	out[3] = 0;
	quat_normalize(out);
}

void quat_between(const float from[3], const float to[3], float out[4])
{
	float a[3] = {from[0], from[1], from[2]};
	float b[3] = {to[0], to[1], to[2]};
	float cosine;

	if (vec_normalize(a) == 0 || vec_normalize(b) == 0) {
		quat_set_identity(out);
		return;
	}
	cosine = vec_dot(a, b);
	if (cosine < -0.999999f) {
		half_turn(a, out);
		return;
	}
	/* (a x b, 1 + a.b) is the wanted rotation, not yet of unit length. */
	vec_cross(a, b, out);
	out[3] = 1 + cosine;
	quat_normalize(out);
}

void quat_from_slope(float rise_x, float rise_z, float out[4])
{
	/* As quat_between() of up and the normal (-rise_x, 1, -rise_z). */
	out[0] = -rise_z;
	out[1] = 0;
	out[2] = rise_x;
	out[3] = 1 + scalar_sqrt(1 + rise_x * rise_x + rise_z * rise_z);
	quat_normalize(out);
}

float quat_angle(const float q[4])
{
	return 2 * scalar_atan2(vec_length(q), scalar_abs(q[3]));
}

bool quat_limit(float q[4], const float base[4], float limit_rad)
{
	static const float identity[4] = {0, 0, 0, 1};
	float turn[4];
	float angle;

	quat_conjugate(base, turn);
	quat_multiply(turn, q, turn);
	angle = quat_angle(turn);
	if (angle <= limit_rad) {
		return false;
	}
	quat_slerp(identity, turn, limit_rad > 0 ? limit_rad / angle : 0, turn);
	quat_multiply(base, turn, q);
	quat_normalize(q);
	return true;
}
