#include "app/anim/transform.h"
#include "app/anim/transform_inline.h"

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
	inline_transform_to_matrix(transform, out);
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
	inline_matrix_multiply(a, b, out);
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
 * sin(t angle) / sin(angle) as a series in x = cos(angle) - 1 (Eberly, "A Fast
 * and Accurate Algorithm for Computing SLERP"), which needs neither the angle
 * nor a division. Three terms are right to 2e-7 up to 36 degrees of rotation,
 * that is above:
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

void slerp_weights(float x, float t, float weight[2])
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

	/* Not quite unit length would pass for an angle where that is small. */
	if (x > -0.0005f) {
		x = -0.5f * distance2_of(a, b, side);
	}
	slerp_weights(x, t, weight);
	weight[1] *= side;
	set_column(out, a[0] * weight[0] + b[0] * weight[1],
		a[1] * weight[0] + b[1] * weight[1],
		a[2] * weight[0] + b[2] * weight[1],
		a[3] * weight[0] + b[3] * weight[1]);
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
