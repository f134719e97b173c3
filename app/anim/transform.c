#include "app/anim/transform.h"

#include "platform/base/scalar.h"

#include <string.h>

struct transform transform_identity(void)
{
	return (struct transform){
		.rotation = {0, 0, 0, 1},
		.scale = {1, 1, 1},
	};
}

void transform_to_matrix(const struct transform *transform, mat4 out)
{
	const float *q = transform->rotation;
	const float *s = transform->scale;
	float x2 = q[0] + q[0], y2 = q[1] + q[1], z2 = q[2] + q[2];
	float xx = q[0] * x2, xy = q[0] * y2, xz = q[0] * z2;
	float yy = q[1] * y2, yz = q[1] * z2, zz = q[2] * z2;
	float wx = q[3] * x2, wy = q[3] * y2, wz = q[3] * z2;

	out[0][0] = (1 - (yy + zz)) * s[0];
	out[0][1] = (xy + wz) * s[0];
	out[0][2] = (xz - wy) * s[0];
	out[0][3] = 0;
	out[1][0] = (xy - wz) * s[1];
	out[1][1] = (1 - (xx + zz)) * s[1];
	out[1][2] = (yz + wx) * s[1];
	out[1][3] = 0;
	out[2][0] = (xz + wy) * s[2];
	out[2][1] = (yz - wx) * s[2];
	out[2][2] = (1 - (xx + yy)) * s[2];
	out[2][3] = 0;
	memcpy(out[3], transform->translation, sizeof(transform->translation));
	out[3][3] = 1;
}

void transform_compose(const struct transform *parent,
	const struct transform *child, struct transform *out)
{
	struct transform result;
	float moved[3];

	for (int i = 0; i < 3; i++) {
		moved[i] = parent->scale[i] * child->translation[i];
		result.scale[i] = parent->scale[i] * child->scale[i];
	}
	quat_rotate(parent->rotation, moved, moved);
	vec_add_scaled(parent->translation, moved, 1, result.translation);
	quat_multiply(parent->rotation, child->rotation, result.rotation);
	*out = result;
}

void transform_mix(const struct transform *a, const struct transform *b,
	float t, struct transform *out)
{
	vec_mix(a->translation, b->translation, t, out->translation);
	vec_mix(a->scale, b->scale, t, out->scale);
	quat_slerp(a->rotation, b->rotation, t, out->rotation);
}

void matrix_multiply(mat4 a, mat4 b, mat4 out)
{
	mat4 result;

	for (int c = 0; c < 4; c++) {
		for (int r = 0; r < 3; r++) {
			result[c][r] = a[0][r] * b[c][0] + a[1][r] * b[c][1] +
				a[2][r] * b[c][2];
		}
		result[c][3] = 0;
	}
	for (int r = 0; r < 3; r++) {
		result[3][r] += a[3][r];
	}
	result[3][3] = 1;
	memcpy(out, result, sizeof(result));
}

void matrix_apply(mat4 matrix, const float point[3], float out[3])
{
	float moved[3];

	matrix_turn(matrix, point, moved);
	vec_add_scaled(moved, matrix[3], 1, out);
}

void matrix_turn(mat4 matrix, const float direction[3], float out[3])
{
	float x = direction[0], y = direction[1], z = direction[2];

	for (int r = 0; r < 3; r++) {
		out[r] = matrix[0][r] * x + matrix[1][r] * y + matrix[2][r] * z;
	}
}

/* Of a proper rotation matrix: the largest of the four parts comes first. */
static void quat_from_columns(float m[3][3], float out[4])
{
	float trace = m[0][0] + m[1][1] + m[2][2];
	int i = 0;
	int j, k;
	float root;

	if (trace > 0) {
		root = scalar_sqrt(trace + 1);
		out[3] = 0.5f * root;
		root = 0.5f / root;
		out[0] = (m[1][2] - m[2][1]) * root;
		out[1] = (m[2][0] - m[0][2]) * root;
		out[2] = (m[0][1] - m[1][0]) * root;
		return;
	}
	i = m[1][1] > m[0][0] ? 1 : 0;
	i = m[2][2] > m[i][i] ? 2 : i;
	j = (i + 1) % 3;
	k = (i + 2) % 3;
	root = scalar_sqrt(m[i][i] - m[j][j] - m[k][k] + 1);
	out[i] = 0.5f * root;
	root = root > 0 ? 0.5f / root : 0;
	out[3] = (m[j][k] - m[k][j]) * root;
	out[j] = (m[i][j] + m[j][i]) * root;
	out[k] = (m[i][k] + m[k][i]) * root;
}

