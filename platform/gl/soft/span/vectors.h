/*
 * Arithmetic on a colour's four bytes at once, by SSE2, which every x86-64 has.
 * Where HAS_COLOR_VECTORS is not defined, callers use C with the same results.
 *
 * Lanes are 16 bits each in the lower half of a vector: red, green, blue and
 * alpha from the lowest bits on.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_VECTORS_H
#define PLATFORM_GL_SOFT_SPAN_VECTORS_H

#include "platform/base/compiler.h"

#ifdef __SSE2__
#include <emmintrin.h>
#include <string.h>

#define HAS_COLOR_VECTORS 1

static ALWAYS_INLINE __m128i vector_load(uint64_t lanes)
{
	return _mm_set_epi64x(0, (long long)lanes);
}

static ALWAYS_INLINE __m128i vector_widen(uint64_t bytes)
{
	return _mm_unpacklo_epi8(vector_load(bytes), _mm_setzero_si128());
}

/* Lanes that are at most 255 as bytes. */
static ALWAYS_INLINE uint32_t vector_narrow(__m128i lanes)
{
	return (uint32_t)_mm_cvtsi128_si32(_mm_packus_epi16(lanes, lanes));
}

/*
 * (sum of four colours times weights + rounding) / 256 as lanes. Each argument
 * has two colours; the sum of weights is 256; rounding is at most 128.
 */
static ALWAYS_INLINE __m128i vector_mix(uint64_t first, uint64_t second,
	const uint32_t weight[4], uint32_t rounding)
{
	__m128i by = vector_load((weight[0] | weight[1] << 16) |
		(uint64_t)(weight[2] | weight[3] << 16) << 32);
	__m128i sum;

	by = _mm_unpacklo_epi16(by, by);
	sum = _mm_add_epi16(_mm_mullo_epi16(vector_widen(first),
				    _mm_shuffle_epi32(by, 0x50)),
		_mm_mullo_epi16(
			vector_widen(second), _mm_shuffle_epi32(by, 0xFA)));
	sum = _mm_add_epi16(sum, _mm_srli_si128(sum, 8));
	sum = _mm_add_epi16(sum, _mm_set1_epi16((short)rounding));
	return _mm_srli_epi16(sum, 8);
}

/*
 * (lanes * factors + 2^13) / 2^14 as bytes; factors are below 2^15: those of
 * red and blue are the halves of a word, as are those of green and alpha.
 */
static ALWAYS_INLINE uint32_t vector_scale(
	__m128i lanes, uint32_t red_blue, uint32_t green_alpha)
{
	__m128i by = _mm_unpacklo_epi16(_mm_cvtsi32_si128((int)red_blue),
		_mm_cvtsi32_si128((int)green_alpha));
	__m128i sum =
		_mm_madd_epi16(_mm_unpacklo_epi16(lanes, _mm_set1_epi16(1)),
			_mm_unpacklo_epi16(by, _mm_set1_epi16(1 << 13)));

	sum = _mm_srli_epi32(sum, 14);
	return vector_narrow(_mm_packs_epi32(sum, sum));
}

/* Lanes of products of two bytes, divided by 255 and rounded. */
static ALWAYS_INLINE __m128i vector_divide(__m128i products)
{
	__m128i sum = _mm_add_epi16(products, _mm_set1_epi16(128));

	return _mm_srli_epi16(_mm_add_epi16(sum, _mm_srli_epi16(sum, 8)), 8);
}

/* a * b / 255 of each of four bytes. */
static ALWAYS_INLINE uint32_t vector_multiply(uint32_t a, uint32_t b)
{
	return vector_narrow(vector_divide(
		_mm_mullo_epi16(vector_widen(a), vector_widen(b))));
}

/* Blends colour to with own by alpha / 255. */
static ALWAYS_INLINE uint32_t vector_blend(
	uint32_t to, uint32_t own, uint32_t alpha)
{
	__m128i by = _mm_set1_epi32((int)(alpha << 16 | (255 - alpha)));
	__m128i both = _mm_unpacklo_epi8(
		_mm_cvtsi32_si128((int)to), _mm_cvtsi32_si128((int)own));
	__m128i sum = _mm_madd_epi16(
		_mm_unpacklo_epi8(both, _mm_setzero_si128()), by);

	sum = _mm_add_epi32(sum, _mm_set1_epi32(128));
	sum = _mm_srli_epi32(_mm_add_epi32(sum, _mm_srli_epi32(sum, 8)), 8);
	return vector_narrow(_mm_packs_epi32(sum, sum));
}

#endif

#endif
