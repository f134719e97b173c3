/*
 * Elementary functions of floats without the C library's maths.
 *
 * Debian's armel C library computes these in software floating point, at
 * hundreds of instructions a call. The polynomials here cost a few dozen,
 * give the same result on every machine, and state their error. None of them
 * gives a NaN for any argument.
 */
#ifndef PLATFORM_BASE_SCALAR_H
#define PLATFORM_BASE_SCALAR_H

#include <math.h>

#define SCALAR_PI 3.14159265358979f

/*
 * Within 2e-6 for |angle_rad| up to 8192, beyond it precision fades; from
 * 2^30 on, and for NaN, the angle counts as 0.
 */
float scalar_sin(float angle_rad);
float scalar_cos(float angle_rad);

/* Within 2e-6; the argument is clamped to -1..1. NaN counts as 1. */
float scalar_acos(float cosine);

/* The angle of (x, y) in -pi..pi, within 2e-6; 0 for the origin. */
float scalar_atan2(float y, float x);

/* The largest whole number that is not above value. */
float scalar_floor(float value);

/*
 * e to the power of value, within 1e-6 of the result; 0 up to -87 and for NaN,
 * the largest float above 88.
 */
float scalar_exp(float value);

/*
 * The processor's own square root; negative arguments and NaN give 0. With
 * -fno-math-errno compilers turn sqrtf into one instruction.
 */
static inline float scalar_sqrt(float value)
{
	return value > 0 ? sqrtf(value) : 0;
}

static inline float scalar_abs(float value)
{
	return value < 0 ? -value : value;
}

/* value limited to low..high; NaN gives low. */
static inline float scalar_clamp(float value, float low, float high)
{
	if (value > high) {
		return high;
	}
	return value > low ? value : low;
}

#endif
