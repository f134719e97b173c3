/*
 * Compiler extensions and instructions that C cannot express, behind portable
 * names. Beside gl/soft/span/vectors.h no other header uses such extensions.
 */
#ifndef PLATFORM_BASE_COMPILER_H
#define PLATFORM_BASE_COMPILER_H

#include <stdint.h>

/* Lets the compiler check a function's arguments against its printf format. */
#define PRINTF_LIKE(format_index, first_argument) \
	__attribute__((format(printf, format_index, first_argument)))

/* The type of a function that a header declares, and of a pointer to it. */
#define TYPE_OF(function)    __typeof__(function)
#define POINTER_TO(function) __typeof__(function) *

/*
 * Lets the dynamic loader take the function whose address the function of this name
 * returns, which gets the kernel's HWCAP bits and may call nothing (GNU ifunc).
 */
#define CHOSEN_BY(name) __attribute__((ifunc(name)))

#define ARRAY_COUNT(array) (sizeof(array) / sizeof((array)[0]))

/* For small functions whose constant arguments must be folded by inlining. */
#define ALWAYS_INLINE inline __attribute__((always_inline))

/* The number of zero bits above the highest set bit; value must not be 0. */
#define LEADING_ZEROS_32(value) __builtin_clz(value)
#define LEADING_ZEROS_64(value) __builtin_clzll(value)

/*
 * sum + (word * half >> 16), where half is an int16_t and the product has 48
 * bits. The sum wraps. One instruction (smlawb) on cores that have it.
 */
#ifdef __ARM_FEATURE_DSP
#include <arm_acle.h>
#define MULTIPLY_ADD_HALF(sum, word, half) __smlawb(word, (int32_t)(half), sum)
#else
#define MULTIPLY_ADD_HALF(sum, word, half) \
	((int32_t)((uint32_t)(sum) +       \
		(uint32_t)(int32_t)((int64_t)(word) * (int16_t)(half) >> 16)))
#endif

/*
 * multiply_high() returns the upper 32 bits of a 64-bit product.
 * multiply_add_high() adds them to sum; the sum wraps.
 */
#if defined(__ARM_FEATURE_DSP) && __ARM_ARCH >= 6
static inline int32_t multiply_high(int32_t a, int32_t b)
{
	int32_t product;

	__asm__("smmul %0, %1, %2" : "=r"(product) : "r"(a), "r"(b));
	return product;
}

static inline int32_t multiply_add_high(int32_t sum, int32_t a, int32_t b)
{
	int32_t product;

	__asm__("smmla %0, %1, %2, %3"
		: "=r"(product)
		: "r"(a), "r"(b), "r"(sum));
	return product;
}
#else
static inline int32_t multiply_high(int32_t a, int32_t b)
{
	return (int32_t)(((int64_t)a * b) >> 32);
}

static inline int32_t multiply_add_high(int32_t sum, int32_t a, int32_t b)
{
	return (int32_t)((uint32_t)sum + (uint32_t)multiply_high(a, b));
}
#endif

/*
 * Loads two words from an address that is a multiple of 4: by one instruction
 * (ldrd) on cores that have it.
 */
#if defined(__ARM_FEATURE_DSP) && __ARM_ARCH >= 6
static inline uint64_t load_two_words(const void *at)
{
	uint64_t words;

	__asm__("ldrd %Q0, %R0, %1"
		: "=&r"(words)
		: "Uq"(*(const char(*)[8])at));
	return words;
}
#else
static inline uint64_t load_two_words(const void *at)
{
	uint64_t words;

	__builtin_memcpy(&words, at, sizeof(words));
	return words;
}
#endif

/* Clamps a signed value to 0..2^bits - 1; bits is a constant. */
#ifdef __ARM_FEATURE_SAT
#define LIMIT_TO_BITS(value, bits) ((int32_t)__usat(value, bits))
#else
#define LIMIT_TO_BITS(value, bits) \
	((value) < 0 ? 0 : (value) >> (bits) ? (1 << (bits)) - 1 : (value))
#endif

/* Prefetches the cache line at an address, which need not be mapped. */
#define PRELOAD(address) __builtin_prefetch(address)

/* Keeps a rare case out of line, so that it does not slow down its caller. */
#define NEVER_INLINE __attribute__((noinline))

/* Hides a value from the optimizer, which must then keep it in a register. */
#define OPAQUE(value) __asm__("" : "+r"(value))

