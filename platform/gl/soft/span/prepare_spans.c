/* Chooses the span function for a state, and finds its constants. */
#include "platform/gl/soft/raster/rows.h"
#include "platform/gl/soft/span/sample.h"
#include "platform/gl/soft/span/spans.h"
#include "platform/gl/soft/stages/combine_rows.h"
#include "platform/gl/soft/stages/made.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

enum {
	/*
	 * mul_high() factor from 8.16, with half of 1/255, to factors of 1.14.
	 * White is 1/2000 more than 1, so that rounding does not change texels.
	 */
	FACTOR_SCALE = 4204558,
	BYTE_SCALE = 1 << 24, /* to 8.8 */
	/* fog's 8.16 that becomes the largest 1.15 */
	FOG_NONE = 255 << 16 | 0x8F00,
};

/*
 * Finds the range of the alpha test: alpha passes if it is low to low + range,
 * modulo 256. False if none passes. Bits 0 to 2 of a GL comparison let less,
 * equal and greater pass.
 */
static bool find_alpha_range(
	const struct fragment_state *state, struct soft_fragment_stages *stages)
{
	const GLenum function = state->alpha_function;
	const uint32_t reference = (uint32_t)soft_byte(state->alpha_reference);
	const bool less = function & 1, equal = function & 2;
	const bool greater = function & 4;
	const uint32_t count = (less ? reference : 0) + equal +
		(greater ? 255 - reference : 0);

	stages->alpha_low = (less && (equal || !greater) ? 0
					    : equal      ? reference
							 : reference + 1) &
		255;
	stages->alpha_range = count - 1;
	return count > 0;
}

/* The factor's equivalent in opaque pictures, whose destination alpha is 1. */
static GLenum find_equivalent(GLenum factor, bool opaque)
{
	if (opaque && factor == GL_DST_ALPHA) {
		return GL_ONE;
	}
	return opaque &&
			(factor == GL_ONE_MINUS_DST_ALPHA ||
				factor == GL_SRC_ALPHA_SATURATE)
		? GL_ZERO
		: factor;
}

/* A blend factor that depends on the fragment's alpha: base + alpha * by. */
struct factor {
	uint32_t base, by;
};

/* Expresses a blend factor so; false if it depends on anything else. */
static bool find_factor(GLenum factor, uint32_t one, struct factor *out)
{
	const bool inverse = factor == GL_ONE_MINUS_SRC_ALPHA;

	out->base = factor == GL_ONE || inverse ? one : 0;
	out->by = inverse ? UINT32_MAX : factor == GL_SRC_ALPHA;
	return out->base != 0 || out->by != 0 || factor == GL_ZERO;
}

/* Finds blend factors; false unless span functions can blend by them. */
static bool find_factors(
	const struct draw *draw, struct soft_fragment_stages *stages)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const bool is_565 = draw->soft->format == PIXELS_RGB565;
	const uint32_t one = is_565 ? 256 : 255;
	struct factor own, old;

	stages->blend_source = find_equivalent(state->blend_source, is_565);
	stages->blend_destination =
		find_equivalent(state->blend_destination, is_565);
	if (!find_factor(stages->blend_source, one, &own) ||
		!find_factor(stages->blend_destination, one, &old)) {
		return false;
	}
	stages->factors_base = old.base << 16 | own.base;
	stages->factors_by = (old.by << 16) + own.by;
	stages->unseen = own.base == 0 && old.base == one ? 0 : 256;
	return !draw->fogged && !draw->added;
}

/* Sets the finish: what span functions do with fragments after the texture. */
static void choose_finish(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const struct fragment_state *state = &draw->soft->fragment;
	bool tested = spans->alpha_tested, known;
	enum soft_finish finish = tested ? SOFT_TESTED : SOFT_OPAQUE;

	spans->finish = SOFT_OPAQUE;
	spans->blended_last = false;
	if (draw->attributes == 0) {
		return;
	}
	known = find_factors(draw, &spans->stages);
	if (draw->blended && !tested && state->blend_source == GL_SRC_ALPHA &&
		state->blend_destination == GL_ONE_MINUS_SRC_ALPHA) {
		finish = SOFT_BLENDED;
	} else if (draw->blended && known) {
		finish = SOFT_MIXED;
	} else {
		spans->blended_last = draw->blended;
	}
	if (draw->fogged || draw->added) {
		finish += SOFT_FOGGED;
	}
	spans->finish = finish;
}

