/*
 * Matrices of the soft driver.
 *
 * They are floats: a handful of operations a call, on a core with VFP, and as
 * exact as 16.16 allows. Vertices meet them as fixed point (struct block).
 */
#ifndef PLATFORM_GL_SOFT_STATE_MATRIX_H
#define PLATFORM_GL_SOFT_STATE_MATRIX_H

#include "platform/base/scalar.h"
#include "platform/gl/soft/soft.h"

extern const struct matrix soft_matrix_identity;

/* Stacks of one identity each. */
void soft_init_matrices(struct matrices *matrices);

/* out may be a or b. */
void soft_matrix_multiply(
	const struct matrix *a, const struct matrix *b, struct matrix *out);

/* out = m v. */
void soft_matrix_transform(
	const struct matrix *m, const float v[4], float out[4]);

/*
 * The inverse's transpose of the upper 3x3, column-major: how normals go. A
 * singular matrix gives zeros.
 */
void soft_matrix_normal(const struct matrix *m, float out[9]);

/*
 * The common length of the axes, when they stand at right angles and are
 * equally long within 2^-10; else 0.
 */
float soft_matrix_uniform_scale(const struct matrix *m);

/* 2^shift <= value < 2^(shift+1) of a positive float; -127 for 0. */
int soft_matrix_exponent(float value);

/* The nearest number to zero within 31 bits; NaN counts as the least. */
static inline int32_t soft_matrix_to_int(float value)
{
	return (int32_t)scalar_clamp(value, -1073741824.0f, 1073741824.0f);
}

/* 2^exponent, for -126..127. */
float soft_matrix_power_of_two(int exponent);

#endif
