/*
 * Fixed-point arithmetic of the soft driver: 32-bit operands, 64-bit products,
 * no division.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_NUMBER_H
#define PLATFORM_GL_SOFT_VERTEX_NUMBER_H

#include <stdint.h>

#include "platform/base/compiler.h"

/* Q15: 1 / x at the middle of the i-th 256th of 0.5..1, 2^25 / (513 + 2 i). */
extern const uint16_t soft_reciprocal_table[256] OWN_DATA;

/* The upper 32 bits of the 64-bit product, rounded down. */
static inline int32_t mul_high(int32_t a, int32_t b)
{
	return multiply_high(a, b);
}

/* sum + mul_high(a, b); wraps around. */
static inline int32_t mul_high_add(int32_t sum, int32_t a, int32_t b)
{
	return multiply_add_high(sum, a, b);
}

static inline uint32_t mul_high_unsigned(uint32_t a, uint32_t b)
{
	return (uint32_t)(((uint64_t)a * b) >> 32);
}

/*
 * 2^62 / value, for a value with its top bit set. The error is at most 32,
 * which is 2^-25 of the result; the result is at most 2^31 - 1.
 */
static inline int32_t reciprocal(uint32_t value)
{
	/* r = 1/v in Q30 from 8 bits, then r (2 - v r) twice: 16, 31 bits. */
	uint32_t r = (uint32_t)soft_reciprocal_table[value >> 23 & 255] << 15;

	r = mul_high_unsigned(r, (1u << 31) - mul_high_unsigned(value, r)) << 2;
	r = mul_high_unsigned(r, (1u << 31) - mul_high_unsigned(value, r)) << 2;
	return (int32_t)(r > INT32_MAX ? INT32_MAX : r);
}

/* value * 2^shift for any shift, rounded down; to the left it wraps around. */
static inline int32_t shift_by(int32_t value, int shift)
{
	if (shift >= 0) {
		return shift < 32 ? (int32_t)((uint32_t)value << shift) : 0;
	}
	return value >> (shift > -31 ? -shift : 31);
}

static inline int32_t clamp_int(int32_t value, int32_t low, int32_t high)
{
	return value < low ? low : value > high ? high : value;
}

/* Converts a colour or fog of 0 to 1, 16.16, to an attribute: 0x80 to 0xFF80. */
static ALWAYS_INLINE int32_t to_attribute(int32_t value_q16)
{
	value_q16 = LIMIT_TO_BITS(value_q16, 16);
	return 128 + value_q16 - (value_q16 >> 8);
}

static inline int32_t saturate_64(int64_t value)
{
	const int32_t low = (int32_t)value;

	return low == value && low != INT32_MIN ? low
		: value > 0                     ? INT32_MAX
						: -INT32_MAX;
}

/* 1 / sqrt((64.5 + i) / 256) in Q15. */
extern const uint16_t soft_root_table[192] OWN_DATA;

/* 1 / sqrt(value) in Q28, of 0.25 to 1 in Q32: by a table and two Newton steps. */
static inline uint32_t reciprocal_root(uint32_t value)
{
	uint32_t r = (uint32_t)soft_root_table[(value >> 24) - 64] << 13;

	/* r (3 - v r^2) / 2, twice: 7 bits become 14, then 28. */
	for (int i = 0; i < 2; i++) {
		uint32_t product_q24 =
			mul_high_unsigned(mul_high_unsigned(r, r), value);

		r = mul_high_unsigned(r, (3u << 24) - product_q24) << 7;
	}
	return r;
}

/* 1 / sqrt(value) of a 64-bit number above 0. */
struct root {
	int32_t mantissa_q30; /* 2^29..2^30 */
	int shift;            /* the result is mantissa_q30 / 2^(30 + shift) */
};
struct root soft_reciprocal_root(uint64_t value);

/* base ^ exponent, base in 0..1, exponent >= 0; the result is Q28. */
int32_t soft_power_q28(int32_t base_q28, int32_t exponent_q16);

/* dx / dy in Q16, |dx| < 2^18, dy > 0; limited to +-(2^31 - 1). */
int32_t soft_slope_q16(int32_t dx, int32_t dy);

/*
 * The largest magnitude of count elements of size floats each, as the float's
 * bits shifted left by one, so without the sign.
 */
uint32_t soft_largest_float(
	const uint8_t *at, int stride_bytes, uint32_t count, int size);
/* arm/largest_float.S or portable/loops.c: the same of three aligned floats. */
uint32_t soft_largest_aligned_float(
	const uint8_t *at, int stride_bytes, uint32_t count);

#endif
