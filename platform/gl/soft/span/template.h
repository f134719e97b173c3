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

#include "platform/gl/soft/stages/finish.h"

/* The mask of fragments that pass the alpha test. */
static ALWAYS_INLINE soft_word soft_passes(struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_texel *texel,
	soft_word alpha)
{
	const uint32_t low = constants->alpha_low;

	if (soft_tests_texel(kind)) {
		/* The bits below alpha may be those of green. */
		alpha = kind.format == TEXEL_8888 ? texel->lanes.green_alpha << 8
						  : texel->alpha << 24;
		return (soft_word)(alpha - low <= constants->alpha_range);
	}
	return (soft_word)(((alpha - low) & 255) <= constants->alpha_range);
}

/* The word, of a row's made texels or second ones, for the pixel of that depth. */
static ALWAYS_INLINE soft_word soft_load_word(
	uintptr_t words, const uint16_t *depth)
{
	return soft_get_words((const void *)(words + 2 * (uintptr_t)depth));
}

/* Whether blending leaves the pixel, or all four, as it is: rare without texels. */
static ALWAYS_INLINE bool soft_is_unseen(struct soft_kind kind,
	const struct soft_constants *constants, soft_word alpha)
{
	return (soft_is_blended(kind) && soft_all((soft_word)(alpha == 0))) ||
		(soft_is_blended_freely(kind) && kind.textured &&
			soft_all((soft_word)(alpha == constants->unseen)));
}

/*
 * Draws one pixel whose depth has passed, or four, of which those in pass have;
 * makes the alpha test.
 */
