#include "app/model/xfile/xfile_convert.h"

#include "app/model/transform_decompose.h"

#include <cglm/mat4.h>
#include <cglm/quat.h>
#include <math.h>
#include <string.h>

/* 0 - x instead of -x keeps 0 from becoming -0. */
void xfile_convert_vector(const float in[3], float out[3])
{
	out[0] = in[0];
	out[1] = in[1];
	out[2] = 0.0f - in[2];
}

/* A row-major matrix and its column-major transpose have the same order. */
void xfile_convert_matrix(const float in[16], mat4 out)
{
	for (int column = 0; column < 4; column++) {
		for (int row = 0; row < 3; row++) {
			float value = in[4 * column + row];

			out[column][row] = (column == 2) != (row == 2)
				? 0.0f - value
				: value;
		}
		out[column][3] = column == 3 ? 1.0f : 0.0f;
	}
}

void xfile_convert_rotation(const float wxyz[4], float out[4])
{
	const double q[4] = {wxyz[1], wxyz[2], -(double)wxyz[3], wxyz[0]};
	double length =
		sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);

	for (int i = 0; i < 4; i++) {
		out[i] = length > 0 ? (float)(q[i] / length)
				    : (i == 3 ? 1.0f : 0.0f);
	}
}

/*
 * Whether a transform equals a matrix to 1e-4 of its largest scale. Exporters
 * write six decimals, and with a small scale their rounding errors must not
 * count as shear.
 */
static bool is_near(const mat4 matrix, const struct transform *transform)
{
	float largest = 0;
	float error = 0;
	mat4 rotation;
	versor q;

	memcpy(q, transform->rotation, sizeof(q));
	glm_quat_mat4(q, rotation);
	for (int i = 0; i < 3; i++) {
		largest = fmaxf(largest, fabsf(transform->scale[i]));
		for (int j = 0; j < 3; j++) {
			error = fmaxf(error,
				fabsf(rotation[i][j] * transform->scale[i] -
					matrix[i][j]));
		}
	}
	return error <= 1e-4f * largest;
}

bool xfile_decompose(const mat4 matrix, struct transform *out)
{
	return transform_decompose(matrix, out) || is_near(matrix, out);
}
