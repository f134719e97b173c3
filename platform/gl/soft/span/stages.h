/*
 * The first stages of span functions (template.h): which stages a function has,
 * and how it reads and filters texels.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_STAGES_H
#define PLATFORM_GL_SOFT_SPAN_STAGES_H

#include "platform/gl/soft/span/run.h"
#include "platform/gl/soft/span/sample.h"

struct soft_kind {
	bool textured, linear;
	enum texel_format format;
	bool inside; /* texels lie in the window; soft_run.first_texel is set */
	enum soft_finish finish;
	bool wide;   /* the picture is RGBA8888, else RGB565 */
	bool lequal; /* the depth test is LEQUAL, else LESS */
	bool still;  /* see soft_is_still() */
	bool kept;   /* depths stay as they are */
	bool joined; /* two textures are read at the same place */
	bool made;   /* the source is SOFT_MADE, or, of other modes, the next */
	GLenum mode; /* of the texture environment; 0: GL_MODULATE */
};

/*
 * Each span function is an inlined copy of template.h's code. In builds with
 * sanitizers, all share one copy, whose kind is no constant: there, compilers
 * would need half a minute for each table of copies.
 */
#ifdef SOFT_SHARED_TEXT
#define SOFT_TEXT __attribute__((noinline))
#else
#define SOFT_TEXT ALWAYS_INLINE
#endif

/* Expands the macro make for each texel format. */
#define SOFT_EACH_FORMAT(make, ...)                                           \
	make(565, TEXEL_565, __VA_ARGS__) make(4444, TEXEL_4444, __VA_ARGS__) \
		make(5551, TEXEL_5551, __VA_ARGS__) make(8888, TEXEL_8888,    \
			__VA_ARGS__) make(l8, TEXEL_L8, __VA_ARGS__)          \
			make(a8, TEXEL_A8, __VA_ARGS__)                       \
				make(la88, TEXEL_LA88, __VA_ARGS__)

/* A texel's alpha where the format has none. */
#define SOFT_OPAQUE_ALPHA ((soft_word){0} + 255)

/* A pixel's values, in struct soft_row's formats. */
struct soft_pixel {
	soft_word z, red_blue, green_alpha, fog;
	soft_word texel; /* kind.inside */
	soft_word s, t;  /* else */
};

/* A texel: RGBA8888 in lanes; others in channel, times 8192 if filtered. */
struct soft_texel {
	struct soft_lanes lanes;
	struct soft_four four; /* red and blue are filtered later */
	soft_word channel[3];
	soft_word alpha; /* 8 bits */
};

struct soft_color {
	soft_int channel[3]; /* with soft_fraction() bits of fraction */
	soft_word alpha;     /* 0 to 255, or 0 to 32 if blended in RGB565 */
};

/* What happens to the colour: SOFT_FOGGED, SOFT_SUMMED, SOFT_SCALED or 0. */
static ALWAYS_INLINE int soft_get_addition(struct soft_kind kind)
{
	return (int)kind.finish & ~SOFT_MIXED;
}

static ALWAYS_INLINE bool soft_is_fogged(struct soft_kind kind)
{
	return soft_get_addition(kind) == SOFT_FOGGED;
}

static ALWAYS_INLINE bool soft_is_tested(struct soft_kind kind)
{
	return kind.finish & SOFT_TESTED; /* SOFT_MIXED, too */
}

static ALWAYS_INLINE bool soft_is_blended(struct soft_kind kind)
{
	return (kind.finish & SOFT_MIXED) == SOFT_BLENDED;
}

/* Whether channels are multiplied by those of a second texture's texel. */
static ALWAYS_INLINE bool soft_is_scaled(struct soft_kind kind)
{
	return kind.textured && kind.finish == SOFT_SCALED && !kind.wide;
}

/* Whether a second texture's texel is added to the colour. */
static ALWAYS_INLINE bool soft_is_summed(struct soft_kind kind)
{
	return kind.textured && soft_get_addition(kind) == SOFT_SUMMED;
}

