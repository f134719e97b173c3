/*
 * Elementary functions of floats, used instead of the C library's.
 *
 * Debian's armel C library computes them in software floating point, with
 * hundreds of instructions a call. The polynomials here take a few dozen
 * instructions and give the same result on every machine. Except for
 * scalar_floor() and scalar_abs(), none of them returns NaN.
 */
#ifndef PLATFORM_BASE_SCALAR_H
#define PLATFORM_BASE_SCALAR_H

#include <math.h>

#define SCALAR_PI 3.14159265358979f

/*
 * The error is at most 2e-6 for |angle_rad| up to 8192 and grows beyond that.
 * From 2^30 on, and for NaN, the angle is taken as 0.
 */
float scalar_sin(float angle_rad);
float scalar_cos(float angle_rad);

/* The error is at most 2e-6. The argument is clamped to -1..1; NaN gives 0. */
float scalar_acos(float cosine);

/*
 * The angle of (x, y) in -pi..pi; the error is at most 2e-6. 0 for the origin
 * and for arguments that are not finite.
 */
float scalar_atan2(float y, float x);

/* The largest integer that is not above value; NaN gives NaN. */
float scalar_floor(float value);

/*
 * e to the power of value, with a relative error of at most 1e-6. 0 for values
 * up to -87 and for NaN, the largest float for values above 88.
 */
float scalar_exp(float value);

/*
 * The square root; negative arguments and NaN give 0. With -fno-math-errno
 * compilers turn sqrtf() into the processor's instruction.
 */
static inline float scalar_sqrt(float value)
{
	return value > 0 ? sqrtf(value) : 0;
}

static inline float scalar_abs(float value)
{
	return fabsf(value);
}

/* The smaller and the larger one; if a is NaN, b. */
static inline float scalar_min(float a, float b)
{
	return a < b ? a : b;
}

static inline float scalar_max(float a, float b)
{
	return a > b ? a : b;
}

/* value clamped to low..high; NaN gives low. */
static inline float scalar_clamp(float value, float low, float high)
{
	if (value > high) {
		return high;
	}
	return value > low ? value : low;
}

/*
 * The integer part of value, clamped to low..high; NaN gives low. C leaves the
 * conversion of other values undefined, and processors differ in it.
 */
static inline int scalar_to_int(double value, int low, int high)
{
	if (value >= (double)high) {
		return high;
	}
	return value > (double)low ? (int)value : low;
}

#endif
