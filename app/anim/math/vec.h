/*
 * Vectors of three floats.
 *
 * None of these functions calls the C library's maths, which is soft-float on
 * the board. Outputs may alias inputs.
 */
#ifndef APP_ANIM_MATH_VEC_H
#define APP_ANIM_MATH_VEC_H

#include "platform/base/scalar.h"

static inline float vec_dot(const float a[3], const float b[3])
{
	return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static inline float vec_length(const float v[3])
{
	return scalar_sqrt(vec_dot(v, v));
}

static inline void vec_cross(const float a[3], const float b[3], float out[3])
{
	float x = a[1] * b[2] - a[2] * b[1];
	float y = a[2] * b[0] - a[0] * b[2];
	float z = a[0] * b[1] - a[1] * b[0];

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* out = a - b. */
static inline void vec_subtract(const float a[3], const float b[3], float out[3])
{
	float x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* out = a + b * factor. */
static inline void vec_add_scaled(
	const float a[3], const float b[3], float factor, float out[3])
{
	float x = a[0] + b[0] * factor;
	float y = a[1] + b[1] * factor;
	float z = a[2] + b[2] * factor;

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/* out = a * (1 - t) + b * t, which is exactly a at t = 0 and b at t = 1. */
static inline void vec_mix(
	const float a[3], const float b[3], float t, float out[3])
{
	float x = a[0] * (1 - t) + b[0] * t;
	float y = a[1] * (1 - t) + b[1] * t;
	float z = a[2] * (1 - t) + b[2] * t;

	out[0] = x;
	out[1] = y;
	out[2] = z;
}

/*
 * Gives v unit length and returns its former length. A vector of length 1e-18
 * or less, or one with a NaN, is left as it is, and 0 is returned.
 */
float vec_normalize(float v[3]);

#endif