static ALWAYS_INLINE bool soft_is_blended_freely(struct soft_kind kind)
{
	return kind.finish == SOFT_MIXED;
}

static ALWAYS_INLINE bool soft_has_alpha(struct soft_kind kind)
{
	return kind.textured && kind.mode != GL_DECAL &&
		soft_field(kind.format, SOFT_ALPHA).bits > 0;
}

/* Whether the colour is constant in the run, alpha included. */
static ALWAYS_INLINE bool soft_is_constant(struct soft_kind kind)
{
	return kind.still && !soft_is_tested(kind);
}

/* Whether the alpha test uses the texel's alpha, the colour's being 255. */
static ALWAYS_INLINE bool soft_tests_texel(struct soft_kind kind)
{
	return soft_is_tested(kind) && kind.still;
}

static ALWAYS_INLINE bool soft_wants_alpha(struct soft_kind kind)
{
	return (soft_is_tested(kind) && !soft_tests_texel(kind)) ||
		soft_is_blended(kind) || kind.wide;
}

/* Whether green_alpha's upper half counts pixels: green has 15 bits, alpha none. */
static ALWAYS_INLINE bool soft_counts_by_green(struct soft_kind kind)
{
	return !soft_wants_alpha(kind) && !kind.mode;
}

static ALWAYS_INLINE bool soft_has_color(struct soft_kind kind)
{
	return kind.textured && kind.format != TEXEL_A8;
}

/* Whether channels are filtered, and so are 8192 times their values. */
static ALWAYS_INLINE bool soft_is_mixed(struct soft_kind kind)
{
	return kind.linear && kind.format != TEXEL_8888;
}

/*
 * RGB565 texels in an RGB565 picture: channels are shifted, or filtered in
 * place, so that each has 16 fraction bits after it is multiplied with the
 * colour, unless it is scaled by a second texture.
 */
static ALWAYS_INLINE bool soft_is_aligned(struct soft_kind kind)
{
	return (kind.linear || kind.still) && kind.format == TEXEL_565 &&
		!kind.wide;
}

/* Steps a pixel of struct soft_pixel's values, in pairs. */
struct soft_steps {
	_Alignas(8) uint32_t z_texel[2];
	uint32_t colors[2], s_t[2];
};

static ALWAYS_INLINE struct soft_steps soft_find_steps(
	const struct soft_run *run)
{
	return (struct soft_steps){{run->z_right, 0},
		{run->red_blue_right, run->green_alpha_right},
		{run->s.right, run->t.right}};
}

/* Reads a pair of steps: from memory, if texels need the registers. */
static ALWAYS_INLINE uint64_t soft_get_steps(
	struct soft_kind kind, uint32_t pair[2])
{
	if (!kind.textured || (soft_is_constant(kind) && !kind.linear)) {
		return pair[0] | (uint64_t)pair[1] << 32;
	}
	KEEP_IN_MEMORY(pair[0]);
	return load_two_words(pair);
}

/* Fraction bits of soft_color.channel, whose integer part the picture stores. */
static ALWAYS_INLINE int soft_fraction(
	struct soft_kind kind, enum soft_channel channel)
{
	int bits = kind.wide ? 8 : channel == SOFT_GREEN ? 6 : 5;

	if (kind.mode) {
		return 16 - bits;
	}
	if (soft_is_scaled(kind)) {
		return (soft_is_aligned(kind)                ? 18 - 16
				       : soft_is_mixed(kind) ? 13
							     : 0) +
			11 + 14 - 16 + soft_field(kind.format, channel).bits -
			bits;
	}
	if (soft_is_aligned(kind)) {
		return 16;
	}
	if (!soft_has_color(kind)) {
		/* Green leaves room for a step, see soft_draw_row(). */
		return channel == SOFT_GREEN && !kind.wide ? 15 - bits
							   : 16 - bits;
	}
	return (soft_is_mixed(kind) ? 13 + 14 - 16 : 14) +
		soft_field(kind.format, channel).bits - bits;
}

