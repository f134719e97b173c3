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
/* a - b of both halves, each modulo 2^16 */
static inline uint32_t soft_halves_minus(uint32_t a, uint32_t b)
{
	return (uint32_t)__usub16(a, b);
}
#else
static inline uint32_t soft_bytes_add_limited(uint32_t a, uint32_t b)
{
	const uint32_t top = 0x80808080;
	uint32_t sum = ((a & ~top) + (b & ~top)) ^ ((a ^ b) & top);
	uint32_t over = ((a & b) | ((a | b) & ~sum)) & top;

	return sum | ((over << 1) - (over >> 7));
}

static inline uint32_t soft_halves_minus(uint32_t a, uint32_t b)
{
	return ((a & 0xFFFF0000) - (b & 0xFFFF0000)) | ((a - b) & 0xFFFF);
}

#define BYTES_ADD_LIMITED(a, b)  soft_bytes_add_limited(a, b)
#define BYTES_LESS_LIMITED(a, b) (~soft_bytes_add_limited(~(a), b))
#endif

/* Divides two 16-bit products of bytes, 128 added, by 255: bytes 0 and 2. */
static ALWAYS_INLINE uint32_t soft_divide_lanes(uint32_t product)
{
	return ODD_BYTES_AS_HALVES(product + ODD_BYTES_AS_HALVES(product));
}

/* color * by / 255 of each byte, rounded. */
static ALWAYS_INLINE uint32_t soft_scale_bytes(uint32_t color, uint32_t by)
{
#ifdef HAS_COLOR_VECTORS
	return vector_multiply(color, by * 0x01010101);
#else
	const uint32_t half = 0x00800080;

	return soft_divide_lanes(BYTES_AS_HALVES(color) * by + half) |
		soft_divide_lanes(ODD_BYTES_AS_HALVES(color) * by + half) << 8;
#endif
}

/* a * b / 255 of each byte, rounded as scale_byte() does. */
static ALWAYS_INLINE uint32_t soft_multiply_bytes(uint32_t a, uint32_t b)
{
#ifdef HAS_COLOR_VECTORS
	return vector_multiply(a, b);
#else
	uint32_t a_rb = BYTES_AS_HALVES(a), a_ga = ODD_BYTES_AS_HALVES(a);
	uint32_t b_rb = BYTES_AS_HALVES(b), b_ga = ODD_BYTES_AS_HALVES(b);
	uint32_t rb = (uint32_t)HALVES_BB(a_rb, b_rb, 128) |
		(uint32_t)HALVES_TT(a_rb, b_rb, 128) << 16;
	uint32_t ga = (uint32_t)HALVES_BB(a_ga, b_ga, 128) |
		(uint32_t)HALVES_TT(a_ga, b_ga, 128) << 16;

	return soft_divide_lanes(rb) | soft_divide_lanes(ga) << 8;
#endif
}

/* Blends each byte of to with own by alpha / 255, rounded. */
static ALWAYS_INLINE uint32_t soft_blend_bytes(
	uint32_t to, uint32_t own, uint32_t alpha)
{
#ifdef HAS_COLOR_VECTORS
	return vector_blend(to, own, alpha);
#else
	const uint32_t half = 0x00800080, rest = 255 - alpha;
	uint32_t rb = BYTES_AS_HALVES(own) * alpha + BYTES_AS_HALVES(to) * rest;
	uint32_t ga = ODD_BYTES_AS_HALVES(own) * alpha +
		ODD_BYTES_AS_HALVES(to) * rest;

	return soft_divide_lanes(rb + half) | soft_divide_lanes(ga + half) << 8;
#endif
}

#endif