/* What depth functions are to beside.c and span functions. */
enum {
	NEARER = 1,    /* LESS, LEQUAL: as span functions test */
	FARTHER = 2,   /* GREATER, GEQUAL: the same of inverted depths */
	OR_EQUAL = 4,  /* span functions test by LEQUAL */
	SAME = 8,      /* EQUAL */
	APART = 16,    /* soft_test() compares depths */
	REPLACED = 32, /* then all fragments pass: depths are set before */
};

/* Chooses how beside.c and span functions share the tests. */
static void choose_tests(
	const struct fragment_state *state, struct soft_spans *spans)
{
	static const uint8_t functions[8] = {APART, NEARER,
		SAME | OR_EQUAL | APART, NEARER | OR_EQUAL, FARTHER,
		APART | REPLACED, FARTHER | OR_EQUAL, REPLACED};
	const struct stencil *stencil = &state->stencil;
	const GLenum function =
		state->depth_test ? state->depth_function : GL_ALWAYS;
	const unsigned is = functions[function & 7];
	/* What is blended last has to change its depth, as LESS does. */
	const bool last = spans->blended_last;
	/* depths that are equal may be written, even if they are not to change */
	const bool writes = is & SAME || soft_keeps_depth(spans->finish) ||
		(state->depth_test && state->depth_mask);

	spans->equal_passes = is & OR_EQUAL;
	spans->depth_by_less = is & NEARER && !stencil->enabled;
	spans->depth_written = state->depth_test && state->depth_mask;
	spans->depth_replaced = is & REPLACED && spans->depth_written &&
		!spans->alpha_tested && !last;
	spans->unseen = state->color_bits == 0 && !spans->alpha_tested;
	spans->compared = function != GL_ALWAYS &&
		(last ? function != GL_LESS : is & APART);
	spans->parted = stencil->enabled || spans->compared;
	spans->tested_last = stencil->enabled && spans->alpha_tested &&
		stencil->write_mask != 0 &&
		(stencil->fail != GL_KEEP || stencil->depth_fail != GL_KEEP ||
			stencil->pass != GL_KEEP);
	spans->depths = writes && !last &&
			(is & (NEARER | SAME) || spans->depth_replaced)
		? SOFT_DEPTHS_OWN
		: (last ? function == GL_LESS : is & (NEARER | FARTHER))
		? SOFT_DEPTHS_COPIED
		: SOFT_DEPTHS_NONE;
	spans->inverted = spans->depths == SOFT_DEPTHS_COPIED && is & FARTHER;
	spans->run.depth_kept =
		spans->depths == SOFT_DEPTHS_OWN && !spans->depth_written;
	spans->direct = spans->depths == SOFT_DEPTHS_OWN &&
		!spans->depth_replaced && !spans->parted &&
		state->color_bits == UINT32_MAX;
	spans->untested = function == GL_ALWAYS && !spans->depth_written &&
		!stencil->enabled && state->color_bits == UINT32_MAX;
}

/* The largest value of so many bits, in the upper bits of 16. */
#define MOST(bits)      ((int64_t)((1 << (bits)) - 1) << (16 - (bits)))
#define RATIO(from, to) ((int32_t)(FACTOR_SCALE * MOST(to) / MOST(from)))

/* FACTOR_SCALE times the ratio of a pixel's and a texel's largest values. */
static int32_t scale_factor(int texel_bits, int pixel_bits)
{
	static const int32_t ratio[9][3] = {
		[4] = {RATIO(4, 5), RATIO(4, 6), RATIO(4, 8)},
		[5] = {RATIO(5, 5), RATIO(5, 6), RATIO(5, 8)},
		[6] = {RATIO(6, 5), RATIO(6, 6), RATIO(6, 8)},
		[8] = {RATIO(8, 5), RATIO(8, 6), RATIO(8, 8)},
	};

	return ratio[texel_bits][pixel_bits == 8 ? 2 : pixel_bits - 5];
}

/* Scales from colours of 8.16 to struct soft_run's, for a texel format. */
static struct soft_scales find_format_scales(
	enum texel_format format, bool wide, bool combined)
{
	int five = wide ? 8 : 5, six = wide ? 8 : 6;
	struct soft_field red = soft_field(format, SOFT_RED);
	struct soft_field green = soft_field(format, SOFT_GREEN);

