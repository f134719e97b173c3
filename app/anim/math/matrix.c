#include "app/anim/math/matrix.h"

#include "app/anim/math/quat.h"
#include "app/anim/math/transform_inline.h"
#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

#include <string.h>

void matrix_multiply(mat4 a, mat4 b, mat4 out)
{
	inline_matrix_multiply(a, b, out);
}

void matrix_apply(mat4 matrix, const float point[3], float out[3])
{
	float moved[3];

	matrix_apply_direction(matrix, point, moved);
	vec_add_scaled(moved, matrix[3], 1, out);
}

void matrix_apply_direction(mat4 matrix, const float direction[3], float out[3])
{
	float x = direction[0], y = direction[1], z = direction[2];

	for (int r = 0; r < 3; r++) {
		out[r] = matrix[0][r] * x + matrix[1][r] * y + matrix[2][r] * z;
	}
}

/*
 * Converts a proper rotation matrix to a quaternion. The largest of the four
 * components is computed by a square root and divides the others, so that no
 * divisor is small.
 */
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
	float columns[3][3];
	float normal[3];
	float shortest = 1;

	for (int c = 0; c < 3; c++) {
		memcpy(columns[c], matrix[c], sizeof(columns[c]));
		shortest = vec_normalize(columns[c]) > 0 ? shortest : 0;
	}
	if (shortest == 0) {
		quat_set_identity(out);
		return;
	}
	/* A mirrored frame is no rotation, so its third axis is reversed. */
	vec_cross(columns[0], columns[1], normal);
	if (vec_dot(normal, columns[2]) < 0) {
		for (int i = 0; i < 3; i++) {
			columns[2][i] = -columns[2][i];
		}
	}
	quat_from_columns(columns, out);
	quat_normalize(out);
}

float matrix_scale(const mat4 *matrix)
{
	return vec_length((*matrix)[0]);
}

float matrix_greatest_scale(const mat4 *matrix, int count)
{
	float max = 0.0f;

	for (int i = 0; i < count; i++) {
		for (int column = 0; column < 3; column++) {
			const float *axis = matrix[i][column];
			float square = vec_dot(axis, axis);

			max = square > max ? square : max;
		}
	}
	return scalar_sqrt(max);
}

bool matrix_is_even(const mat4 *matrix)
{
	const vec4 *m = *matrix;
	float size = vec_dot(m[0], m[0]);
	float tolerance = size * (1.0f / 256);

	for (int c = 0; c < 3; c++) {
		if (!(scalar_abs(vec_dot(m[c], m[c]) - size) <= 2 * tolerance) ||
			!(scalar_abs(vec_dot(m[c], m[(c + 1) % 3])) <=
				tolerance)) {
			return false;
		}
	}
	return true;
}

/* The sum of the squares of all elements. */
static float square_of(float column[3][3])
{
	return vec_dot(column[0], column[0]) + vec_dot(column[1], column[1]) +
		vec_dot(column[2], column[2]);
}

static inline void scale_column(
	const float column[3], float factor, float out[3])
{
	out[0] = column[0] * factor;
	out[1] = column[1] * factor;
	out[2] = column[2] * factor;
}

static inline float size_of(const float column[3])
{
	return scalar_abs(column[0]) + scalar_abs(column[1]) +
		scalar_abs(column[2]);
}

void matrix_normals(const mat4 *matrix, mat4 *out)
{
	const vec4 *m = *matrix;
	/* The columns are divided by size so that no product overflows. */
	float size = size_of(m[0]) + size_of(m[1]) + size_of(m[2]) + 1e-30f;
	float column[3][3], cofactor[3][3];
	float factor = 1 / size, square;

	scale_column(m[0], factor, column[0]);
	scale_column(m[1], factor, column[1]);
	scale_column(m[2], factor, column[2]);
	vec_cross(column[1], column[2], cofactor[0]);
	vec_cross(column[2], column[0], cofactor[1]);
	vec_cross(column[0], column[1], cofactor[2]);
	square = square_of(cofactor);
	memcpy(*out, *matrix, sizeof(*out));
	if (!(square > 1e-20f)) {
		return;
	}
	factor = size * scalar_sqrt(square_of(column) / square);
	factor = vec_dot(column[0], cofactor[0]) < 0 ? -factor : factor;
	scale_column(cofactor[0], factor, (*out)[0]);
	scale_column(cofactor[1], factor, (*out)[1]);
	scale_column(cofactor[2], factor, (*out)[2]);
	memset((*out)[3], 0, sizeof(float[3]));
}

float matrix_determinant(const mat4 *matrix)
{
	float cross[3];

	vec_cross((*matrix)[0], (*matrix)[1], cross);
	return vec_dot(cross, (*matrix)[2]);
}
