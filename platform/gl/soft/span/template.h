/*
 * The code of all span functions. struct soft_kind switches its stages: each
 * function of a table inlines this code with a constant kind, so that the
 * compiler removes all that the function does not need.
 *
 * A pixel's stages: depth test; texel, nearest or bilinear; alpha test; depth
 * is written; times a second texture's texel; times the colour; fog, or a
 * second texel is added; blending; the pixel is written.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_TEMPLATE_H
#define PLATFORM_GL_SOFT_SPAN_TEMPLATE_H

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/stages/second.h"

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
	/* address of the row's second texels minus twice that of its depths */
	uintptr_t second;
};

static ALWAYS_INLINE int32_t soft_start(struct soft_kind kind,
	const struct soft_constants *constants, enum soft_channel channel)
{
	return soft_is_fogged(kind)    ? constants->start[channel]
		: soft_has_color(kind) ? soft_half(kind, channel)
				       : 0;
}

/* Texel times colour, with a half added; formats are those of run.h. */
static ALWAYS_INLINE struct soft_color soft_modulate(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	const struct soft_pixel *at)
{
	uint32_t rb = at->red_blue, ga = at->green_alpha;
	int32_t red = soft_start(kind, constants, SOFT_RED);
	int32_t green = soft_start(kind, constants, SOFT_GREEN);
	int32_t blue = soft_start(kind, constants, SOFT_BLUE);
	const uint32_t *c = texel->channel;
	struct soft_color out;

	if (!soft_has_color(kind)) {
		red += (int32_t)(rb & 0xFFFF);
		green += (int32_t)(ga & 0xFFFF);
		blue += (int32_t)(rb >> 16);
	} else if (soft_is_mixed(kind) || soft_is_aligned(kind) ||
		soft_is_scaled(kind)) {
		red = WORD_BY_BOTTOM(c[0], rb, red);
		green = WORD_BY_BOTTOM(c[1], ga, green);
		blue = WORD_BY_TOP(c[2], rb, blue);
	} else if (kind.format == TEXEL_8888) {
		red = HALVES_BB(texel->lanes.red_blue, rb, red);
		green = HALVES_BB(texel->lanes.green_alpha, ga, green);
		blue = HALVES_TT(texel->lanes.red_blue, rb, blue);
	} else {
		red = HALVES_BB(c[0], rb, red);
		green = HALVES_BB(c[1], ga, green);
		blue = HALVES_BT(c[2], rb, blue);
	}
	out.channel[0] = red;
	out.channel[1] = green;
	out.channel[2] = blue;
	return out;
}

static ALWAYS_INLINE int32_t soft_shift(int32_t value, int bits)
{
	return bits >= 0 ? value * (1 << bits) : value >> -bits;
}

static ALWAYS_INLINE void soft_find_fog(const struct soft_run *run,
	struct soft_kind kind, enum soft_channel channel,
	struct soft_constants *out)
{
	const struct soft_fragment_stages *stages = run->stages;
	int fraction = soft_fraction(kind, channel);

	out->start[channel] =
		(soft_has_color(kind) ? soft_half(kind, channel) : 0) -
		soft_shift(stages->far[channel], fraction - 14);
	out->fog[channel] = soft_shift(stages->fog[channel], fraction - 15);
}

static ALWAYS_INLINE struct soft_constants soft_find_constants(
	const struct soft_run *run, struct soft_kind kind)
{
	struct soft_constants out = {0};

	if (soft_is_fogged(kind)) {
		soft_find_fog(run, kind, SOFT_RED, &out);
		soft_find_fog(run, kind, SOFT_GREEN, &out);
		soft_find_fog(run, kind, SOFT_BLUE, &out);
	}
	if (soft_is_tested(kind)) {
		out.alpha_low = run->stages->alpha_low;
		out.alpha_range = run->stages->alpha_range;
	}
	if (soft_tests_texel(kind)) {
		out.alpha_low <<= 24;
		out.alpha_range = out.alpha_range << 24 | 0xFFFFFF;
	}
	if (soft_is_blended_freely(kind)) {
		out.factors_base = run->stages->factors_base;
		out.factors_by = run->stages->factors_by;
		out.unseen = run->stages->unseen;
	}
	return out;
}