static ALWAYS_INLINE void soft_split_texel(
	struct soft_kind kind, soft_word texel, struct soft_texel *out)
{
	struct soft_field alpha = soft_field(kind.format, SOFT_ALPHA);

	if (kind.format == TEXEL_8888) {
		out->lanes = (struct soft_lanes){
			BYTES_AS_HALVES(texel), ODD_BYTES_AS_HALVES(texel)};
		out->alpha = out->lanes.green_alpha >> 16;
		return;
	}
	if (soft_is_aligned(kind)) {
		uint32_t five = 0x1F << 18, six = 0x3F << 18;

		OPAQUE(five); /* else compilers use two or more shifts */
		OPAQUE(six);
		out->channel[0] = texel << 7 & five;
		out->channel[1] = texel << 13 & six;
		out->channel[2] = texel << 18 & five;
		return;
	}
	out->channel[0] = soft_get_field(kind.format, SOFT_RED, texel);
	out->channel[1] = soft_get_field(kind.format, SOFT_GREEN, texel);
	out->channel[2] = soft_get_field(kind.format, SOFT_BLUE, texel);
	out->alpha = alpha.bits == 0
		? SOFT_OPAQUE_ALPHA
		: soft_widen_field(
			  soft_get_field(kind.format, SOFT_ALPHA, texel),
			  alpha.bits);
}

static ALWAYS_INLINE void soft_mix_pairs(struct soft_kind kind, soft_word above,
	soft_word below, struct soft_weights weights, struct soft_texel *out)
{
	struct soft_field alpha = soft_field(kind.format, SOFT_ALPHA);

	if (soft_is_aligned(kind)) {
		uint32_t green = 0x07E007E0;

		OPAQUE(green); /* else compilers load it twice */
		*out = (struct soft_texel){
			.channel = {soft_mix_masked(above >> 6, below >> 6,
					    0x03E003E0, weights),
				soft_mix_masked(above, below, green, weights),
				soft_mix_masked(above << 5, below << 5,
					0x03E003E0, weights)},
			.alpha = SOFT_OPAQUE_ALPHA};
		return;
	}
	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		out->channel[i] =
			soft_mix_channel(kind.format, i, above, below, weights);
	}
	out->alpha = alpha.bits == 0
		? SOFT_OPAQUE_ALPHA
		: soft_narrow_mixed(soft_mix_channel(kind.format, SOFT_ALPHA,
					    above, below, weights),
			  alpha.bits);
}

/* Filters RGBA8888: only green and alpha, until the fragment has passed. */
static ALWAYS_INLINE void soft_mix_green(struct soft_kind kind,
	const soft_word above[2], const soft_word below[2], soft_word s,
	soft_word t, struct soft_texel *out)
{
	out->four = soft_weigh_8888(above, below, s, t, kind.wide);
	out->lanes.green_alpha = soft_mix_half(&out->four, true, kind.wide);
	out->alpha = out->lanes.green_alpha >> 16;
}

/* A texel of RGBA8888 as a word. */
static ALWAYS_INLINE soft_word soft_join(const struct soft_texel *texel)
{
	return texel->lanes.red_blue | texel->lanes.green_alpha << 8;
}

/* The kind of a joined second texture: RGB565, or RGBA8888 in such pictures. */
static ALWAYS_INLINE struct soft_kind soft_second_kind(struct soft_kind kind)
{
	return (struct soft_kind){.textured = true,
		.format = kind.wide ? TEXEL_8888 : TEXEL_565,
		.linear = kind.linear,
		.wide = kind.wide,
		.joined = true};
}

/* Reads the texel of a run in the window. */
static ALWAYS_INLINE void soft_sample_inside(const struct soft_run *run,
	const struct soft_rows *rows, struct soft_kind kind, soft_word texel,
	struct soft_texel *out)
{
	const int bytes_log2 = soft_texel_bytes_log2(kind.format);
	const soft_word row = texel >> (16 + SOFT_TEXEL_FRACTION);
	const soft_word x = texel >> (SOFT_TEXEL_FRACTION - bytes_log2) &
		((SOFT_RUN_TEXELS - 1u) << bytes_log2);
	soft_word above[2], below[2], s, t;

