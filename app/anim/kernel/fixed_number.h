/*
 * Conversion from float to 16 bits, without the C library's maths.
 */
#ifndef APP_ANIM_KERNEL_FIXED_NUMBER_H
#define APP_ANIM_KERNEL_FIXED_NUMBER_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

/*
 * The largest number <= value, above 0, that is 1, 1.25, 1.5 or 1.75 times a
 * power of two.
 */
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
 * A faster way for values that are known to be within -32767..32767. Ties go to
 * the even number.
 */
static inline int16_t fixed_round_fast(float value)
{
	const float magic = 12582912.0f; /* 1.5 * 2^23 leaves no bits below 1 */
	float sum = value + magic;
	uint32_t bits;

	memcpy(&bits, &sum, sizeof(bits));
	return (int16_t)(bits & 0xffff);
}

/*
 * An integer with the order of floats: -0 is below 0, and NaNs are beyond
 * infinity. fixed_float_of() is its inverse.
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

/* Whether a value is no NaN and well within float's range. */
static inline bool fixed_can_use(float value)
{
	return value > -1e18f && value < 1e18f;
}

#endif