	if (combined || (wide && red.bits == 0)) {
		return (struct soft_scales){BYTE_SCALE, BYTE_SCALE, 0, 0};
	}
	if (red.bits == 0) {
		return (struct soft_scales){31 << 19, 63 << 17, 1 << 10, 1 << 8};
	}
	return (struct soft_scales){scale_factor(red.bits, five),
		scale_factor(green.bits, six), 0, 0};
}

static void find_scales(const struct draw *draw, struct soft_spans *spans)
{
	const bool wide = spans->wide;
	enum texel_format format = !spans->textured ? TEXEL_NONE
		: spans->made                       ? TEXEL_8888
			      : draw->texture[0].base->format;
	const int32_t white = 0xFF80 << 8;

	if (spans->combined) {
		const struct soft_scales row =
			find_format_scales(TEXEL_8888, wide, false);

		spans->white[0] =
			(uint32_t)mul_high(white, row.red_blue) * 0x10001;
		spans->white[1] = (uint32_t)mul_high(white, row.green);
	}
	spans->scales = find_format_scales(format, wide,
		spans->combined || spans->made_source != SOFT_MADE);
	if (spans->finish == SOFT_MIXED && !wide) {
		/* blended before they are rounded */
		spans->scales.red_blue_half = spans->scales.green_half = 0;
	}
	if (spans->finish == SOFT_SCALED && !wide) {
		/* white of a second texture scales by 31/32 and 63/64 */
		spans->scales.red_blue += spans->scales.red_blue / 31;
		spans->scales.green += spans->scales.green / 63;
	}
}

static void find_stages(const struct draw *draw, struct soft_spans *spans)
{
	const GLfixed *color = draw->added ? draw->added : draw->soft->fog.color;
	struct soft_fragment_stages *stages = &spans->stages;

	memset(stages->far, 0, sizeof(stages->far));
	for (int i = 0; i < 3 && (draw->fogged || draw->added); i++) {
		int most = spans->wide ? 255 : i == 1 ? 63 : 31;
		int32_t value = soft_byte(color[i]) * most * 16384 / 255;

		stages->far[i] = draw->added ? -value : value + 8192;
		stages->fog[i] = draw->added ? 0 : value + 8192;
	}
}

/* Whether colours need stages that no span function has: see made.h. */
static bool is_combined(const struct draw *draw)
{
	const struct texture_input *input = &draw->texture[0];

	return draw->texture[1].used || draw->smooth ||
		(input->used &&
			(!soft_is_simple_environment(input) ||
				(soft_rows_mixes_levels(input) &&
					input->base->format == TEXEL_A8)));
}

/* Sets attributes that are not needed: white, and a fog that hides nothing. */
static void set_white(struct draw *draw, struct soft_spans *spans)
{
	const struct texture_input *input = &draw->texture[0];
	const bool replaced =
		!spans->combined && input->used && input->mode == GL_REPLACE;
	const GLenum format = input->used ? input->base->base_format : GL_RGB;
	uint32_t *constant = draw->raster.constant;

	spans->alpha_read = draw->attributes != 0 &&
		(spans->wide || spans->combined ||
			(spans->finish & SOFT_MIXED) != 0);
	if (replaced && format != GL_ALPHA) {
		spans->white_bits |= 1u << RED | 1u << GREEN | 1u << BLUE;
	}
	if (!spans->alpha_read || (replaced && soft_base_has_alpha(format))) {
		spans->white_bits |= 1u << ALPHA;
	}
	constant[FOG] = FOG_NONE;
	for (int i = RED; spans->white_bits >> i; i++) {
		if (spans->white_bits >> i & 1) {
			constant[i] = 0xFF80 << 8;
		}
	}
}

/* Whether the table has functions for the first texture's format. */
static bool has_functions(const struct draw *draw)
{
	const struct soft_spans *spans = &draw->spans;
	const int source = SOFT_NEAREST + (int)draw->texture[0].base->format - 1;

	return (*spans->table)[source][spans->finish][SOFT_ANYWHERE] != NULL;
}

/* The source of made texels whose environment a span function has. */
static enum soft_source find_made_source(const struct draw *draw)
{
	const struct texture_input *input = &draw->texture[0];

