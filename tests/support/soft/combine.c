/* The texture environment: GL ES 1.1 section 3.7.12. */
#include "platform/gl/soft/vertex/number.h"
#include "tests/support/soft/reference.h"

#include <string.h>

enum {
	ADD_SIGNED = 0x8574,
	INTERPOLATE = 0x8575,
	SUBTRACT = 0x84E7,
};

/* The colours that the environment of a fragment may combine. */
struct meeting {
	const uint8_t *texel, *primary;
	const uint8_t *previous;
	uint8_t constant[4];
};

static uint8_t to_byte(int value)
{
	return (uint8_t)clamp_int(value, 0, 255);
}

static int mix(int a, int b, int share)
{
	int sum = a * (255 - share) + b * share + 128;

	return (sum + (sum >> 8)) >> 8;
}

static bool has_color(GLenum format)
{
	return format != GL_ALPHA;
}

static bool has_alpha(GLenum format)
{
	return format != GL_RGB && format != GL_LUMINANCE;
}

static void apply_environment(const struct texenv *env, GLenum format,
	const uint8_t constant[4], const uint8_t t[4], uint8_t color[4])
{
	int alpha = color[3];

	for (int i = 0; i < 3 && has_color(format); i++) {
		int c = color[i];

		c = env->mode == GL_REPLACE     ? t[i]
			: env->mode == GL_DECAL ? mix(c, t[i], t[3])
			: env->mode == GL_BLEND ? mix(c, constant[i], t[i])
			: env->mode == GL_ADD   ? c + t[i]
						: scale_byte(c, t[i]);
		color[i] = to_byte(c);
	}
	if (has_alpha(format) && env->mode != GL_DECAL) {
		color[3] = (uint8_t)(env->mode == GL_REPLACE
				? t[3]
				: scale_byte(alpha, t[3]));
	}
}

static const uint8_t *find_source(const struct meeting *m, GLenum source)
{
	switch (source) {
	case GL_TEXTURE:
		return m->texel;
	case GL_CONSTANT:
		return m->constant;
	case GL_PRIMARY_COLOR:
		return m->primary;
	default:
		return m->previous;
	}
}

static int find_operand(
	const struct meeting *m, GLenum source, GLenum operand, int i)
{
	const uint8_t *color = find_source(m, source);

	switch (operand) {
	case GL_SRC_COLOR:
		return color[i];
	case GL_ONE_MINUS_SRC_COLOR:
		return 255 - color[i];
	case GL_SRC_ALPHA:
		return color[3];
	default:
		return 255 - color[3];
	}
}

static int run_combiner(GLenum function, const int a[3])
{
	switch (function) {
	case GL_REPLACE:
		return a[0];
	case GL_ADD:
		return a[0] + a[1];
	case ADD_SIGNED:
		return a[0] + a[1] - 128;
	case SUBTRACT:
		return a[0] - a[1];
	case INTERPOLATE:
		return mix(a[1], a[0], a[2]);
	default:
		return scale_byte(a[0], a[1]);
	}
}

static void gather(const struct texenv *env, const struct meeting *m, int i,
	int argument[3])
{
	for (int n = 0; n < 3; n++) {
		argument[n] = i < 3 ? find_operand(m, env->source_rgb[n],
					      env->operand_rgb[n], i)
				    : find_operand(m, env->source_alpha[n],
					      env->operand_alpha[n], 3);
	}
}

/* GL_DOT3_RGB: 4 times the sum of (a - 1/2)(b - 1/2), in 255ths. */
static int dot(const struct texenv *env, const struct meeting *m)
{
	int sum = 0;

	for (int i = 0; i < 3; i++) {
		int a[3];

		gather(env, m, i, a);
		sum += (2 * a[0] - 255) * (2 * a[1] - 255);
	}
	return sum / 255;
}

static void apply_combiner(
	const struct texenv *env, const struct meeting *m, uint8_t color[4])
{
	bool dotted = env->combine_rgb == GL_DOT3_RGB ||
		env->combine_rgb == GL_DOT3_RGBA;
	int value[4], a[3];

	for (int i = 0; i < 3; i++) {
		gather(env, m, i, a);
		value[i] = dotted ? dot(env, m)
				  : run_combiner(env->combine_rgb, a);
		value[i] = value[i] * (env->scale_rgb >> 16);
	}
	gather(env, m, 3, a);
	value[3] =
		run_combiner(env->combine_alpha, a) * (env->scale_alpha >> 16);
	if (env->combine_rgb == GL_DOT3_RGBA) {
		value[3] = value[0];
	}
	for (int i = 0; i < 4; i++) {
		color[i] = to_byte(value[i]);
	}
}

void reference_combine(const struct texture_input *input, int count,
	const uint8_t (*texel)[4], const uint8_t (*primary)[4],
	uint8_t (*color)[4])
{
	const struct texenv *env = input->env;
	struct meeting m;

	for (int i = 0; i < 4; i++) {
		m.constant[i] = (uint8_t)soft_byte(env->color[i]);
	}
	for (int i = 0; i < count; i++) {
		uint8_t previous[4];

		memcpy(previous, color[i], 4);
		m.texel = texel[i];
		m.primary = primary[i];
		m.previous = previous;
		if (env->mode == GL_COMBINE) {
			apply_combiner(env, &m, color[i]);
		} else {
			apply_environment(env, input->base->base_format,
				m.constant, texel[i], color[i]);
		}
	}
}
