/*
 * The last stages of span functions (span/template.h): times a second texture's
 * texel, times the colour, fog, blending, and how pixels of both formats are
 * stored.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_FINISH_H
#define PLATFORM_GL_SOFT_STAGES_FINISH_H

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/span/stages.h"
#include "platform/gl/soft/stages/bytes.h"

/*
 * Constants of a run, from soft_fragment_stages. Fog computes fog + (color - far)
 * * share for a channel; to add a colour to all fragments, -far is that colour.
 */
struct soft_constants {
	int32_t start[3]; /* added to texel times colour: a half, minus far */
	int32_t fog[3];   /* half of (fog's colour and a half) */
	uint32_t alpha_low, alpha_range;
	uint32_t factors_base, factors_by;
	uint32_t unseen;
	/*
	 * Addresses of the row's second texels, and of made ones, minus twice
	 * that of its depths.
	 */
	uintptr_t second, made;
	uint32_t environment[3];
};

/*
 * A second texel's channel, shifted to so many fraction bits. It has 5, 6 and 5
 * bits besides its own fraction bits.
 */
static ALWAYS_INLINE soft_word soft_second_channel(struct soft_kind kind,
	const struct soft_texel *second, enum soft_channel channel, int fraction)
{
	const int own = kind.joined     ? (kind.linear ? 18 : 0)
		: channel == SOFT_GREEN ? 5
					: 6;

	return fraction >= own ? second->channel[channel] << (fraction - own)
			       : second->channel[channel] >> (own - fraction);
}

/* Splits a word of soft_run.second into channels. */
static ALWAYS_INLINE void soft_split_second(
	soft_word word, struct soft_texel *out)
{
	out->channel[0] = word >> 21; /* the lowest bit belongs to green */
	out->channel[1] = word << 10 >> 21;
	out->channel[2] = word << 21 >> 21;
}

/* Multiplies a texel of RGBA8888 by a second one's bytes. */
static ALWAYS_INLINE void soft_multiply_texel(
	struct soft_kind kind, soft_word second, struct soft_texel *texel)
{
	soft_split_texel(
		kind, soft_multiply_bytes(soft_join(texel), second), texel);
}

/* Multiplies channels by a second texel's, which have 11 bits. */
static ALWAYS_INLINE void soft_scale_texel(struct soft_kind kind,
	const struct soft_texel *second, struct soft_texel *texel)
{
	soft_word *c = texel->channel;

	if (kind.format == TEXEL_8888) {
		c[0] = texel->lanes.red_blue & 0xFFFF;
		c[1] = texel->lanes.green_alpha & 0xFFFF;
		c[2] = texel->lanes.red_blue >> 16;
	}
	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		const soft_word by = soft_second_channel(
			kind, second, i, i == SOFT_GREEN ? 5 : 6);

		c[i] = soft_is_aligned(kind) ? WORD_TIMES_BOTTOM(c[i], by)
					     : c[i] * by;
	}
}

static ALWAYS_INLINE void soft_add_second(struct soft_kind kind,
	const struct soft_texel *second, struct soft_color *color)
{
	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		color->channel[i] += (soft_int)soft_second_channel(
			kind, second, i, soft_fraction(kind, i));
	}
}

/*
 * Texel and colour by a texture environment. Colours are 8.8, with half a step
 * added; in RGB565 31/32 or 63/64 of them, and what is missing to half a step.
 */
static ALWAYS_INLINE struct soft_color soft_combine(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	const struct soft_pixel *at)
{
	const soft_word rb = at->red_blue, green = at->green_alpha & 0xFFFF;
	const soft_word t_rb = texel->lanes.red_blue << 8;
	const soft_word t_green = texel->lanes.green_alpha << 8 & 0xFF00;
	const soft_word sum = HALVES_ADD_LIMITED(rb, t_rb);
	const soft_word own[3] = {rb & 0xFFFF, green, rb >> 16};
	const soft_word t[3] = {t_rb & 0xFFFF, t_green, t_rb >> 16};
	soft_word to[3] = {
		sum & 0xFFFF, HALVES_ADD_LIMITED(green, t_green), sum >> 16};
	struct soft_color out;

	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		soft_word by = kind.mode == GL_DECAL ? texel->alpha : t[i] >> 8;

		by += by >> 7;
		if (kind.mode == GL_DECAL) {
			to[i] = t[i];
		} else if (kind.mode == GL_BLEND) {
			to[i] = (soft_word){0} + constants->environment[i];
		}
		if (kind.mode != GL_ADD) {
			to[i] = (soft_word)WORD_BY_BOTTOM(
				(to[i] - own[i]) << 8, by, (soft_int)own[i]);
		}
		if (!kind.wide) {
			to[i] += (1 << 9) - 64 -
				(to[i] >> (i == SOFT_GREEN ? 6 : 5));
			to[i] += i == SOFT_GREEN ? 0 : 1 << 9;
		}
		out.channel[i] = (soft_int)to[i];
		if (soft_is_fogged(kind)) {
			out.channel[i] += constants->start[i];
		}
	}
	return out;
}

