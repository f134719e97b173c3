/*
 * The only header that names compiler extensions.
 */
#ifndef PLATFORM_BASE_COMPILER_H
#define PLATFORM_BASE_COMPILER_H

/* Checks a printf-like function's arguments against its format. */
#define PRINTF_LIKE(format_index, first_argument)                              \
	__attribute__((format(printf, format_index, first_argument)))

#define ARRAY_COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* For small functions whose arguments must become constants of their caller. */
#define ALWAYS_INLINE inline __attribute__((always_inline))

/* How many zero bits stand above the highest one; value is not 0. */
#define LEADING_ZEROS_32(value) __builtin_clz(value)
#define LEADING_ZEROS_64(value) __builtin_clzll(value)

/*
 * sum + (word half >> 16), of 48 bits; wraps. One instruction where there is
 * one.
 */
#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#define MULTIPLY_ADD_HALF(sum, word, half) __smlawb(word, half, sum)
#else
#include <stdint.h>
#define MULTIPLY_ADD_HALF(sum, word, half)                                     \
	((int32_t)((uint32_t)(sum) +                                           \
		(uint32_t)(int32_t)((int64_t)(word) * (int16_t)(half) >> 16)))
#endif

/* The same value, of which the compiler knows nothing any more. */
#define OPAQUE(value) __asm__("" : "+r"(value))

#endif