	if (!input->used || input->mode == GL_MODULATE || draw->texture[1].used ||
		draw->smooth || input->base->format == TEXEL_A8) {
		return SOFT_MADE;
	}
	return input->mode == GL_ADD      ? SOFT_MADE_ADD
		: input->mode == GL_DECAL ? SOFT_MADE_DECAL
		: input->mode == GL_BLEND ? SOFT_MADE_BLEND
					  : SOFT_MADE;
}

/* Chooses whether stages/ makes texels or colours, and how. */
static void choose_making(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const bool second = soft_choose_second(draw);

	spans->made_source =
		draw->attributes ? find_made_source(draw) : SOFT_MADE;
	spans->combined = draw->attributes != 0 && !second &&
		!spans->multiplied && is_combined(draw) &&
		spans->made_source == SOFT_MADE;
	spans->made = spans->combined || spans->multiplied ||
		spans->made_source != SOFT_MADE ||
		(spans->textured && soft_rows_mixes_levels(&draw->texture[0])) ||
		(second && !has_functions(draw));
}

/* Sets the longest runs, and which triangles' colours a list may step. */
static void choose_runs(const struct draw *draw, struct soft_spans *spans)
{
	/*
	 * Rounded steps are off by half of 1/16384 a column or row: after 128
	 * by a quarter of the picture's step. White times 255 leaves less room
	 * below 256 than white times 31 leaves below 32. Combined colours have
	 * half a step of 255 to spare.
	 */
	bool wide = draw->soft->format == PIXELS_RGBA8888 && !spans->combined;

	spans->plain_pixels = spans->direct && spans->finish == SOFT_OPAQUE &&
			!spans->combined
		? SOFT_PLAIN_PIXELS
		: SOFT_RUN_PIXELS;
	spans->longest = SOFT_RUN_PIXELS;
	spans->stepped_size = wide ? 40 : 128;
	/* an alpha test needs exactly the alpha of planes */
	if (spans->alpha_tested &&
		(spans->combined || spans->made_source != SOFT_MADE)) {
		spans->stepped_size = 0;
	}
}

/* Largest sum of columns and rows of soft_fill_small()'s triangles, or 0. */
static int find_small_size(const struct draw *draw)
{
	const struct buffers *buffers = &draw->soft->buffers;
	const struct soft_spans *spans = &draw->spans;

	if (spans->textured || spans->made ||
		buffers->target.stride_bytes !=
			buffers->width << spans->pixel_log2) {
		return 0;
	}
	return spans->stepped_size < SOFT_LISTED_SIZE ? spans->stepped_size
						      : SOFT_LISTED_SIZE;
}

bool soft_prepare_spans(struct draw *draw)
{
	struct soft_spans *spans = &draw->spans;
	const struct fragment_state *state = &draw->soft->fragment;

	spans->pixel_log2 = draw->soft->format == PIXELS_RGB565 ? 1 : 2;
	spans->stages.alpha_low = 0;
	spans->stages.alpha_range = 255;
	if (state->alpha_test && !find_alpha_range(state, &spans->stages)) {
		return false;
	}
	spans->textured = draw->texture[0].used && draw->attributes != 0;
	spans->lod_wanted = spans->textured &&
		(soft_rows_want_lod(&draw->texture[0]) ||
			soft_rows_want_lod(&draw->texture[1]));
	spans->levels[0].level = -1;
	spans->set_level = NULL;
	spans->white_bits = 0;
	spans->alpha_tested =
		state->alpha_test && state->alpha_function != GL_ALWAYS;
	choose_finish(draw);
	spans->wide =
		draw->soft->format == PIXELS_RGBA8888 || spans->blended_last;
	spans->table = spans->wide ? &soft_spans_8888 : &soft_spans_565;
	choose_making(draw);
	spans->coverage.used = false;
	choose_tests(state, spans);
	choose_runs(draw, spans);
	spans->run.rows = &spans->run.row;
	spans->run.row_count = 1;
	spans->small_size = find_small_size(draw);
	set_white(draw, spans);
	find_scales(draw, spans);
	find_stages(draw, spans);
	if (spans->made) {
		soft_prepare_made(draw);
	} else if (!spans->textured) {
		soft_set_functions(
			spans, (*spans->table)[SOFT_NO_TEXTURE][spans->finish]);
	}
	return true;
}