static ALWAYS_INLINE void soft_add_fog(const struct soft_constants *constants,
	uint32_t fog, struct soft_color *color)
{
	const int32_t *to = constants->fog;
	int32_t *c = color->channel;

	c[0] = WORD_BY_BOTTOM(c[0], fog, to[0]);
	c[1] = WORD_BY_BOTTOM(c[1], fog, to[1]);
	c[2] = WORD_BY_BOTTOM(c[2], fog, to[2]);
}

/* A channel in the picture's bits; limited if something was added to it. */
static ALWAYS_INLINE uint32_t soft_whole(struct soft_kind kind,
	const struct soft_color *color, enum soft_channel i)
{
	int bits = kind.wide ? 8 : i == SOFT_GREEN ? 6 : 5;
	int fraction = soft_last_fraction(kind, i);

	return soft_is_fogged(kind) || soft_is_summed(kind)
		? LIMIT_SHIFTED(color->channel[i], fraction, bits)
		: (uint32_t)color->channel[i] >> fraction;
}

static ALWAYS_INLINE void soft_store_565(
	struct soft_kind kind, const struct soft_color *color, uint16_t *pixel)
{
	const int32_t *c = color->channel;
	uint32_t r = soft_whole(kind, color, 0), g = soft_whole(kind, color, 1);
	uint32_t b = soft_whole(kind, color, 2);
	uint32_t mask = WIDE_MASK, to = *pixel;

	if (!soft_is_blended(kind) && soft_is_aligned(kind) &&
		!soft_is_fogged(kind) && !soft_is_scaled(kind) &&
		!soft_is_summed(kind)) {
		to = UPPER_HALVES(c[0], c[2]);
		*pixel = (uint16_t)(to | to >> 5 | g << 5);
		return;
	}
	if (!soft_is_blended(kind)) {
		*pixel = (uint16_t)((r << 6 | g) << 5 | b);
		return;
	}
	OPAQUE(mask); /* else compilers replace it by several instructions */
	to = (to | to << 16) & mask;
	to = (to * 32 + ((g << 21 | r << 11 | b) - to) * color->alpha +
		     WIDE_ROUND) >>
			5 &
		mask;
	*pixel = narrow(to);
}

/* Blend factors: the source's, and the destination's in the upper half. */
static ALWAYS_INLINE uint32_t soft_find_factors(
	const struct soft_constants *constants, uint32_t alpha)
{
	return constants->factors_base + constants->factors_by * alpha;
}

/*
 * Blends by any two factors of 256: sums have RGB565's fields in the upper bits
 * of 16. The half that the colour includes is taken out before it is scaled.
 */
static ALWAYS_INLINE void soft_mix_565(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_color *color,
	uint16_t *pixel)
{
	const uint32_t alpha = color->alpha + (color->alpha >> 7);
	const uint32_t factors = soft_find_factors(constants, alpha);
	const uint32_t own = factors & 0xFFFF, old = factors >> 16;
	const uint32_t to = *pixel;
	const uint32_t red_blue =
		(uint32_t)color->channel[0] >> (soft_fraction(kind, 0) - 3) |
		(uint32_t)color->channel[2] >> (soft_fraction(kind, 2) - 3)
				<< 16;
	const uint32_t green =
		(uint32_t)color->channel[1] >> (soft_fraction(kind, 1) - 2);
	uint32_t rb =
		HALVES_ADD_LIMITED((red_blue - 0x00040004) * own + 0x04000400,
			(((to & 0xF800) | to << 27) >> 8) * old);
	uint32_t g = HALVES_ADD_LIMITED(
		(green - 2) * own + 0x0200, ((to & 0x07E0) >> 3) * old);

	*pixel = (uint16_t)((rb & 0xF800) | rb >> 27 | g >> 10 << 5);
}