/*
 * Multiply-accumulate on the signed 16-bit halves of a word, B for the bottom
 * half and T for the top one: HALVES_BT(a, b, sum) is (bottom of a) * (top of
 * b) + sum in 32 bits. BYTES_AS_HALVES() spreads bytes 0 and 2 of a word to
 * its two halves, and ODD_BYTES_AS_HALVES() bytes 1 and 3. Each is one
 * instruction on cores that have it.
 */
#ifdef __ARM_FEATURE_DSP
static inline uint32_t odd_bytes_as_halves(uint32_t word)
{
	uint32_t halves;

	__asm__("uxtb16 %0, %1, ror #8" : "=r"(halves) : "r"(word));
	return halves;
}
#define HALVES_BB(a, b, sum)      __smlabb((int32_t)(a), (int32_t)(b), sum)
#define HALVES_BT(a, b, sum)      __smlabt((int32_t)(a), (int32_t)(b), sum)
#define HALVES_TB(a, b, sum)      __smlatb((int32_t)(a), (int32_t)(b), sum)
#define HALVES_TT(a, b, sum)      __smlatt((int32_t)(a), (int32_t)(b), sum)
#define BYTES_AS_HALVES(word)     __uxtb16(word)
#define ODD_BYTES_AS_HALVES(word) odd_bytes_as_halves(word)
#else
#define HALVES_BB(a, b, sum) ((int16_t)(a) * (int16_t)(b) + (sum))
#define HALVES_BT(a, b, sum) ((int16_t)(a) * (int16_t)((b) >> 16) + (sum))
#define HALVES_TB(a, b, sum) ((int16_t)((a) >> 16) * (int16_t)(b) + (sum))
#define HALVES_TT(a, b, sum) \
	((int16_t)((a) >> 16) * (int16_t)((b) >> 16) + (sum))
#define BYTES_AS_HALVES(word)     ((word)&0x00ff00ffu)
#define ODD_BYTES_AS_HALVES(word) ((word) >> 8 & 0x00ff00ffu)
#endif

/*
 * least_halves() and most_halves() return the minimum and the maximum of the
 * unsigned 16-bit halves of two words; subtract_halves() subtracts them, and
 * each difference wraps. cross_halves() is the cross product a.x * b.y - a.y *
 * b.x of vectors whose signed x is the bottom half and whose y is the top half.
 */
#ifdef __ARM_FEATURE_SIMD32
static inline uint32_t subtract_halves(uint32_t a, uint32_t b)
{
	return (uint32_t)__ssub16((int32_t)a, (int32_t)b);
}

static inline int32_t cross_halves(uint32_t a, uint32_t b)
{
	return __smusdx((int32_t)a, (int32_t)b);
}

static inline uint32_t least_halves(uint32_t a, uint32_t b)
{
	__usub16(a, b);
	return __sel(b, a);
}

static inline uint32_t most_halves(uint32_t a, uint32_t b)
{
	__usub16(a, b);
	return __sel(a, b);
}
#else
static inline uint32_t subtract_halves(uint32_t a, uint32_t b)
{
	return ((a - b) & 0xFFFF) | (((a >> 16) - (b >> 16)) << 16);
}

static inline int32_t cross_halves(uint32_t a, uint32_t b)
{
	return (int16_t)(a & 0xFFFF) * ((int32_t)b >> 16) -
		((int32_t)a >> 16) * (int16_t)(b & 0xFFFF);
}

static inline uint32_t least_halves(uint32_t a, uint32_t b)
{
	uint32_t low = (a & 0xFFFF) < (b & 0xFFFF) ? a & 0xFFFF : b & 0xFFFF;

	return (a >> 16 < b >> 16 ? a >> 16 : b >> 16) << 16 | low;
}

static inline uint32_t most_halves(uint32_t a, uint32_t b)
{
	uint32_t low = (a & 0xFFFF) > (b & 0xFFFF) ? a & 0xFFFF : b & 0xFFFF;

	return (a >> 16 > b >> 16 ? a >> 16 : b >> 16) << 16 | low;
}
#endif

/*
 * Data that no other library shares: position-independent code then reaches it
 * without a table of addresses. Tests with sanitizers take all data from a
 * shared library.
 */
#ifdef __SANITIZE_ADDRESS__
#define OWN_DATA
#else
#define OWN_DATA __attribute__((visibility("hidden")))
#endif

#endif
