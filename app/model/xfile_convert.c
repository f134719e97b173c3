#include "app/model/xfile_convert.h"

#include <math.h>
#include <string.h>

/* Taken from 0, so that 0 stays 0 and does not become -0. */
void xfile_convert_vector(const float in[3], float out[3])
{
	out[0] = in[0];
	out[1] = in[1];
	out[2] = 0.0f - in[2];
}

/* A row of the file is a column of the model: both lie in the same order. */
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

static double dot(const double a[3], const double b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double out[3])
{
	out[0] = a[1] * b[2] - a[2] * b[1];
	out[1] = a[2] * b[0] - a[0] * b[2];
	out[2] = a[0] * b[1] - a[1] * b[0];
}

/* False, and nothing changed, for what is almost a point. */
static bool normalize(double v[3])
{
	double length = sqrt(dot(v, v));

	if (!(length > 1e-12)) {
		return false;
	}
	for (int i = 0; i < 3; i++) {
		v[i] /= length;
	}
	return true;
}

/* A unit vector at right angles to a unit vector. */
static void perpendicular(const double v[3], double out[3])
{
	int least = fabs(v[0]) < fabs(v[1]) ? 0 : 1;
	double axis[3] = {0};

	least = fabs(v[2]) < fabs(v[least]) ? 2 : least;
	axis[least] = 1;
	cross(v, axis, out);
	normalize(out);
}

/* At right angles to the other two columns, as far as there are any. */
static void find_first_axis(double column[3][3], double out[3])
{
	double along[3];

	cross(column[1], column[2], out);
	if (normalize(out)) {
		return;
	}
	for (int i = 1; i < 3; i++) {
		memcpy(along, column[i], sizeof(along));
		if (normalize(along)) {
			perpendicular(along, out);
			return;
		}
	}
	memcpy(out, (const double[]){1, 0, 0}, 3 * sizeof(*out));
}

/*
 * Three unit vectors at right angles, right-handed, along the columns as far
 * as these allow; columns that are flat or parallel get whatever fits.
 */
static void orthonormalize(double column[3][3], double axis[3][3])
{
	memcpy(axis, column, 9 * sizeof(double));
	if (!normalize(axis[0])) {
		find_first_axis(column, axis[0]);
	}
	for (int i = 0; i < 3; i++) {
		axis[1][i] -= dot(column[1], axis[0]) * axis[0][i];
	}
	if (!normalize(axis[1])) {
		cross(column[2], axis[0], axis[1]);
		if (!normalize(axis[1])) {
			perpendicular(axis[0], axis[1]);
		}
	}
	cross(axis[0], axis[1], axis[2]);
}

/* The largest of w, x, y, z is found first, so that no root nears zero. */
static void quaternion_of(double axis[3][3], float out[4])
{
	double m00 = axis[0][0], m11 = axis[1][1], m22 = axis[2][2];
	double q[4] = {
		1 + m00 - m11 - m22,
		1 - m00 + m11 - m22,
		1 - m00 - m11 + m22,
		1 + m00 + m11 + m22,
	};
	double yz = axis[1][2] + axis[2][1], x_w = axis[1][2] - axis[2][1];
	double xz = axis[2][0] + axis[0][2], y_w = axis[2][0] - axis[0][2];
	double xy = axis[0][1] + axis[1][0], z_w = axis[0][1] - axis[1][0];
	const double row[4][4] = {
		{q[0], xy, xz, x_w},
		{xy, q[1], yz, y_w},
		{xz, yz, q[2], z_w},
		{x_w, y_w, z_w, q[3]},
	};
	int best = 3;
	double length = 0;

	for (int i = 0; i < 3; i++) {
		best = q[i] > q[best] ? i : best;
	}
	for (int i = 0; i < 4; i++) {
		length += row[best][i] * row[best][i];
	}
	for (int i = 0; i < 4; i++) {
		out[i] = (float)(row[best][i] / sqrt(length));
	}
}

/* Whether axes times scales give the columns again. */
static bool is_rebuilt(
	double column[3][3], double axis[3][3], const double scale[3])
{
	double largest = 0;
	double error = 0;

	for (int i = 0; i < 3; i++) {
		largest = fmax(largest, fabs(scale[i]));
		for (int j = 0; j < 3; j++) {
			error = fmax(error,
				fabs(axis[i][j] * scale[i] - column[i][j]));
		}
	}
	return error <= 1e-4 * largest;
}

bool xfile_decompose(const mat4 matrix, struct transform *out)
{
	double column[3][3];
	double axis[3][3];
	double scale[3];

	for (int i = 0; i < 3; i++) {
		for (int j = 0; j < 3; j++) {
			column[i][j] = matrix[i][j];
		}
		scale[i] = sqrt(dot(column[i], column[i]));
		out->translation[i] = matrix[3][i];
	}
	orthonormalize(column, axis);
	if (dot(column[2], axis[2]) < 0) {
		scale[2] = -scale[2];
	}
	for (int i = 0; i < 3; i++) {
		out->scale[i] = (float)scale[i];
	}
	quaternion_of(axis, out->rotation);
	return is_rebuilt(column, axis, scale);
}