/* The fragment's alpha as 0 to 32, for blending in RGB565. */
static ALWAYS_INLINE uint32_t soft_find_alpha_32(struct soft_kind kind,
	const struct soft_texel *texel, uint32_t green_alpha)
{
	return soft_has_alpha(kind)
		? ((green_alpha >> 16) * texel->alpha + (1 << 17)) >> 18
		: (green_alpha + (1 << 25)) >> 26;
}

static ALWAYS_INLINE uint32_t soft_find_alpha(struct soft_kind kind,
	const struct soft_texel *texel, uint32_t green_alpha)
{
	return soft_has_alpha(kind)
		? soft_scale_alpha(green_alpha >> 16, texel->alpha)
		: green_alpha >> 23;
}

static ALWAYS_INLINE void soft_store_8888(struct soft_kind kind,
	const struct soft_constants *constants, uint32_t own, uint8_t *pixel)
{
	const uint32_t alpha = own >> 24;

	if (soft_is_blended(kind)) {
		own = soft_blend_bytes(load_32(pixel), own, alpha);
	} else if (soft_is_blended_freely(kind)) {
		uint32_t factors = soft_find_factors(constants, alpha);

		own = BYTES_ADD_LIMITED(soft_scale_bytes(own, factors & 0xFFFF),
			soft_scale_bytes(load_32(pixel), factors >> 16));
	}
	memcpy(pixel, &own, sizeof(own));
}

/* The colour for an RGBA8888 picture; alpha is the fragment's. */
static ALWAYS_INLINE uint32_t soft_find_bytes(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	const struct soft_pixel *at, uint32_t alpha)
{
	struct soft_color color;

#ifdef HAS_COLOR_VECTORS
	if (kind.format == TEXEL_8888 && !soft_is_fogged(kind)) {
		return vector_scale(texel->vector, at->red_blue,
			       at->green_alpha & 0xFFFF) |
			alpha << 24;
	}
#endif
	color = soft_modulate(kind, constants, texel, at);
	if (soft_is_fogged(kind)) {
		soft_add_fog(constants, at->fog, &color);
	}
	return soft_whole(kind, &color, 0) | soft_whole(kind, &color, 1) << 8 |
		soft_whole(kind, &color, 2) << 16 | alpha << 24;
}

static ALWAYS_INLINE bool soft_passes(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	uint32_t alpha)
{
	const uint32_t low = constants->alpha_low;

	if (soft_tests_texel(kind)) {
		/* The bits below alpha may be those of green. */
		alpha = kind.format == TEXEL_8888 ? texel->lanes.green_alpha << 8
						  : texel->alpha << 24;
		return alpha - low <= constants->alpha_range;
	}
	return !soft_is_tested(kind) ||
		((alpha - low) & 255) <= constants->alpha_range;
}

/* The second texture's word for the pixel with that depth. */
static ALWAYS_INLINE uint32_t soft_load_second(
	const struct soft_constants *constants, const uint16_t *depth)
{
	return *(const uint32_t *)(constants->second + 2 * (uintptr_t)depth);
}

