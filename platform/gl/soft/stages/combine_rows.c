#define SOFT_BY_FOUR

#include "platform/gl/soft/stages/combine_rows.h"

#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/soft/stages/bytes.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

static const uint32_t RGB = 0x00FFFFFF;

/* The sources that a stage's arguments may have. */
struct meeting {
	const uint32_t *texel, *primary, *previous;
	uint32_t constant;
};

bool soft_base_has_alpha(GLenum format)
{
	return format != GL_RGB && format != GL_LUMINANCE;
}

bool soft_is_simple_environment(const struct texture_input *input)
{
	return input->mode == GL_MODULATE || input->mode == GL_REPLACE;
}

static void set(
	struct soft_combiner *combiner, int i, GLenum source, GLenum operand)
{
	combiner->source[i] = source;
	combiner->operand[i] = operand;
}

/* Expresses a mode other than GL_COMBINE as GL_COMBINE's rgb function. */
static void find_rgb(GLenum mode, struct soft_combiner *rgb)
{
	rgb->function = mode == GL_REPLACE ? GL_REPLACE
		: mode == GL_ADD           ? GL_ADD
		: mode == GL_DECAL         ? GL_INTERPOLATE
		: mode == GL_BLEND         ? GL_INTERPOLATE
					   : GL_MODULATE;
	set(rgb, 0, mode == GL_BLEND ? GL_CONSTANT : GL_TEXTURE, GL_SRC_COLOR);
	set(rgb, 1, GL_PREVIOUS, GL_SRC_COLOR);
	set(rgb, 2, GL_TEXTURE, mode == GL_DECAL ? GL_SRC_ALPHA : GL_SRC_COLOR);
}

static void find_mode(GLenum mode, GLenum format, struct soft_environment *out)
{
	/* Texels without alpha have 255: GL_MODULATE's rgb and alpha are alike. */
	const bool kept = mode == GL_DECAL ||
		(mode != GL_MODULATE && !soft_base_has_alpha(format));

	if (format == GL_ALPHA) {
		out->rgb.function = GL_REPLACE;
		set(&out->rgb, 0, GL_PREVIOUS, GL_SRC_COLOR);
	} else {
		find_rgb(mode, &out->rgb);
	}
	out->alpha.function =
		kept || mode == GL_REPLACE ? GL_REPLACE : GL_MODULATE;
	set(&out->alpha, 0, kept ? GL_PREVIOUS : GL_TEXTURE, GL_SRC_ALPHA);
	set(&out->alpha, 1, GL_PREVIOUS, GL_SRC_ALPHA);
}

static void find_combine(const struct texenv *env, struct soft_environment *out)
{
	out->rgb.function = env->combine_rgb;
	out->rgb.doublings = env->scale_rgb >> 17;
	out->alpha.function = env->combine_alpha;
	out->alpha.doublings = env->scale_alpha >> 17;
	for (int i = 0; i < 3; i++) {
		set(&out->rgb, i, env->source_rgb[i], env->operand_rgb[i]);
		set(&out->alpha, i, env->source_alpha[i], env->operand_alpha[i]);
	}
}

static int count_arguments(GLenum function)
{
	return function == GL_REPLACE ? 1 : function == GL_INTERPOLATE ? 3 : 2;
}

/*
 * Whether the rgb function, on all four bytes, also gives the right alpha: if
 * it has the colours of those sources whose alphas the alpha function has.
 */
static bool are_alike(
	const struct soft_combiner *rgb, const struct soft_combiner *alpha)
{
	bool alike = rgb->function == alpha->function &&
		rgb->doublings == alpha->doublings;

	for (int i = 0; i < count_arguments(rgb->function); i++) {
		alike = alike && rgb->source[i] == alpha->source[i] &&
			rgb->operand[i] + GL_SRC_ALPHA - GL_SRC_COLOR ==
				alpha->operand[i];
	}
	return alike;
}

static bool is_argument(const struct soft_combiner *a, int i,
	const struct soft_combiner *b, int j, bool first)
{
	GLenum source = a->source[i];

	source = first && source == GL_PRIMARY_COLOR ? GL_PREVIOUS : source;
	return source == b->source[j] && a->operand[i] == b->operand[j];
}

/* Whether a combiner has the wanted effect; wanted is commutative or REPLACE. */
static bool does(const struct soft_combiner *combiner,
	const struct soft_combiner *wanted, bool first)
{
	bool one = wanted->function == GL_REPLACE;

	return combiner->function == wanted->function &&
		combiner->doublings == 0 &&
		((is_argument(combiner, 0, wanted, 0, first) &&
			 (one || is_argument(combiner, 1, wanted, 1, first))) ||
			(!one && is_argument(combiner, 0, wanted, 1, first) &&
				is_argument(combiner, 1, wanted, 0, first)));
}

