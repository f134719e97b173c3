/*
 * Reads and filters texels, for span functions and for the tests' reference, so
 * that alpha has the same 8 bits in both and alpha tests pass the same fragments.
 *
 * Bilinear filter weights are multiples of 1/32 across and 1/256 down; for
 * RGBA8888 texels of 1/256 both ways.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_SAMPLE_H
#define PLATFORM_GL_SOFT_SPAN_SAMPLE_H

#include <string.h>

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/soft.h"
#include "platform/gl/soft/span/halves.h"

enum {
	SOFT_TEXEL_FRACTION = 9, /* fraction bits of coordinates in a level */
};

enum soft_channel {
	SOFT_RED,
	SOFT_GREEN,
	SOFT_BLUE,
	SOFT_ALPHA,
};

/* A channel's lowest bit in a texel and its width; 0 bits: there is none. */
struct soft_field {
	int shift, bits;
};

static ALWAYS_INLINE struct soft_field soft_field(
	enum texel_format format, enum soft_channel channel)
{
	bool alpha = channel == SOFT_ALPHA;

	switch (format) {
	case TEXEL_565:
		return channel == SOFT_RED      ? (struct soft_field){11, 5}
			: channel == SOFT_GREEN ? (struct soft_field){5, 6}
			: channel == SOFT_BLUE  ? (struct soft_field){0, 5}
						: (struct soft_field){0, 0};
	case TEXEL_4444:
		return (struct soft_field){12 - 4 * (int)channel, 4};
	case TEXEL_5551:
		return alpha ? (struct soft_field){0, 1}
			     : (struct soft_field){11 - 5 * (int)channel, 5};
	case TEXEL_8888:
		return (struct soft_field){8 * (int)channel, 8};
	case TEXEL_L8:
		return (struct soft_field){0, alpha ? 0 : 8};
	case TEXEL_A8:
		return (struct soft_field){0, alpha ? 8 : 0};
	case TEXEL_LA88:
		return (struct soft_field){alpha ? 8 : 0, 8};
	default:
		return (struct soft_field){0, 0};
	}
}

static ALWAYS_INLINE soft_word soft_get_field(
	enum texel_format format, enum soft_channel channel, soft_word texel)
{
	struct soft_field field = soft_field(format, channel);

	return texel >> field.shift & ((1u << field.bits) - 1);
}

static ALWAYS_INLINE int soft_texel_bytes_log2(enum texel_format format)
{
	return format == TEXEL_8888                        ? 2
		: format == TEXEL_L8 || format == TEXEL_A8 ? 0
							   : 1;
}

/* Loads texels, or only one, so many bytes from first. */
static ALWAYS_INLINE soft_word soft_load_texels(
	enum texel_format format, const uint8_t *first, soft_word offset)
{
	const int bytes_log2 = soft_texel_bytes_log2(format);

#if SOFT_LANES > 1
	return soft_load_each(soft_find_places(first, offset), 0, bytes_log2);
#else
	return soft_load_bytes(first + offset, bytes_log2);
#endif
}

/* Loads two neighbouring texels, left in the lower half; not RGBA8888. */
static ALWAYS_INLINE soft_word soft_load_pair(
	enum texel_format format, const uint8_t *first, soft_word offset)
{
	soft_word two;

	if (soft_texel_bytes_log2(format) == 0) {
		two = soft_load_texels(TEXEL_565, first, offset);
		return (two | two << 8) & 0x00FF00FF;
	}
	return soft_load_texels(TEXEL_8888, first, offset);
}

/* A coordinate's fraction, which is the next texel's filter weight, of 256. */
static ALWAYS_INLINE soft_word soft_fraction_q8(soft_word at)
{
	return at >> (SOFT_TEXEL_FRACTION - 8) & 255;
}

/*
 * What is subtracted from coordinates for bilinear filters: half a texel, minus
 * half of a weight's last bit, so that weights are rounded to the nearest.
 */
static ALWAYS_INLINE int32_t soft_half_texel(
	enum texel_format format, bool linear, bool across)
{
	int bits = across && format != TEXEL_8888 ? 5 : 8;

	return linear ? (1 << (SOFT_TEXEL_FRACTION - 1)) -
			(1 << (SOFT_TEXEL_FRACTION - bits - 1))
		      : 0;
}

/* Filter weights of two pairs of texels: left in the lower half, and right. */
struct soft_weights {
	soft_word above, below; /* the sum of all four is 8192 */
};

/* The weights for coordinates s with 5 and t with 8 bits of fraction. */
static ALWAYS_INLINE struct soft_weights soft_weigh(soft_word s, soft_word t)
{
	soft_word right = s & 31;
	soft_word across = (right << 16) - right + 32;
	soft_word below = HALVES_TIMES(across, HALVES_TWICE(t & 255));

	return (struct soft_weights){(across << 8) - below, below};
}

static ALWAYS_INLINE soft_word soft_mix_masked(soft_word above, soft_word below,
	uint32_t mask, struct soft_weights weights)
{
	return HALVES_SUM_ADD(below & mask, weights.below,
		HALVES_SUM(above & mask, weights.above));
}