/* Draws one pixel whose depth has passed; makes the alpha test. */
static ALWAYS_INLINE void soft_shade_pixel(const struct soft_run *run,
	const struct soft_rows *rows, struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_pixel *at,
	uint16_t *depth, uint8_t *pixel)
{
	struct soft_texel texel = {.alpha = 255}, second;
	struct soft_color color;
	uint32_t alpha = 255;

	if (kind.textured && kind.inside) {
		soft_sample_inside(run, rows, kind, at->texel, &texel, &second);
	} else if (kind.textured) {
		soft_sample_anywhere(
			run, run->texels, kind, at->s, at->t, &texel);
		if (kind.joined) {
			soft_sample_anywhere(run,
				(const uint8_t *)((uintptr_t)run->texels +
					run->joint),
				soft_second_kind(kind), at->s, at->t, &second);
		}
	}
	if (soft_wants_alpha(kind)) {
		alpha = kind.wide || soft_is_tested(kind)
			? soft_find_alpha(kind, &texel, at->green_alpha)
			: soft_find_alpha_32(kind, &texel, at->green_alpha);
	}
	if (!soft_passes(kind, constants, &texel, alpha)) {
		return;
	}
	if (soft_tests_texel(kind) && kind.format == TEXEL_8888) {
		/* else compilers filter red and blue before the test */
		OPAQUE(texel.lanes.red_blue);
		OPAQUE(texel.lanes.green_alpha);
	}
	*depth = (uint16_t)(kind.textured ? UPPER_HALF(at->z) : at->z >> 16);
	if ((soft_is_blended(kind) && alpha == 0) ||
		(soft_is_blended_freely(kind) && alpha == constants->unseen)) {
		return;
	}
	soft_finish_texel(kind, &texel);
	if (kind.wide) {
		if (kind.finish == SOFT_SCALED) {
			if (kind.joined) {
				soft_finish_texel(kind, &second);
			}
			soft_multiply_texel(kind,
				kind.joined ? soft_join(&second)
					    : soft_load_second(constants, depth),
				&texel);
			alpha = soft_find_alpha(kind, &texel, at->green_alpha);
		}
		soft_store_8888(kind, constants,
			soft_find_bytes(kind, constants, &texel, at, alpha),
			pixel);
		return;
	}
	if ((soft_is_scaled(kind) || soft_is_summed(kind)) && !kind.joined) {
		soft_split_second(soft_load_second(constants, depth), &second);
	}
	if (soft_is_scaled(kind)) {
		soft_scale_texel(kind, &second, &texel);
	}
	color = soft_modulate(kind, constants, &texel, at);
	color.alpha = alpha;
	if (soft_is_fogged(kind)) {
		soft_add_fog(constants, at->fog, &color);
	}
	if (soft_is_summed(kind)) {
		soft_add_second(kind, &second, &color);
	}
	if (soft_is_blended_freely(kind)) {
		soft_mix_565(kind, constants, &color, (uint16_t *)(void *)pixel);
	} else {
		soft_store_565(kind, &color, (uint16_t *)(void *)pixel);
	}
}

static ALWAYS_INLINE void soft_step_pixel(const struct soft_run *run,
	struct soft_kind kind, struct soft_steps *steps, struct soft_pixel *at)
{
	const uint64_t place = soft_get_steps(kind, steps->z_texel);
	uint64_t two = (uint64_t)-0x10000 << 32; /* counts in green_alpha */

	if (!soft_is_constant(kind)) {
		two = soft_get_steps(kind, steps->colors);
	}
	at->z += (uint32_t)place;
	at->texel += (uint32_t)(place >> 32);
	at->red_blue += (uint32_t)two;
	at->green_alpha += (uint32_t)(two >> 32);
	if (soft_is_fogged(kind)) {
		at->fog += run->fog_right;
	}
	if (kind.textured && !kind.inside) {
		two = soft_get_steps(kind, steps->s_t);
		at->s += (uint32_t)two;
		at->t += (uint32_t)(two >> 32);
	}
}

static ALWAYS_INLINE void soft_draw_row(const struct soft_run *run,
	const struct soft_row *row, const struct soft_kind kind,
	const struct soft_rows *rows, struct soft_constants *constants,
	struct soft_steps *steps)
{
	uint16_t *depth = row->depth;
	uint8_t *pixel = row->pixel;
	/* a depth has as many bytes as a pixel of RGB565 */
	uintptr_t distance = (uintptr_t)pixel - (uintptr_t)depth;
	struct soft_pixel at = {row->z, row->red_blue, row->green_alpha,
		row->fog, row->texel, (uint32_t)run->s, (uint32_t)run->t};
	const uint32_t count = row->count;
	const uint16_t *end = depth + count;