GLenum soft_find_mode(const struct texenv *env, GLenum format, bool first)
{
	static const GLenum simple[] = {GL_MODULATE, GL_REPLACE};
	struct soft_environment given = {0}, wanted = {0};

	if (env->mode == GL_DECAL && !soft_base_has_alpha(format)) {
		return GL_REPLACE;
	}
	if (env->mode != GL_COMBINE) {
		return env->mode;
	}
	find_combine(env, &given);
	for (size_t i = 0; i < ARRAY_COUNT(simple); i++) {
		find_mode(simple[i], format, &wanted);
		if (does(&given.rgb, &wanted.rgb, first) &&
			does(&given.alpha, &wanted.alpha, first)) {
			return simple[i];
		}
	}
	return GL_COMBINE;
}

bool soft_adds(const struct texture_input *input, GLenum source)
{
	const struct soft_combiner sum = {
		GL_ADD, {GL_PREVIOUS, source}, {GL_SRC_COLOR, GL_SRC_COLOR}, 0};
	static const struct soft_combiner own = {
		GL_REPLACE, {GL_PREVIOUS}, {GL_SRC_ALPHA}, 0};
	struct soft_environment given;

	soft_find_environment(input, &given);
	return does(&given.rgb, &sum, false) && does(&given.alpha, &own, false);
}

void soft_find_environment(
	const struct texture_input *input, struct soft_environment *out)
{
	const struct texenv *env = input->env;

	memset(out, 0, sizeof(*out));
	for (int i = 0; i < 4; i++) {
		out->constant |= (uint32_t)soft_byte(env->color[i]) << 8 * i;
	}
	if (input->mode == GL_COMBINE) {
		find_combine(env, out);
	} else {
		find_mode(input->mode, input->base->base_format, out);
	}
	out->alpha_wanted = true;
	out->alike = are_alike(&out->rgb, &out->alpha);
	if (out->rgb.function == GL_DOT3_RGBA) {
		out->rgb.function = GL_DOT3_RGB;
		out->alike = true;
	}
}

/* An argument's row: the source's own one, or computed from that in out. */
static const uint32_t *find_argument(const struct meeting *m, GLenum source,
	GLenum operand, bool for_alpha, uint32_t *out, uint32_t count)
{
	const uint32_t *from = source == GL_TEXTURE ? m->texel
		: source == GL_PRIMARY_COLOR        ? m->primary
						    : m->previous;
	/* in operands GL_ONE_MINUS_ is 1, and alpha in place of colours is 2 */
	const uint32_t invert = operand & 1 ? UINT32_MAX : 0;
	const bool spread = operand & 2 && !for_alpha;
	const soft_word constant = (soft_word){0} + m->constant;

	if (source == GL_CONSTANT) {
		for (uint32_t i = 0; i < count; i += SOFT_LANES) {
			soft_put_words(out + i, constant);
		}
		from = out;
	}
	if (!spread && !invert) {
		return from;
	}
	for (uint32_t i = 0; i < count; i += SOFT_LANES) {
		soft_word argument = soft_get_words(from + i);

		if (spread) {
			argument = (argument >> 24) * 0x01010101;
		}
		soft_put_words(out + i, argument ^ invert);
	}
	return out;
}

/* GL_DOT3: 4 * sum of (a - 1/2)(b - 1/2), limited, in all four bytes. */
static ALWAYS_INLINE soft_word dot(soft_word a, soft_word b)
{
	const soft_word one = (soft_word){0} + 0x00010001;
	const soft_word a_rb = BYTES_AS_HALVES(a), b_rb = BYTES_AS_HALVES(b);
	const soft_word a_g = a >> 8 & 255, b_g = b >> 8 & 255;
	const soft_word products =
		HALVES_SUM_ADD(a_rb, b_rb, WORD_PRODUCT(a_g, b_g));
	const soft_word terms = HALVES_SUM_ADD(a_rb + b_rb, one, a_g + b_g);
	/* of (2 a - 255)(2 b - 255) */
	const soft_int sum =
		(soft_int)(products * 4 - terms * 510 + 3 * 255 * 255);

	/* sum / 255 rounded down, exact while that is below 256 */
	return LIMIT_SHIFTED(sum * 257 + 257, 16, 8) * 0x01010101;
}