	if (!kind.linear || bytes_log2 == 0) {
		const uint8_t *first = rows->first;
		soft_word at = (row << run->stride_log2) + x;

		OPAQUE(at); /* else compilers need two more registers */
		if (!kind.linear) {
			soft_split_texel(kind,
				soft_load_texels(kind.format, first, at), out);
			return;
		}
		above[0] = soft_load_pair(kind.format, first, at);
		below[0] = soft_load_pair(
			kind.format, first + (1u << run->stride_log2), at);
	} else {
		soft_load_rows(rows, row, x, run->stride_log2, bytes_log2 == 2,
			above, below);
	}
	if (kind.format == TEXEL_8888) {
		soft_mix_green(kind, above, below, texel, texel >> 16, out);
		return;
	}
	s = texel >> (SOFT_TEXEL_FRACTION - 5);
	t = texel >> (16 + SOFT_TEXEL_FRACTION - 8);
	if (!kind.joined) { /* joined textures share their weights */
		s = SHIFT_HERE(texel, SOFT_TEXEL_FRACTION - 5);
		t = SHIFT_HERE(texel, 16 + SOFT_TEXEL_FRACTION - 8);
	}
	soft_mix_pairs(kind, above[0], below[0], soft_weigh(s, t), out);
}

/* Reads a texel of coordinates that may wrap around. */
static ALWAYS_INLINE void soft_sample_anywhere(const struct soft_run *run,
	const uint8_t *texels, struct soft_kind kind, soft_word s, soft_word t,
	struct soft_texel *out)
{
	const enum texel_format format = kind.format;
	const int bytes_log2 = soft_texel_bytes_log2(format);
	const soft_word x = s >> SOFT_TEXEL_FRACTION & run->s_last;
	const soft_word y = t >> SOFT_TEXEL_FRACTION & run->t_last;
	const soft_word above = y << run->stride_log2;
	const soft_word below = ((y + 1) & run->t_last) << run->stride_log2;
	const soft_word left = x << bytes_log2, last = x == run->s_last;
	soft_word right, a[2], b[2];

	if (!kind.linear) {
		a[0] = soft_load_texels(format, texels, above + left);
		soft_split_texel(kind, a[0], out);
		return;
	}
	if (format != TEXEL_8888) {
		a[0] = soft_load_pair(format, texels, above + left);
		b[0] = soft_load_pair(format, texels, below + left);
		if (soft_any(last)) {
			a[1] = soft_load_texels(format, texels, above) << 16;
			b[1] = soft_load_texels(format, texels, below) << 16;
			a[0] = soft_choose(last, (a[0] & 0xFFFF) | a[1], a[0]);
			b[0] = soft_choose(last, (b[0] & 0xFFFF) | b[1], b[0]);
		}
		soft_mix_pairs(kind, a[0], b[0],
			soft_weigh(s >> (SOFT_TEXEL_FRACTION - 5),
				t >> (SOFT_TEXEL_FRACTION - 8)),
			out);
		return;
	}
	right = ((x + 1) & run->s_last) << bytes_log2;
	a[0] = soft_load_texels(format, texels, above + left);
	a[1] = soft_load_texels(format, texels, above + right);
	b[0] = soft_load_texels(format, texels, below + left);
	b[1] = soft_load_texels(format, texels, below + right);
	soft_mix_green(kind, a, b, s, t, out);
}

/* Filters red and blue of RGBA8888, when the fragment has passed. */
static ALWAYS_INLINE void soft_finish_texel(
	struct soft_kind kind, struct soft_texel *texel)
{
	if (kind.format == TEXEL_8888 && kind.linear) {
		texel->lanes.red_blue =
			soft_mix_half(&texel->four, false, kind.wide);
	}
}

#endif