	constants->second = run->second - 2 * (uintptr_t)depth;
	steps->z_texel[1] = row->texel_right;
	/*
	 * The upper half counts pixels. Green below it is less than 2^15, so
	 * that the step behind the last pixel does not carry. In a run of one
	 * pixel that step may be larger: it is left out.
	 */
	if (soft_counts_by_green(kind)) {
		steps->colors[1] =
			(count > 1 ? run->green_alpha_right : 0) - 0x10000;
		at.green_alpha &= soft_tests_texel(kind) ? 0xFFFF : UINT32_MAX;
		at.green_alpha += (count - 1) << 16;
	}
	do {
		if (kind.lequal ? at.z >> 16 <= *depth : at.z >> 16 < *depth) {
			soft_shade_pixel(run, rows, kind, constants, &at, depth,
				kind.wide ? pixel
					  : (uint8_t *)((uintptr_t)depth +
						    distance));
		}
		depth++;
		pixel += kind.wide ? 4 : 0;
		soft_step_pixel(run, kind, steps, &at);
	} while (soft_counts_by_green(kind) ? (int32_t)at.green_alpha >= 0
					    : depth != end);
}

static SOFT_TEXT void soft_draw_rows(
	const struct soft_run *given, const struct soft_kind kind)
{
	/* a local copy: the compiler sees that no pixel overwrites it */
	struct soft_run own = *given;
	const struct soft_run *run = &own;
	struct soft_constants constants = soft_find_constants(run, kind);
	struct soft_steps steps = soft_find_steps(run);
	const struct soft_rows rows = {
		run->first_texel, 1u << run->stride_log2, run->joint};
	const struct soft_row *row = run->rows, *end = row + run->row_count;

	if (kind.textured && !kind.inside) {
		soft_draw_row(run, row, kind, &rows, &constants, &steps);
		return;
	}
	for (; row < end; row++) {
		const struct soft_row its = *row;

		KEEP_IN_MEMORY(end); /* leaves registers to the pixels */
		KEEP_IN_MEMORY(row);
		soft_draw_row(run, &its, kind, &rows, &constants, &steps);
		own.second += 4 * its.count;
	}
}

enum {
	/* 8.7; from 255 << 7 on, soft_scale_alpha() does not change a texel's */
	SOFT_SOLID_ALPHA = (255 << 7) + SOFT_LISTED_SIZE,
};

/*
 * Whether the faster loop of kind.still can draw the runs: opaque ones of one
 * colour, or alpha-tested ones whose own alpha is 255.
 */
static ALWAYS_INLINE bool soft_is_still(
	const struct soft_run *run, struct soft_kind kind)
{
	const struct soft_row *row = run->rows;

	/* coverage may have removed all of a triangle's runs */
	if (!kind.inside || run->row_count == 0) {
		return false;
	}
	if (kind.finish == SOFT_OPAQUE) {
		return !kind.wide &&
			(run->red_blue_right | run->green_alpha_right) == 0;
	}
	/*
	 * If alpha's step across is 0 in whole units, alpha is at most a unit a
	 * pixel below that of the first and the last run.
	 */
	return (kind.finish == SOFT_TESTED || kind.finish == SOFT_TESTED_FOG) &&
		soft_has_alpha(kind) &&
		(run->green_alpha_right + 0x8000) >> 16 == 0 &&
		row->green_alpha >> 16 >= SOFT_SOLID_ALPHA &&
		row[run->row_count - 1].green_alpha >> 16 >= SOFT_SOLID_ALPHA;
}

static SOFT_TEXT void soft_draw_run(
	const struct soft_run *run, const struct soft_kind kind)
{
	struct soft_kind still = kind;

	still.still = true;
	if (soft_is_still(run, kind)) {
		soft_draw_rows(run, still);
	} else {
		soft_draw_rows(run, kind);
	}
}

#endif