/* (a * share + b * (255 - share)) / 255 of each byte, rounded. */
static ALWAYS_INLINE soft_word mix_bytes(
	soft_word a, soft_word b, soft_word share)
{
	const soft_word rest = ~share;
	soft_word a_rb = BYTES_AS_HALVES(a), a_ga = ODD_BYTES_AS_HALVES(a);
	soft_word b_rb = BYTES_AS_HALVES(b), b_ga = ODD_BYTES_AS_HALVES(b);
	soft_word s_rb = BYTES_AS_HALVES(share);
	soft_word s_ga = ODD_BYTES_AS_HALVES(share);
	soft_word r_rb = BYTES_AS_HALVES(rest), r_ga = ODD_BYTES_AS_HALVES(rest);

	return soft_divide_lanes(HALVES_MIX(a_rb, s_rb, b_rb, r_rb)) |
		soft_divide_lanes(HALVES_MIX(a_ga, s_ga, b_ga, r_ga)) << 8;
}

static ALWAYS_INLINE soft_word apply(
	GLenum function, soft_word x, soft_word y, soft_word z)
{
	const soft_word half = (soft_word){0} + 0x80808080;

	switch (function) {
	case GL_ADD:
		return BYTES_ADD_LIMITED(x, y);
	case GL_ADD_SIGNED:
		/* x + y - 128: what is more or less than 128 */
		return BYTES_LESS_LIMITED(
			BYTES_ADD_LIMITED(y, BYTES_LESS_LIMITED(x, half)),
			BYTES_LESS_LIMITED(half, x));
	case GL_SUBTRACT:
		return BYTES_LESS_LIMITED(x, y);
	case GL_INTERPOLATE:
		return mix_bytes(x, y, z);
	case GL_DOT3_RGB:
		return dot(x, y);
	default:
		return soft_multiply_bytes(x, y);
	}
}

/* Inlined with a constant function. */
static ALWAYS_INLINE void apply_all(GLenum function, const uint32_t *const a[3],
	uint32_t *out, uint32_t count)
{
	const uint32_t *x = a[0], *y = a[1], *const end = x + count;
	const uint32_t *z = function == GL_INTERPOLATE ? a[2] : y;

	for (; x < end; x += SOFT_LANES, y += SOFT_LANES, z += SOFT_LANES) {
		soft_put_words(out,
			apply(function, soft_get_words(x), soft_get_words(y),
				soft_get_words(z)));
		out += SOFT_LANES;
	}
}

static void run_function(GLenum function, const uint32_t *const a[3],
	uint32_t *out, uint32_t count)
{
	if (function == GL_REPLACE) {
		memmove(out, a[0], count * sizeof(*out));
	}
#define FUNCTION(name)                          \
	if (function == (name)) {               \
		apply_all(name, a, out, count); \
	}
	FUNCTION(GL_MODULATE)
	FUNCTION(GL_ADD)
	FUNCTION(GL_ADD_SIGNED)
	FUNCTION(GL_SUBTRACT)
	FUNCTION(GL_INTERPOLATE)
	FUNCTION(GL_DOT3_RGB)
#undef FUNCTION
}

static void run_combiner(const struct soft_combiner *combiner,
	const struct meeting *m, bool for_alpha, uint32_t *out, uint32_t count)
{
	uint32_t made[3][SOFT_RUN_PIXELS];
	const uint32_t *argument[3] = {NULL};

	for (int i = 0; i < count_arguments(combiner->function); i++) {
		argument[i] = find_argument(m, combiner->source[i],
			combiner->operand[i], for_alpha, made[i], count);
	}
	run_function(combiner->function, argument, out, count);
	for (int n = 0; n < combiner->doublings; n++) {
		for (uint32_t i = 0; i < count; i += SOFT_LANES) {
			const soft_word color = soft_get_words(out + i);

			soft_put_words(out + i, BYTES_ADD_LIMITED(color, color));
		}
	}
}

/* Combines up to SOFT_RUN_PIXELS fragments. */
static void combine(const struct soft_environment *environment,
	const struct meeting *m, uint32_t *color, uint32_t count)
{
	uint32_t rgb[SOFT_RUN_PIXELS];

	if (environment->alike || !environment->alpha_wanted) {
		run_combiner(&environment->rgb, m, false, color, count);
		return;
	}
	run_combiner(&environment->rgb, m, false, rgb, count);
	run_combiner(&environment->alpha, m, true, color, count);
	for (uint32_t i = 0; i < count; i += SOFT_LANES) {
		soft_put_words(color + i,
			(soft_get_words(rgb + i) & RGB) |
				(soft_get_words(color + i) & ~RGB));
	}
}

void soft_combine_row(const struct soft_environment *environment,
	const uint32_t *texel, const uint32_t *primary,
	const uint32_t *previous, uint32_t *color, uint32_t count)
{
	for (uint32_t i = 0; i < count; i += SOFT_RUN_PIXELS) {
		const struct meeting m = {texel + i, primary + i, previous + i,
			environment->constant};
		const uint32_t left = count - i;

		combine(environment, &m, color + i,
			left < SOFT_RUN_PIXELS ? left : SOFT_RUN_PIXELS);
	}
}
