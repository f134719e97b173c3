/*
 * Products of the signed 16-bit halves of words: one ARMv6 instruction each, by
 * arm_acle.h; elsewhere C with the same results. No caller lets a sum overflow.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_HALVES_H
#define PLATFORM_GL_SOFT_SPAN_HALVES_H

#include <stdint.h>
#include <string.h>

#include "platform/gl/soft/span/vectors.h"

/* A level's texels from first on, and the bytes from row to row. */
struct soft_rows {
	_Alignas(8) const uint8_t *first;
	uint32_t stride;
};

#ifdef __ARM_FEATURE_DSP
/* bottom a * bottom b + top a * top b */
#define HALVES_SUM(a, b) ((uint32_t)__smuad((int32_t)(a), (int32_t)(b)))
/* the same added to sum */
#define HALVES_SUM_ADD(a, b, sum) \
	((uint32_t)__smlad((int32_t)(a), (int32_t)(b), (int32_t)(sum)))
/* sum + (word * half >> 16), of the bottom half, or the top one; TIMES: no sum */
#define WORD_BY_BOTTOM(word, half, sum) \
	__smlawb((int32_t)(word), (int32_t)(half), sum)
static ALWAYS_INLINE uint32_t soft_word_times_bottom(
	uint32_t word, uint32_t half)
{
	uint32_t product;

	__asm__("smulwb %0, %1, %2" : "=r"(product) : "r"(word), "r"(half));
	return product;
}
#define WORD_TIMES_BOTTOM(word, half) soft_word_times_bottom(word, half)
#define WORD_BY_TOP(word, half, sum) \
	__smlawt((int32_t)(word), (int32_t)(half), sum)
/* a + b of both halves, unsigned, limited to 65535 */
#define HALVES_ADD_LIMITED(a, b) ((uint32_t)__uqadd16(a, b))
/* the upper half of a above the lower half of b >> shift, 1 or more */
static ALWAYS_INLINE uint32_t soft_upper_halves(int32_t a, int32_t b, int shift)
{
	uint32_t halves;

	__asm__("pkhtb %0, %1, %2, asr %3"
		: "=r"(halves)
		: "r"(a), "r"(b), "i"(shift));
	return halves;
}
#define UPPER_HALVES(a, b, shift) \
	soft_upper_halves((int32_t)(a), (int32_t)(b), shift)
/* the lower half of b above the lower half of a */
static inline uint32_t soft_lower_halves(int32_t a, int32_t b)
{
	uint32_t halves;

	__asm__("pkhbt %0, %1, %2, lsl #16" : "=r"(halves) : "r"(a), "r"(b));
	return halves;
}
#define LOWER_HALVES(a, b) soft_lower_halves((int32_t)(a), (int32_t)(b))
/* word >> 16, computed where it is used, so that it takes no register before */
static inline uint32_t soft_upper_half(uint32_t word)
{
	uint32_t half;

	__asm__("lsr %0, %1, #16" : "=r"(half) : "r"(word));
	return half;
}
#define UPPER_HALF(word)       soft_upper_half(word)
/* makes the compiler read an object from memory, not keep it in a register */
#define KEEP_IN_MEMORY(object) __asm__("" : "+m"(object))
/* word >> bits, not moved by the compiler before a test that it stands behind */
static ALWAYS_INLINE uint32_t soft_shift_here(uint32_t word, int bits)
{
	uint32_t shifted;

	__asm__ volatile("lsr %0, %1, %2"
			 : "=r"(shifted)
			 : "r"(word), "i"(bits));
	return shifted;
}
#define SHIFT_HERE(word, bits) soft_shift_here(word, bits)
/* word >> shift, limited to 0 to 2^bits - 1 */
static ALWAYS_INLINE uint32_t soft_limit_shifted(
	int32_t word, int shift, int bits)
{
	uint32_t limited;

	__asm__("usat %0, %3, %1, asr %2"
		: "=r"(limited)
		: "r"(word), "i"(shift), "i"(bits));
	return limited;
}
#define LIMIT_SHIFTED(word, shift, bits) soft_limit_shifted(word, shift, bits)
/*
 * Loads a word, or two, x bytes from the row's start, and as many from the row
 * below. rows stays in memory until here, as registers are scarce.
 */
static ALWAYS_INLINE void soft_load_rows(const struct soft_rows *rows,
	uint32_t row, uint32_t x, uint32_t stride_log2, bool two,
	uint32_t above[2], uint32_t below[2])
{
	uint64_t pair;

	(void)stride_log2;
	__asm__ volatile("ldrd %Q0, %R0, %1" : "=&r"(pair) : "Uq"(*rows));
	above[0] = x + row * (uint32_t)(pair >> 32);
	if (two) {
		__asm__ volatile("ldr %0, [%Q4, %0]!\n\tldr %1, [%Q4, #4]\n\t"
				 "ldr %2, [%Q4, %R4]!\n\tldr %3, [%Q4, #4]"
				 : "+&r"(above[0]), "=&r"(above[1]),
				 "=&r"(below[0]), "=&r"(below[1]), "+&r"(pair));
	} else {
		__asm__ volatile(
			"ldr %0, [%Q2, %0]!\n\tldr %1, [%Q2, %R2]"
			: "+&r"(above[0]), "=&r"(below[0]), "+&r"(pair));
	}
}
#elif SOFT_LANES == 1
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

static ALWAYS_INLINE void soft_load_rows(const struct soft_rows *rows,
	uint32_t row, uint32_t x, uint32_t stride_log2, bool two,
	uint32_t above[2], uint32_t below[2])
{
	const uint8_t *at = rows->first + ((row << stride_log2) + x);

	memcpy(above, at, two ? 8 : 4);
	memcpy(below, at + rows->stride, two ? 8 : 4);
}

#define UPPER_HALF(word)       ((word) >> 16)
#define SHIFT_HERE(word, bits) ((word) >> (bits))
#define LIMIT_SHIFTED(word, shift, bits) \
	((uint32_t)LIMIT_TO_BITS((word) >> (shift), bits))
#define KEEP_IN_MEMORY(object) ((void)0)
#define UPPER_HALVES(a, b, shift) \
	(((uint32_t)(a)&0xFFFF0000) | ((uint32_t)(b) >> (shift)&0xFFFF))
#define LOWER_HALVES(a, b)        (((uint32_t)(a)&0xFFFF) | (uint32_t)(b) << 16)
#define HALVES_ADD_LIMITED(a, b)  soft_halves_add_limited(a, b)
#define HALVES_SUM(a, b)          soft_halves_sum(a, b)
#define HALVES_SUM_ADD(a, b, sum) (soft_halves_sum(a, b) + (sum))
#define WORD_BY_BOTTOM(word, half, sum) \
	(soft_word_by_half((uint32_t)(word), half) + (sum))
#define WORD_TIMES_BOTTOM(word, half) \
	((uint32_t)soft_word_by_half((uint32_t)(word), half))
#define WORD_BY_TOP(word, half, sum) \
	(soft_word_by_half((uint32_t)(word), (half) >> 16) + (sum))
#else
static ALWAYS_INLINE void soft_load_rows(const struct soft_rows *rows,
	soft_word row, soft_word x, uint32_t stride_log2, bool two,
	soft_word above[2], soft_word below[2])
{
	const struct soft_places from =
		soft_find_places(rows->first, (row << stride_log2) + x);

	if (two) {
		soft_load_pairs(from, 0, above);
		soft_load_pairs(from, rows->stride, below);
	} else {
		above[0] = soft_load_each(from, 0, 2);
		below[0] = soft_load_each(from, rows->stride, 2);
	}
}
#endif

#endif
