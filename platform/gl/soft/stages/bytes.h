/*
 * Arithmetic on the four bytes of a word at once: one ARMv6 instruction each,
 * or C with the same results.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_BYTES_H
#define PLATFORM_GL_SOFT_STAGES_BYTES_H

#include "platform/gl/soft/span/halves.h"

#ifdef __ARM_FEATURE_SIMD32
/* a + b limited to 255, and a - b limited to 0, of each unsigned byte */
#define BYTES_ADD_LIMITED(a, b)  ((uint32_t)__uqadd8(a, b))
#define BYTES_LESS_LIMITED(a, b) ((uint32_t)__uqsub8(a, b))
#elif SOFT_LANES == 1
static inline uint32_t soft_bytes_add_limited(uint32_t a, uint32_t b)
{
	const uint32_t top = 0x80808080;
	uint32_t sum = ((a & ~top) + (b & ~top)) ^ ((a ^ b) & top);
	uint32_t over = ((a & b) | ((a | b) & ~sum)) & top;

	return sum | ((over << 1) - (over >> 7));
}

#define BYTES_ADD_LIMITED(a, b)  soft_bytes_add_limited(a, b)
#define BYTES_LESS_LIMITED(a, b) (~soft_bytes_add_limited(~(a), b))
#endif

/* a * b + 128 of each half, 16 bits; and a * x + b * y + 128 */
#if SOFT_LANES == 1
#define HALVES_BY_HALVES(a, b) \
	((uint32_t)HALVES_BB(a, b, 128) | (uint32_t)HALVES_TT(a, b, 128) << 16)
#define HALVES_MIX(a, x, b, y)                             \
	((uint32_t)HALVES_BB(a, x, HALVES_BB(b, y, 128)) | \
		(uint32_t)HALVES_TT(a, x, HALVES_TT(b, y, 128)) << 16)
#else
#define HALVES_BY_HALVES(a, b) (HALVES_TIMES(a, b) + 0x00800080)
#define HALVES_MIX(a, x, b, y) \
	(HALVES_TIMES(a, x) + HALVES_TIMES(b, y) + 0x00800080)
#endif

/* Divides two 16-bit products of bytes, 128 added, by 255: bytes 0 and 2. */
static ALWAYS_INLINE soft_word soft_divide_lanes(soft_word product)
{
	return ODD_BYTES_AS_HALVES(product + ODD_BYTES_AS_HALVES(product));
}

/* color * by / 255 of each byte, rounded. */
static ALWAYS_INLINE soft_word soft_scale_bytes(soft_word color, soft_word by)
{
	const soft_word twice = HALVES_TWICE(by);
	const uint32_t half = 0x00800080;
	soft_word rb = HALVES_TIMES(BYTES_AS_HALVES(color), twice);
	soft_word ga = HALVES_TIMES(ODD_BYTES_AS_HALVES(color), twice);

	return soft_divide_lanes(rb + half) | soft_divide_lanes(ga + half) << 8;
}

/* a * b / 255 of each byte, rounded. */
static ALWAYS_INLINE soft_word soft_multiply_bytes(soft_word a, soft_word b)
{
	soft_word a_rb = BYTES_AS_HALVES(a), a_ga = ODD_BYTES_AS_HALVES(a);
	soft_word b_rb = BYTES_AS_HALVES(b), b_ga = ODD_BYTES_AS_HALVES(b);

	return soft_divide_lanes(HALVES_BY_HALVES(a_rb, b_rb)) |
		soft_divide_lanes(HALVES_BY_HALVES(a_ga, b_ga)) << 8;
}

/* Blends each byte of to with own by alpha / 255, rounded. */
static ALWAYS_INLINE soft_word soft_blend_bytes(
	soft_word to, soft_word own, soft_word alpha)
{
	const uint32_t half = 0x00800080;
	const soft_word by = HALVES_TWICE(alpha),
			rest = HALVES_TWICE(255 - alpha);
	soft_word rb = HALVES_TIMES(BYTES_AS_HALVES(own), by) +
		HALVES_TIMES(BYTES_AS_HALVES(to), rest);
	soft_word ga = HALVES_TIMES(ODD_BYTES_AS_HALVES(own), by) +
		HALVES_TIMES(ODD_BYTES_AS_HALVES(to), rest);

	return soft_divide_lanes(rb + half) | soft_divide_lanes(ga + half) << 8;
}

#endif