void matrix_rotation(mat4 matrix, float out[4])
{
	static const float identity[4] = {0, 0, 0, 1};
	float columns[3][3];
	float normal[3];
	float shortest = 1;

	for (int c = 0; c < 3; c++) {
		memcpy(columns[c], matrix[c], sizeof(columns[c]));
		shortest = vec_normalize(columns[c]) > 0 ? shortest : 0;
	}
	if (shortest == 0) {
		memcpy(out, identity, sizeof(identity));
		return;
	}
	/* A mirrored frame is no rotation: turn its third axis round. */
	vec_cross(columns[0], columns[1], normal);
	if (vec_dot(normal, columns[2]) < 0) {
		for (int i = 0; i < 3; i++) {
			columns[2][i] = -columns[2][i];
		}
	}
	quat_from_columns(columns, out);
	quat_normalize(out);
}

static float length2_of(const float q[4])
{
	return vec_dot(q, q) + q[3] * q[3];
}

/*
 * Below 1.8 degrees: along the chord, then out to the arc by one step of
 * Newton's 1/sqrt. Keeps the length of the inputs, which is near 1.
 */
static void mix_near(
	const float a[4], const float b[4], float from, float to, float out[4])
{
	float wanted2 = length2_of(a) +
		(length2_of(b) - length2_of(a)) * scalar_abs(to);
	float fix;

	for (int i = 0; i < 4; i++) {
		out[i] = a[i] * from + b[i] * to;
	}
	fix = 1 + 0.5f * (wanted2 - length2_of(out));
	for (int i = 0; i < 4; i++) {
		out[i] *= fix;
	}
}

void quat_slerp(const float a[4], const float b[4], float t, float out[4])
{
	float cosine = vec_dot(a, b) + a[3] * b[3];
	float side = cosine < 0 ? -1 : 1;
	float angle, inverse_sine, from, to;

	cosine *= side;
	if (cosine > 0.9995f) {
		mix_near(a, b, 1 - t, t * side, out);
		return;
	}
	angle = scalar_acos(cosine);
	inverse_sine = 1 / scalar_sin(angle);
	from = scalar_sin((1 - t) * angle) * inverse_sine;
	to = scalar_sin(t * angle) * inverse_sine * side;
	for (int i = 0; i < 4; i++) {
		out[i] = a[i] * from + b[i] * to;
	}
}

void quat_normalize(float q[4])
{
	static const float identity[4] = {0, 0, 0, 1};
	float length2 = length2_of(q);
	float scale;

	if (!(length2 > 1e-30f && length2 < 1e30f)) {
		memcpy(q, identity, sizeof(identity));
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
		memcpy(out, (const float[4]){0, 0, 0, 1}, 4 * sizeof(*out));
		return;
	}
	cosine = vec_dot(a, b);
	if (cosine < -0.999999f) {
		half_turn(a, out);
		return;
	}
	/* (a x b, 1 + a.b) is the half angle's quaternion, times a length. */
	vec_cross(a, b, out);
	out[3] = 1 + cosine;
	quat_normalize(out);
}

float quat_angle(const float q[4])
{
	return 2 * scalar_atan2(vec_length(q), scalar_abs(q[3]));
}

float vec_dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

float vec_length(const float v[3])
{
	return scalar_sqrt(vec_dot(v, v));
}

void vec_cross(const float a[3], const float b[3], float out[3])
{
	float x = a[1] * b[2] - a[2] * b[1];
	float y = a[2] * b[0] - a[0] * b[2];
	float z = a[0] * b[1] - a[1] * b[0];

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

void vec_subtract(const float a[3], const float b[3], float out[3])
{
	for (int i = 0; i < 3; i++) {
		out[i] = a[i] - b[i];
	}
}

void vec_add_scaled(
	const float a[3], const float b[3], float factor, float out[3])
{
	for (int i = 0; i < 3; i++) {
		out[i] = a[i] + b[i] * factor;
	}
}

void vec_mix(const float a[3], const float b[3], float t, float out[3])
{
	for (int i = 0; i < 3; i++) {
		out[i] = a[i] * (1 - t) + b[i] * t;
	}
}

float vec_normalize(float v[3])
{
	float length = vec_length(v);
	float scale;

	if (!(length > 1e-18f)) {
		return 0;
	}
	scale = 1 / length;
	for (int i = 0; i < 3; i++) {
		v[i] *= scale;
	}
	return length;
}
