/*
 * Words of one pixel, or of four pixels at once by SSE2, which every x86-64 has:
 * files that define SOFT_BY_FOUR before they include anything draw four at once
 * there. Functions on soft_word are the same text for both, as + - & | ^ << >>
 * work on vectors as on words; the macros below and in halves.h do the rest.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_VECTORS_H
#define PLATFORM_GL_SOFT_SPAN_VECTORS_H

#include <stdint.h>
#include <string.h>

#include "platform/base/compiler.h"

/* Loads one, two or four bytes, which need no alignment. */
static ALWAYS_INLINE uint32_t soft_load_bytes(const uint8_t *at, int bytes_log2)
{
	uint16_t half;
	uint32_t word;

	switch (bytes_log2) {
	case 0:
		return *at;
	case 1:
		memcpy(&half, at, sizeof(half));
		return half;
	default:
		memcpy(&word, at, sizeof(word));
		return word;
	}
}

#if defined(SOFT_BY_FOUR) && defined(__x86_64__)
#include <emmintrin.h>

#define SOFT_LANES 4
typedef uint32_t soft_word __attribute__((vector_size(16)));
typedef int32_t soft_int __attribute__((vector_size(16)));

#define SOFT_VECTOR(name, a, b) \
	((soft_word)_mm_##name((__m128i)(a), (__m128i)(b)))
/* products of both halves, their lower 16 bits; twice: a word in both halves */
#define HALVES_TIMES(a, b)      SOFT_VECTOR(mullo_epi16, a, b)
#define HALVES_TWICE(word)      ((word) | (word) << 16)
#define HALVES_SHIFT(a, bits)   ((soft_word)_mm_srli_epi16((__m128i)(a), bits))
#define HALVES_SUM(a, b)        SOFT_VECTOR(madd_epi16, a, b)
#define HALVES_SUM_ADD(a, b, c) (HALVES_SUM(a, b) + (c))
/* a product of words below 2^15 */
#define WORD_PRODUCT(a, b)      HALVES_SUM(a, b)
#undef HALVES_BB
#undef HALVES_BT
#undef HALVES_TT
#define HALVES_BB(a, b, sum) ((soft_int)HALVES_SUM(a, (b)&0xFFFF) + (sum))
#define HALVES_BT(a, b, sum) \
	((soft_int)HALVES_SUM((a)&0xFFFF, (b) >> 16) + (sum))
#define HALVES_TT(a, b, sum) ((soft_int)HALVES_SUM(a, (b)&0xFFFF0000) + (sum))
/* the half is not negative here */
#define WORD_BY_BOTTOM(word, half, sum)                             \
	((soft_int)(SOFT_VECTOR(mulhi_epu16, word, (half)&0xFFFF) + \
		 HALVES_SUM(word, (half) << 16)) +                  \
		(sum))
#define WORD_BY_TOP(word, half, sum)                               \
	((soft_int)(SOFT_VECTOR(mulhi_epu16, word, (half) >> 16) + \
		 HALVES_SUM(word, (half)&0xFFFF0000)) +            \
		(sum))
#define WORD_TIMES_BOTTOM(word, half) ((soft_word)WORD_BY_BOTTOM(word, half, 0))
#define HALVES_ADD_LIMITED(a, b)      SOFT_VECTOR(adds_epu16, a, b)
#define BYTES_ADD_LIMITED(a, b)       SOFT_VECTOR(adds_epu8, a, b)
#define BYTES_LESS_LIMITED(a, b)      SOFT_VECTOR(subs_epu8, a, b)
/* words that fit 16 bits when shifted */
#define LIMIT_SHIFTED(word, shift, bits)                                  \
	SOFT_VECTOR(min_epi16,                                            \
		SOFT_VECTOR(max_epi16, (word) >> (shift), (soft_int){0}), \
		(soft_word){0} + ((1u << (bits)) - 1))
#define UPPER_HALF(word)       ((word) >> 16)
#define SHIFT_HERE(word, bits) ((word) >> (bits))
#define UPPER_HALVES(a, b, shift) \
	(((soft_word)(a)&0xFFFF0000) | ((soft_word)(b) >> (shift)&0xFFFF))
#define KEEP_IN_MEMORY(object) ((void)0)
#undef ODD_BYTES_AS_HALVES
#define ODD_BYTES_AS_HALVES(word) HALVES_SHIFT(word, 8)
#undef OPAQUE
#define OPAQUE(value) ((void)0)

/* A step to each of the four pixels, or to the next four. */
static ALWAYS_INLINE soft_word soft_spread(uint32_t step, bool next)
{
	if (next) {
		return (soft_word){0} + step * SOFT_LANES;
	}
	return (soft_word){0, step, 2 * step, 3 * step};
}

/* Four words from addresses at which no alignment is needed. */
static ALWAYS_INLINE soft_word soft_get_words(const void *at)
{
	return (soft_word)_mm_loadu_si128(at);
}

static ALWAYS_INLINE void soft_put_words(void *at, soft_word word)
{
	_mm_storeu_si128(at, (__m128i)word);
}

static ALWAYS_INLINE soft_word soft_get_halves(const void *at)
{
	return (soft_word)_mm_unpacklo_epi16(
		_mm_loadl_epi64(at), _mm_setzero_si128());
}

static ALWAYS_INLINE void soft_put_halves(void *at, soft_word word)
{
	const __m128i signed_16 = (__m128i)((soft_int)(word << 16) >> 16);

	_mm_storel_epi64(at, _mm_packs_epi32(signed_16, signed_16));
}

/* Whether a lane of the mask is set, and whether all are. */
static ALWAYS_INLINE bool soft_any(soft_word mask)
{
	return _mm_movemask_epi8((__m128i)mask) != 0;
}

static ALWAYS_INLINE bool soft_all(soft_word mask)
{
	return _mm_movemask_epi8((__m128i)mask) == 0xFFFF;
}

static ALWAYS_INLINE soft_word soft_choose(
	soft_word mask, soft_word yes, soft_word no)
{
	return (yes & mask) | (no & ~mask);
}

/* The lanes of the first so many pixels. */
static ALWAYS_INLINE soft_word soft_live(ptrdiff_t count)
{
	return (soft_word)((soft_int){0, 1, 2, 3} < (int)count);
}

/* Coordinates that lie in the window where not all lanes are drawn, too. */
#define soft_safe(texel, pass) ((texel) & (pass))

/* The addresses of four texels. */
struct soft_places {
	const uint8_t *a, *b, *c, *d;
};

static ALWAYS_INLINE struct soft_places soft_find_places(
	const uint8_t *first, soft_word offset)
{
	const uint64_t low = (uint64_t)_mm_cvtsi128_si64((__m128i)offset);
	const uint64_t high = (uint64_t)_mm_cvtsi128_si64(
		_mm_unpackhi_epi64((__m128i)offset, (__m128i)offset));

	return (struct soft_places){first + (uint32_t)low, first + (low >> 32),
		first + (uint32_t)high, first + (high >> 32)};
}

/* Loads so many bytes from each place. */
static ALWAYS_INLINE soft_word soft_load_each(
	struct soft_places from, ptrdiff_t add, int bytes_log2)
{
	return (soft_word){soft_load_bytes(from.a + add, bytes_log2),
		soft_load_bytes(from.b + add, bytes_log2),
		soft_load_bytes(from.c + add, bytes_log2),
		soft_load_bytes(from.d + add, bytes_log2)};
}

/* Loads a word from each place, and the one behind it. */
static ALWAYS_INLINE void soft_load_pairs(
	struct soft_places from, ptrdiff_t add, soft_word out[2])
{
	const __m128i low = _mm_unpacklo_epi32(
		_mm_loadl_epi64((const void *)(from.a + add)),
		_mm_loadl_epi64((const void *)(from.b + add)));
	const __m128i high = _mm_unpacklo_epi32(
		_mm_loadl_epi64((const void *)(from.c + add)),
		_mm_loadl_epi64((const void *)(from.d + add)));

	out[0] = (soft_word)_mm_unpacklo_epi64(low, high);
	out[1] = (soft_word)_mm_unpackhi_epi64(low, high);
}
#else
#define SOFT_LANES 1
typedef uint32_t soft_word;
typedef int32_t soft_int;

#define HALVES_TIMES(a, b)    ((a) * (b))
#define HALVES_TWICE(word)    (word)
#define HALVES_SHIFT(a, bits) ((a) >> (bits))
#define WORD_PRODUCT(a, b)    ((a) * (b))

static ALWAYS_INLINE soft_word soft_get_words(const void *at)
{
	return *(const uint32_t *)at;
}

static ALWAYS_INLINE void soft_put_words(void *at, soft_word word)
{
	*(uint32_t *)at = word;
}

static ALWAYS_INLINE soft_word soft_get_halves(const void *at)
{
	return *(const uint16_t *)at;
}

static ALWAYS_INLINE void soft_put_halves(void *at, soft_word word)
{
	*(uint16_t *)at = (uint16_t)word;
}

#define soft_spread(step, next)    ((next) ? (step) : 0)
#define soft_any(mask)             (mask)
#define soft_all(mask)             (mask)
#define soft_choose(mask, yes, no) ((mask) ? (yes) : (no))
#define soft_safe(texel, pass)     ((void)(pass), (texel))
#define soft_live(count)           1
#endif

#endif