/* Texel times colour, with a half added; formats are those of run.h. */
static ALWAYS_INLINE struct soft_color soft_modulate(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	const struct soft_pixel *at)
{
	const soft_int zero = {0};
	const soft_word rb = at->red_blue, ga = at->green_alpha;
	const soft_word *c = texel->channel;
	struct soft_color out;
	soft_int *to = out.channel;

	if (kind.mode) {
		return soft_combine(kind, constants, texel, at);
	}
	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		to[i] = zero + constants->start[i];
	}
	if (!soft_has_color(kind)) {
		to[0] += (soft_int)(rb & 0xFFFF);
		/* in RGB565 below 2^15; without a half it may be negative */
		to[1] += kind.wide ? (soft_int)(ga & 0xFFFF)
				   : (soft_int)(ga << 16) >> 16;
		to[2] += (soft_int)(rb >> 16);
	} else if (soft_is_mixed(kind) || soft_is_aligned(kind) ||
		soft_is_scaled(kind)) {
		to[0] = WORD_BY_BOTTOM(c[0], rb, to[0]);
		to[1] = WORD_BY_BOTTOM(c[1], ga, to[1]);
		to[2] = WORD_BY_TOP(c[2], rb, to[2]);
	} else if (kind.format == TEXEL_8888) {
		to[0] = HALVES_BB(texel->lanes.red_blue, rb, to[0]);
		to[1] = HALVES_BB(texel->lanes.green_alpha, ga, to[1]);
		to[2] = HALVES_TT(texel->lanes.red_blue, rb, to[2]);
	} else {
		to[0] = HALVES_BB(c[0], rb, to[0]);
		to[1] = HALVES_BB(c[1], ga, to[1]);
		to[2] = HALVES_BT(c[2], rb, to[2]);
	}
	return out;
}

static ALWAYS_INLINE int32_t soft_shift(int32_t value, int bits)
{
	return bits >= 0 ? value * (1 << bits) : value >> -bits;
}

static ALWAYS_INLINE struct soft_constants soft_find_constants(
	const struct soft_run *run, struct soft_kind kind)
{
	const struct soft_fragment_stages *stages = run->stages;
	struct soft_constants out = {0};

	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		const int fraction = soft_fraction(kind, i);

		out.start[i] = soft_has_color(kind) && !kind.mode &&
				(kind.wide || !soft_is_blended_freely(kind))
			? 1 << (fraction - 1)
			: 0;
		out.environment[i] = stages->environment[i];
		if (soft_is_fogged(kind)) {
			out.start[i] -=
				soft_shift(stages->far[i], fraction - 14);
			out.fog[i] = soft_shift(stages->fog[i], fraction - 15);
		}
	}
	if (soft_is_tested(kind)) {
		out.alpha_low = stages->alpha_low;
		out.alpha_range = stages->alpha_range;
	}
	if (soft_tests_texel(kind)) {
		out.alpha_low <<= 24;
		out.alpha_range = out.alpha_range << 24 | 0xFFFFFF;
	}
	if (soft_is_blended_freely(kind)) {
		out.factors_base = stages->factors_base;
		out.factors_by = stages->factors_by;
		out.unseen = stages->unseen;
	}
	return out;
}

static ALWAYS_INLINE void soft_add_fog(const struct soft_constants *constants,
	soft_word fog, struct soft_color *color)
{
	const int32_t *to = constants->fog;
	soft_int *c = color->channel;

	c[0] = WORD_BY_BOTTOM(c[0], fog, to[0]);
	c[1] = WORD_BY_BOTTOM(c[1], fog, to[1]);
	c[2] = WORD_BY_BOTTOM(c[2], fog, to[2]);
}

/* A channel in the picture's bits; limited if something was added to it. */
static ALWAYS_INLINE soft_word soft_whole(struct soft_kind kind,
	const struct soft_color *color, enum soft_channel i)
{
	int bits = kind.wide ? 8 : i == SOFT_GREEN ? 6 : 5;
	/* fog halves channels */
	int fraction = soft_fraction(kind, i) - soft_is_fogged(kind);

	return soft_is_fogged(kind) || soft_is_summed(kind)
		? LIMIT_SHIFTED(color->channel[i], fraction, bits)
		: (soft_word)color->channel[i] >> fraction;
}

/* The pixel for RGB565, blended with to. */
static ALWAYS_INLINE soft_word soft_find_565(
	struct soft_kind kind, const struct soft_color *color, soft_word to)
{
	const soft_int *c = color->channel;
	soft_word r = soft_whole(kind, color, 0), g = soft_whole(kind, color, 1);
	soft_word b = soft_whole(kind, color, 2);
	uint32_t mask = WIDE_MASK;

