/*
 * Products of halves of words: one instruction of ARMv6 each, by
 * arm_acle.h, and the same bits in C elsewhere. No sum overflows where these
 * are used.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_HALVES_H
#define PLATFORM_GL_SOFT_SPAN_HALVES_H

#include <stdint.h>

#include "platform/gl/soft/span/vectors.h"

#ifdef __ARM_FEATURE_DSP
/* bottom a * bottom b + top a * top b */
#define HALVES_SUM(a, b) ((uint32_t)__smuad((int32_t)(a), (int32_t)(b)))
/* the same added to sum */
#define HALVES_SUM_ADD(a, b, sum) \
	((uint32_t)__smlad((int32_t)(a), (int32_t)(b), (int32_t)(sum)))
/* (word * bottom half >> 16) + sum, (word * top half >> 16) + sum */
#define WORD_BY_BOTTOM(word, half, sum) \
	__smlawb((int32_t)(word), (int32_t)(half), sum)
#define WORD_BY_TOP(word, half, sum) \
	__smlawt((int32_t)(word), (int32_t)(half), sum)
/* a + b of both halves, unsigned, 65535 at most */
#define HALVES_ADD_LIMITED(a, b) ((uint32_t)__uqadd16(a, b))
/* The upper half of a, and that of b below it */
static inline uint32_t soft_upper_halves(int32_t a, int32_t b)
{
	uint32_t halves;

	__asm__("pkhtb %0, %1, %2, asr #16" : "=r"(halves) : "r"(a), "r"(b));
	return halves;
}
#define UPPER_HALVES(a, b) soft_upper_halves(a, b)
/* Found where it is wanted, not kept in a register from before */
static inline uint32_t soft_upper_half(uint32_t word)
{
	uint32_t half;

	__asm__("lsr %0, %1, #16" : "=r"(half) : "r"(word));
	return half;
}
#define UPPER_HALF(word) soft_upper_half(word)
#else
static inline uint32_t soft_halves_sum(uint32_t a, uint32_t b)
{
	return (uint32_t)((int16_t)a * (int16_t)b +
		((int32_t)a >> 16) * ((int32_t)b >> 16));
}

static inline int32_t soft_word_by_half(uint32_t word, uint32_t half)
{
	return (int32_t)((int64_t)(int32_t)word * (int16_t)half >> 16);
}

static inline uint32_t soft_halves_add_limited(uint32_t a, uint32_t b)
{
	uint32_t low = (a & 0xFFFF) + (b & 0xFFFF), high = (a >> 16) + (b >> 16);

	return (high > 0xFFFF ? 0xFFFF : high) << 16 |
		(low > 0xFFFF ? 0xFFFF : low);
}

#define UPPER_HALF(word)          ((word) >> 16)
#define UPPER_HALVES(a, b)        (((uint32_t)(a)&0xFFFF0000) | (uint32_t)(b) >> 16)
#define HALVES_ADD_LIMITED(a, b)  soft_halves_add_limited(a, b)
#define HALVES_SUM(a, b)          soft_halves_sum(a, b)
#define HALVES_SUM_ADD(a, b, sum) (soft_halves_sum(a, b) + (sum))
#define WORD_BY_BOTTOM(word, half, sum) \
	(soft_word_by_half((uint32_t)(word), half) + (sum))
#define WORD_BY_TOP(word, half, sum) \
	(soft_word_by_half((uint32_t)(word), (half) >> 16) + (sum))
#endif

#endif
