/* Conversions between floats and integers, without the C library's maths. */
#ifndef APP_ANIM_KERNEL_FIXED_NUMBER_H
#define APP_ANIM_KERNEL_FIXED_NUMBER_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/* Rounds a value above 0 down to 1, 1.25, 1.5 or 1.75 times a power of two. */
static inline float fixed_step(float value)
{
	uint32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	bits &= 0xffe00000;
	memcpy(&value, &bits, sizeof(value));
	return value;
}

/* Rounds to the nearest and clamps to -32767..32767. A NaN gives -32767. */
static inline int16_t fixed_round(float value)
{
	if (value >= 32767.0f) {
		return 32767;
	}
	if (!(value > -32767.0f)) {
		return -32767;
	}
	return (int16_t)(value + (value < 0.0f ? -0.5f : 0.5f));
}

/*
 * A faster fixed_round() for values that are known to be within -32767..32767.
 * Halves are rounded to the even number.
 */
static inline int16_t fixed_round_fast(float value)
{
	const float magic = 12582912.0f; /* 1.5 * 2^23: floats of this size are
					    integers */
	float sum = value + magic;
	uint32_t bits;

	memcpy(&bits, &sum, sizeof(bits));
	return (int16_t)(bits & 0xffff);
}

/*
 * Maps a float to an integer so that integers compare as the floats do. -0
 * comes before 0, and a NaN lies beyond the infinity of its sign.
 * fixed_float_of() is the inverse.
 */
static inline int32_t fixed_order_of(float value)
{
	int32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	return bits < 0 ? bits ^ INT32_MAX : bits;
}

static inline float fixed_float_of(int32_t key)
{
	int32_t bits = key < 0 ? key ^ INT32_MAX : key;
	float value;

	memcpy(&value, &bits, sizeof(value));
	return value;
}

/* fixed_order_of() of the absolute value. */
static inline int32_t fixed_order_of_abs(float value)
{
	int32_t bits;

	memcpy(&bits, &value, sizeof(bits));
	return bits & INT32_MAX;
}

/*
 * Whether a value is a number of less than 1e18, so that products stay within
 * the range of float. False for a NaN.
 */
static inline bool fixed_can_use(float value)
{
	return value > -1e18f && value < 1e18f;
}

#endif
