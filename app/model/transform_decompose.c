#include "app/model/transform_decompose.h"

#include <math.h>

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

/* A unit vector perpendicular to a unit vector. */
static void any_normal(const double unit[3], double out[3])
{
	double axis[3] = {0, 0, 0};
	double length;
	int least = 0;
	int i;

	for (i = 1; i < 3; i++) {
		least = fabs(unit[i]) < fabs(unit[least]) ? i : least;
	}
	axis[least] = 1;
	cross(unit, axis, out);
	length = sqrt(dot(out, out));
	for (i = 0; i < 3; i++) {
		out[i] /= length;
	}
}

/*
 * Makes v perpendicular to a unit vector and of unit length. Returns false if v
 * is parallel to it.
 */
static bool make_perpendicular(double v[3], const double unit[3])
{
	double along = dot(v, unit);
	double length;
	int i;

	for (i = 0; i < 3; i++) {
		v[i] -= along * unit[i];
	}
	length = sqrt(dot(v, v));
	for (i = 0; i < 3 && length > 1e-6; i++) {
		v[i] /= length;
	}
	return length > 1e-6;
}

/*
 * Turns the normalised columns of a matrix, some of which may be zero, into a
 * right-handed rotation. The longest column keeps its direction.
 */
static void orthonormalize(double column[3][3], const double length[3])
{
	int a = length[1] > length[0] ? 1 : 0;
	int b, c;

	a = length[2] > length[a] ? 2 : a;
	b = (a + 1) % 3;
	c = (a + 2) % 3;
	if (length[b] > 0 && make_perpendicular(column[b], column[a])) {
		cross(column[a], column[b], column[c]);
	} else if (length[c] > 0 && make_perpendicular(column[c], column[a])) {
		cross(column[c], column[a], column[b]);
	} else {
		any_normal(column[a], column[b]);
		cross(column[a], column[b], column[c]);
	}
}

/*
 * m[column][row] is a rotation. The largest component is found first, so that
 * the length to divide by is not small.
 */
static void to_quaternion(double m[3][3], float out[4])
{
	double trace = m[0][0] + m[1][1] + m[2][2];
	double q[4];
	double length;
	int i;

	if (trace > 0) {
		q[3] = 1 + trace;
		q[0] = m[1][2] - m[2][1];
		q[1] = m[2][0] - m[0][2];
		q[2] = m[0][1] - m[1][0];
	} else {
		int a = m[1][1] > m[0][0] ? 1 : 0;
		int b, c;

		a = m[2][2] > m[a][a] ? 2 : a;
		b = (a + 1) % 3;
		c = (a + 2) % 3;
		q[a] = 1 + m[a][a] - m[b][b] - m[c][c];
		q[b] = m[a][b] + m[b][a];
		q[c] = m[a][c] + m[c][a];
		q[3] = m[b][c] - m[c][b];
	}
	length = sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
	for (i = 0; i < 4; i++) {
		out[i] = (float)(q[i] / length);
	}
}

static bool is_product(
	const float matrix[4][4], double rotation[3][3], const float scale[3])
{
	double largest = 0;
	double worst = 0;
	int i, k;

	for (i = 0; i < 3; i++) {
		for (k = 0; k < 3; k++) {
			double want = matrix[i][k];
			double got = rotation[i][k] * scale[i];

			largest = fmax(largest, fabs(want));
			worst = fmax(worst, fabs(want - got));
		}
	}
	return worst <= largest * 1e-5;
}

bool transform_decompose(const float matrix[4][4], struct transform *out)
{
	double column[3][3], length[3], rotation[3][3], normal[3];
	double longest;
	double mirror;
	int i, k;

	for (i = 0; i < 3; i++) {
		for (k = 0; k < 3; k++) {
			column[i][k] = matrix[i][k];
		}
		length[i] = sqrt(dot(column[i], column[i]));
		out->translation[i] = matrix[3][i];
	}
	cross(column[0], column[1], normal);
	mirror = dot(normal, column[2]) < 0 ? -1 : 1;
	longest = fmax(length[0], fmax(length[1], length[2]));
	if (!(longest > 0)) {
		*out = (struct transform){
			.translation = {matrix[3][0], matrix[3][1], matrix[3][2]},
			.rotation = {0, 0, 0, 1},
		};
		return true;
	}
	for (i = 0; i < 3; i++) {
		double sign = i == 0 ? mirror : 1;

		for (k = 0; k < 3; k++) {
			rotation[i][k] = length[i] > 0
				? sign * column[i][k] / length[i]
				: 0;
		}
		out->scale[i] = (float)(sign * length[i]);
	}
	orthonormalize(rotation, length);
	to_quaternion(rotation, out->rotation);
	return is_product(matrix, rotation, out->scale);
}