	if (!soft_is_blended(kind) && soft_is_aligned(kind) &&
		!soft_is_fogged(kind) && !soft_is_scaled(kind) &&
		!soft_is_summed(kind)) {
		to = (soft_word)UPPER_HALVES(c[0], c[2], 16);
		return to | to >> 5 | g << 5;
	}
	if (!soft_is_blended(kind)) {
		return (r << 6 | g) << 5 | b;
	}
	OPAQUE(mask); /* else compilers replace it by several instructions */
	to = (to | to << 16) & mask;
	to = (to * 32 + ((g << 21 | r << 11 | b) - to) * color->alpha +
		     WIDE_ROUND) >>
			5 &
		mask;
	return to | to >> 16;
}

/* Blend factors: the source's, and the destination's in the upper half. */
static ALWAYS_INLINE soft_word soft_find_factors(
	const struct soft_constants *constants, soft_word alpha)
{
	return constants->factors_base + constants->factors_by * alpha;
}

/*
 * Blends by any two factors of 256: halves of a word have 8 bits of the
 * colour, without a half added, and of the pixel.
 */
static ALWAYS_INLINE soft_word soft_mix_565(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_color *color,
	soft_word to)
{
	const soft_word alpha = color->alpha + (color->alpha >> 7);
	const soft_word factors = soft_find_factors(constants, alpha);
	soft_word out = {0};

	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		const int bits = i == SOFT_GREEN ? 6 : 5;
		const int place = i == SOFT_RED ? 11 : i == SOFT_GREEN ? 5 : 0;
		const int fraction = soft_fraction(kind, i);
		const soft_word old = to << (24 - bits - place) &
			((1u << bits) - 1) << (24 - bits);
		const int half = kind.mode ? 1 << (fraction - 1) : 0;
		const soft_word sum = HALVES_SUM_ADD(
			UPPER_HALVES(old, color->channel[i] - half,
				fraction + bits - 8),
			factors, 1u << (15 - bits));

		out = out << bits |
			LIMIT_SHIFTED((soft_int)sum, 16 - bits, bits);
	}
	return out;
}

/* The fragment's alpha as 0 to 32, for blending in RGB565. */
static ALWAYS_INLINE soft_word soft_find_alpha_32(struct soft_kind kind,
	const struct soft_texel *texel, soft_word green_alpha)
{
	return soft_has_alpha(kind)
		? (WORD_PRODUCT(green_alpha >> 16, texel->alpha) + (1 << 17)) >>
			18
		: (green_alpha + (1 << 25)) >> 26;
}

static ALWAYS_INLINE soft_word soft_find_alpha(struct soft_kind kind,
	const struct soft_texel *texel, soft_word green_alpha)
{
	soft_word product;

	if (!soft_has_alpha(kind)) {
		return green_alpha >> 23;
	}
	if (!kind.mode) {
		return soft_scale_alpha(green_alpha >> 16, texel->alpha);
	}
	/* the colour's alpha has no fraction here */
	product = WORD_PRODUCT(green_alpha >> 23, texel->alpha) + 128;
	return (product + (product >> 8)) >> 8;
}

/* Stores pixels of RGBA8888, blended with those that are there. */
static ALWAYS_INLINE void soft_store_8888(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_color *color,
	soft_word pass, uint8_t *pixel)
{
	const soft_word alpha = color->alpha;
	soft_word own = soft_whole(kind, color, 0) |
		soft_whole(kind, color, 1) << 8 |
		soft_whole(kind, color, 2) << 16 | alpha << 24;

	if (soft_is_blended(kind)) {
		own = soft_blend_bytes(soft_get_words(pixel), own, alpha);
	} else if (soft_is_blended_freely(kind)) {
		soft_word factors = soft_find_factors(constants, alpha);

		own = BYTES_ADD_LIMITED(soft_scale_bytes(own, factors & 0xFFFF),
			soft_scale_bytes(soft_get_words(pixel), factors >> 16));
	}
	if (!soft_all(pass)) {
		own = soft_choose(pass, own, soft_get_words(pixel));
	}
	soft_put_words(pixel, own);
}

/* Stores pixels of RGB565, or depths, where they pass. */
static ALWAYS_INLINE void soft_store_halves(
	soft_word own, soft_word pass, uint16_t *to)
{
	if (!soft_all(pass)) {
		own = soft_choose(pass, own, soft_get_halves(to));
	}
	soft_put_halves(to, own);
}

/* Stores pixels of RGB565, blended with those that are there. */
static ALWAYS_INLINE void soft_store_565(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_color *color,
	soft_word pass, uint8_t *pixel)
{
	const soft_word to = soft_get_halves(pixel);

	soft_store_halves(soft_is_blended_freely(kind)
			? soft_mix_565(kind, constants, color, to)
			: soft_find_565(kind, color, to),
		pass, (uint16_t *)(void *)pixel);
}

#endif