static ALWAYS_INLINE void soft_shade_pixel(const struct soft_run *run,
	const struct soft_rows *rows, struct soft_kind kind,
	const struct soft_constants *constants, const struct soft_pixel *at,
	soft_word pass, uint16_t *depth, uint8_t *pixel)
{
	struct soft_texel texel = {.alpha = SOFT_OPAQUE_ALPHA}, second;
	struct soft_color color;
	soft_word alpha = SOFT_OPAQUE_ALPHA;

	if (kind.made) {
		soft_split_texel(
			kind, soft_load_word(constants->made, depth), &texel);
	} else if (kind.textured && kind.inside) {
		const soft_word place = soft_safe(at->texel, pass);

		if (kind.joined) {
			soft_sample_inside(run, &rows[1],
				soft_second_kind(kind), place, &second);
		}
		soft_sample_inside(run, &rows[0], kind, place, &texel);
	} else if (kind.textured) {
		soft_sample_anywhere(
			run, run->texels, kind, at->s, at->t, &texel);
		if (kind.joined) {
			soft_sample_anywhere(run, rows[1].first,
				soft_second_kind(kind), at->s, at->t, &second);
		}
	}
	if (soft_wants_alpha(kind)) {
		alpha = kind.wide || soft_is_tested(kind)
			? soft_find_alpha(kind, &texel, at->green_alpha)
			: soft_find_alpha_32(kind, &texel, at->green_alpha);
	}
	if (soft_is_tested(kind)) {
		pass &= soft_passes(kind, constants, &texel, alpha);
		if (!soft_any(pass)) {
			return;
		}
	}
	if (soft_tests_texel(kind) && kind.format == TEXEL_8888) {
		/* else compilers filter red and blue before the test */
		OPAQUE(texel.lanes.red_blue);
		OPAQUE(texel.lanes.green_alpha);
	}
	if (!kind.kept && !(SOFT_LANES > 1 && run->depth_kept)) {
		soft_store_halves(
			kind.textured ? UPPER_HALF(at->z) : at->z >> 16, pass,
			depth);
	}
	if (soft_is_unseen(kind, constants, alpha)) {
		return;
	}
	soft_finish_texel(kind, &texel);
	if (kind.wide && kind.finish == SOFT_SCALED) {
		if (kind.joined) {
			soft_finish_texel(kind, &second);
		}
		soft_multiply_texel(kind,
			kind.joined ? soft_join(&second)
				    : soft_load_word(constants->second, depth),
			&texel);
		alpha = soft_find_alpha(kind, &texel, at->green_alpha);
	}
	if ((soft_is_scaled(kind) || soft_is_summed(kind)) && !kind.joined) {
		soft_split_second(
			soft_load_word(constants->second, depth), &second);
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
	if (kind.wide) {
		soft_store_8888(kind, constants, &color, pass, pixel);
	} else {
		soft_store_565(kind, constants, &color, pass, pixel);
	}
}

/* Finds a row's words: see struct soft_constants. */
static ALWAYS_INLINE void soft_begin_words(const struct soft_run *run,
	const struct soft_row *row, struct soft_constants *constants)
{
	const uintptr_t depths = 2 * (uintptr_t)row->depth;

	constants->second = run->second - depths;
	constants->made = (uintptr_t)run->first_texel + 4 * row->texel - depths;
}

#if SOFT_LANES == 1
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
		row->fog, row->texel, run->s.at, run->t.at};
	const uint32_t count = row->count;
	const uint16_t *end = depth + count;

	soft_begin_words(run, row, constants);
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
			soft_shade_pixel(run, rows, kind, constants, &at, 1,
				depth,
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
#else
/* Adds steps; texel's is the row's. */
static ALWAYS_INLINE void soft_step_pixel(
	const struct soft_pixel *steps, struct soft_pixel *at)
{
	at->z += steps->z;
	at->red_blue += steps->red_blue;
	at->green_alpha += steps->green_alpha;
	at->fog += steps->fog;
	at->texel += steps->texel;
	at->s += steps->s;
	at->t += steps->t;
}

static ALWAYS_INLINE struct soft_pixel soft_spread_steps(
	const struct soft_run *run, uint32_t texel_right, bool next)
{
	return (struct soft_pixel){soft_spread(run->z_right, next),
		soft_spread(run->red_blue_right, next),
		soft_spread(run->green_alpha_right, next),
		soft_spread(run->fog_right, next),
		soft_spread(texel_right, next), soft_spread(run->s.right, next),
		soft_spread(run->t.right, next)};
}

/*
 * The last pixels of a row as four, where memory may end behind them: tails
 * beyond run->last are drawn here and copied back.
 */
struct soft_tail {
	uint16_t depth[SOFT_LANES];
	uint32_t pixel[SOFT_LANES];
};

static ALWAYS_INLINE void soft_draw_row(const struct soft_run *run,
	const struct soft_row *row, const struct soft_kind kind,
	const struct soft_rows *rows, struct soft_constants *constants,
	struct soft_steps *steps)
{
	const soft_word zero = {0};
	const int pixel_log2 = kind.wide ? 2 : 1;
	struct soft_pixel at = {zero + row->z, zero + row->red_blue,
		zero + row->green_alpha, zero + row->fog, zero + row->texel,
		zero + run->s.at, zero + run->t.at};
	struct soft_pixel step = soft_spread_steps(run, row->texel_right, false);
	uint16_t *depth = row->depth;
	uint8_t *pixel = row->pixel;
	struct soft_tail tail = {{0}, {0}};

	(void)steps;
	soft_begin_words(run, row, constants);
	soft_step_pixel(&step, &at);
	step = soft_spread_steps(run, row->texel_right, true);
	for (int left = (int)row->count; left > 0; left -= SOFT_LANES) {
		const bool copied =
			left < SOFT_LANES && (uintptr_t)pixel > run->last;
		soft_word pass = soft_live(left), there, z;

		if (copied) {
			memcpy(tail.depth, depth, (size_t)left * 2);
			memcpy(tail.pixel, pixel, (size_t)left << pixel_log2);
			constants->second +=
				2 * ((uintptr_t)depth - (uintptr_t)tail.depth);
			constants->made +=
				2 * ((uintptr_t)depth - (uintptr_t)tail.depth);
		}
		there = soft_get_halves(copied ? tail.depth : depth);
		z = at.z >> 16;
		pass &= (soft_word)((soft_int)z <
			(soft_int)there + (int)kind.lequal);
		if (soft_any(pass)) {
			soft_shade_pixel(run, rows, kind, constants, &at, pass,
				copied ? tail.depth : depth,
				copied ? (uint8_t *)tail.pixel : pixel);
		}
		if (copied) {
			memcpy(depth, tail.depth, (size_t)left * 2);
			memcpy(pixel, tail.pixel, (size_t)left << pixel_log2);
		}
		depth += SOFT_LANES;
		pixel += SOFT_LANES << pixel_log2;
		soft_step_pixel(&step, &at);
	}
}
#endif

static SOFT_TEXT void soft_draw_rows(
	const struct soft_run *given, const struct soft_kind kind)
{
	/* a local copy: the compiler sees that no pixel overwrites it */
	struct soft_run own = *given;
	const struct soft_run *run = &own;
	struct soft_constants constants = soft_find_constants(run, kind);
	struct soft_steps steps = soft_find_steps(run);
	const uint8_t *first = kind.inside ? run->first_texel : run->texels;
	/* of the texture, and of a joined second one */
	struct soft_rows rows[2] = {{first, 1u << run->stride_log2}};
	const struct soft_row *row = run->rows, *end = row + run->row_count;

	if (kind.joined) {
		rows[1].first = (const uint8_t *)((uintptr_t)first + run->joint);
		rows[1].stride = rows[0].stride;
	}
	if (kind.textured && !kind.inside) {
		soft_draw_row(run, row, kind, rows, &constants, &steps);
		return;
	}
	for (; row < end; row++) {
		const struct soft_row its = *row;

		KEEP_IN_MEMORY(end); /* leaves registers to the pixels */
		KEEP_IN_MEMORY(row);
		soft_draw_row(run, &its, kind, rows, &constants, &steps);
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
	if (!kind.inside || run->row_count == 0 || SOFT_LANES > 1) {
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
	return ((int)kind.finish & ~SOFT_FOGGED) == SOFT_TESTED &&
		soft_has_alpha(kind) &&
		(run->green_alpha_right + 0x8000) >> 16 == 0 &&
		row->green_alpha >> 16 >= SOFT_SOLID_ALPHA &&
		row[run->row_count - 1].green_alpha >> 16 >= SOFT_SOLID_ALPHA;
}

static SOFT_TEXT void soft_draw_run(
	const struct soft_run *run, const struct soft_kind kind)
{
	struct soft_kind still = kind, kept = kind;

	still.still = kept.kept = true;
	if (soft_is_still(run, kind)) {
		soft_draw_rows(run, still);
	} else if (SOFT_LANES == 1 && soft_keeps_depth(kind.finish) &&
		run->depth_kept) {
		soft_draw_rows(run, kept);
	} else {
		soft_draw_rows(run, kind);
	}
}

#endif
