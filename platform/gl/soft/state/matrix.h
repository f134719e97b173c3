/*
 * Matrices of the soft driver.
 *
 * They are floats: a call needs few operations of them, and the core has VFP.
 * Vertices are transformed by struct view, in fixed point.
 */
#ifndef PLATFORM_GL_SOFT_STATE_MATRIX_H
#define PLATFORM_GL_SOFT_STATE_MATRIX_H

#include "platform/gl/soft/soft.h"
#include <string.h>

extern const struct matrix soft_matrix_identity;

/* Sets each stack to a single identity matrix. */
void soft_init_matrices(struct matrices *matrices);

struct matrix soft_matrix_multiply(
	const struct matrix *a, const struct matrix *b);

/* out = m v. */
static inline void soft_matrix_transform(
	const struct matrix *m, const float v[4], float out[4])
{
	for (int row = 0; row < 4; row++) {
		out[row] = m->m[row] * v[0] + m->m[4 + row] * v[1] +
			m->m[8 + row] * v[2] + m->m[12 + row] * v[3];
	}
}

/*
 * The transposed inverse of the upper left 3x3, column-major, which transforms
 * normals. A singular matrix gives zeros.
 */
void soft_matrix_normal(const struct matrix *m, float out[9]);

/* Divides a vector by its length, unless that is 0. */
void soft_matrix_normalize(float v[3]);

/*
 * The length of the three axes (columns), if they are at right angles and
 * equally long, within 2^-10; else 0.
 */
float soft_matrix_uniform_scale(const struct matrix *m);

/* The largest magnitude of some values. */
float soft_matrix_largest(const float *values, int count);

/* The exponent e of a float: 2^e <= |value| < 2^(e+1); -127 for 0. */
int soft_matrix_exponent(float value);

/* Rounds towards zero, within +-2^30; NaN counts as -2^30. */
static inline int32_t soft_matrix_to_int(float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	if (bits << 1 < 157u << 24) { /* the exponent is below 30 */
		return (int32_t)value;
	}
	return value > 0.0f ? 1 << 30 : -(1 << 30);
}

/* 2^exponent, for -126..127. */
float soft_matrix_power_of_two(int exponent);

#endif