/* A channel of two pairs of texels, filtered: 8192 times its value. */
static ALWAYS_INLINE soft_word soft_mix_channel(enum texel_format format,
	enum soft_channel channel, soft_word above, soft_word below,
	struct soft_weights weights)
{
	struct soft_field field = soft_field(format, channel);
	uint32_t mask = ((1u << field.bits) - 1) * 0x10001;

	return soft_mix_masked(
		above >> field.shift, below >> field.shift, mask, weights);
}

struct soft_lanes {
	soft_word red_blue, green_alpha;
};

/* Four texels of RGBA8888 and their filter weights, HALVES_TWICE() of 256 in all. */
struct soft_four {
	soft_word texel[4], weight[4];
};

static ALWAYS_INLINE struct soft_four soft_weigh_8888(const soft_word above[2],
	const soft_word below[2], soft_word s, soft_word t, bool wide)
{
	const uint32_t rounding = wide ? 128 : 0;
	soft_word right = HALVES_TWICE(soft_fraction_q8(s));
	soft_word down = HALVES_TWICE(soft_fraction_q8(t));
	soft_word both = HALVES_SHIFT(
		HALVES_TIMES(right, down) + HALVES_TWICE(rounding), 8);

	return (struct soft_four){
		{above[0], above[1], below[0], below[1]},
		{HALVES_TWICE(256u) - down - (right - both), right - both,
			down - both, both},
	};
}

static ALWAYS_INLINE soft_word soft_get_half(soft_word texel, bool odd)
{
	return odd ? ODD_BYTES_AS_HALVES(texel) : BYTES_AS_HALVES(texel);
}

/*
 * Filters bytes 0 and 2, or 1 and 3 if odd. Rounds down, but to the nearest in
 * RGBA8888 pictures (wide), where the difference would be seen.
 */
static ALWAYS_INLINE soft_word soft_mix_half(
	const struct soft_four *four, bool odd, bool wide)
{
	const soft_word *texel = four->texel, *weight = four->weight;
	soft_word sum = HALVES_TIMES(soft_get_half(texel[0], odd), weight[0]);

	sum += wide ? 0x00800080u : 0u;
	sum += HALVES_TIMES(soft_get_half(texel[1], odd), weight[1]);
	sum += HALVES_TIMES(soft_get_half(texel[2], odd), weight[2]);
	sum += HALVES_TIMES(soft_get_half(texel[3], odd), weight[3]);
	return ODD_BYTES_AS_HALVES(sum);
}

/* Expands a channel of so many bits to 8 bits. */
static ALWAYS_INLINE soft_word soft_widen_field(soft_word value, int bits)
{
	return bits == 4    ? value * 17
		: bits == 1 ? value * 255
		: bits == 5 ? value << 3 | value >> 2
		: bits == 6 ? value << 2 | value >> 4
			    : value;
}

/* Converts a filtered channel, 8192 times its value of so many bits, to 8 bits. */
static ALWAYS_INLINE soft_word soft_narrow_mixed(soft_word mixed, int bits)
{
	uint32_t by = 255 * 64 / ((1u << bits) - 1), half = 1 << 18;

	OPAQUE(by); /* else compilers shift and add instead of one MLA */
	OPAQUE(half);
	return bits == 8    ? (mixed + 4096) >> 13
		: bits == 4 ? (mixed * 17 + 4096) >> 13
		: bits == 1 ? (mixed * 255 + 4096) >> 13
			    : (mixed * by + half) >> 19;
}

/* texel's alpha, a byte, times the fragment's, 8.7 with a half added: a byte. */
static ALWAYS_INLINE soft_word soft_scale_alpha(
	soft_word alpha_q7, soft_word texel)
{
	/* 128, so that 255 leaves the other factor as it is */
	soft_word product = WORD_PRODUCT(alpha_q7, texel) + 128;

	return (product + (product >> 8)) >> 15;
}

/* Converts an alpha's step of 8.16 to 8.7, rounded towards zero. */
static ALWAYS_INLINE int32_t soft_alpha_step(int32_t step)
{
	return (step >> 9) + (int32_t)((uint32_t)step >> 31);
}

/* Converts a step of 16.16 base texels to the level's, rounded to the nearest. */
static ALWAYS_INLINE uint32_t soft_texel_step(int32_t step, int shift)
{
	return (uint32_t)((int32_t)((uint32_t)step + (1u << (shift - 1))) >>
		shift);
}

/*
 * A run's first coordinate in the level, such that the coordinate in its middle,
 * half_count pixels on, is exact; right is the rounded step in the level.
 */
static ALWAYS_INLINE uint32_t soft_find_start(int32_t at, int32_t step,
	uint32_t half_count, uint32_t right, int shift, int32_t half_texel)
{
	uint32_t middle = (uint32_t)at + (uint32_t)step * half_count;

	return (uint32_t)((int32_t)middle >> shift) - right * half_count -
		(uint32_t)half_texel;
}

#endif
