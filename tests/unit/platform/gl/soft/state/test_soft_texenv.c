/* The texture environment and perspective, against formulas in double. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/stages/combine_rows.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <string.h>

#define ONE FX16_ONE

enum {
	/* Of ES 1.1, of no call that limber makes by name. */
	SUBTRACT = 0x84E7,
	ADD_SIGNED = 0x8574,
	INTERPOLATE = 0x8575,
	SRC2_RGB = 0x8582,
	OPERAND2_RGB = 0x8592,
	ALPHA_SCALE = 0x0D1C,
};

/* The fragment's colour, the texel's and the environment's. */
static const double own[] = {0.8, 0.4, 0.6, 0.6};
static const double texel[] = {0.4, 1, 0.2, 0.8};
static const double constant[] = {0.2, 0.6, 1, 0.4};

static void bind_texel(struct gl *gl, GLenum format, const double rgba[4])
{
	uint8_t bytes[4];
	GLuint name;

	for (int i = 0; i < 4; i++) {
		bytes[i] = (uint8_t)lrint(255 * rgba[i]);
	}
	if (format == GL_ALPHA) {
		bytes[0] = bytes[3];
	} else if (format == GL_LUMINANCE_ALPHA) {
		bytes[1] = bytes[3];
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, (GLint)format, 1, 1, 0, format,
		GL_UNSIGNED_BYTE, bytes);
	gl->Enable(GL_TEXTURE_2D);
}

static void set_env(struct gl *gl, GLenum name, GLenum value)
{
	gl->TexEnvx(GL_TEXTURE_ENV, name, (GLfixed)value);
}

/* GL ES 1.1 tables 3.15 to 3.17. */
static void find_mode(GLenum mode, GLenum format, double out[4])
{
	double t[4];
	bool has_color = format != GL_ALPHA;
	bool has_alpha = format != GL_RGB && format != GL_LUMINANCE;

	for (int i = 0; i < 4; i++) {
		bool gray =
			format == GL_LUMINANCE || format == GL_LUMINANCE_ALPHA;

		t[i] = texel[i < 3 && gray ? 0 : i];
	}
	memcpy(out, own, sizeof(own));
	for (int i = 0; i < 3 && has_color; i++) {
		switch (mode) {
		case GL_REPLACE:
			out[i] = t[i];
			break;
		case GL_MODULATE:
			out[i] = own[i] * t[i];
			break;
		case GL_DECAL:
			out[i] = format == GL_RGB
				? t[i]
				: own[i] * (1 - t[3]) + t[i] * t[3];
			break;
		case GL_BLEND:
			out[i] = own[i] * (1 - t[i]) + constant[i] * t[i];
			break;
		default:
			out[i] = own[i] + t[i];
			break;
		}
	}
	if (has_alpha && mode != GL_DECAL) {
		out[3] = mode == GL_REPLACE ? t[3] : own[3] * t[3];
	}
}

static void test_each_mode_is_the_formulas(void **state)
{
	static const GLenum format[] = {
		GL_RGB, GL_RGBA, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA};
	static const struct {
		const char *name;
		GLenum mode;
	} modes[] = {{"MODULATE", GL_MODULATE}, {"REPLACE", GL_REPLACE},
		{"DECAL", GL_DECAL}, {"BLEND", GL_BLEND}, {"ADD", GL_ADD}};
	GLfixed color[4];

	(void)state;
	gl_fixed_all(constant, 4, color);
	for (int i = 0; i < 2 * 5 * 5; i++) {
		GLenum mode = modes[i / 10].mode;
		GLenum f = format[i / 2 % 5];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		double wanted[4];

		if (mode == GL_DECAL && f != GL_RGB && f != GL_RGBA) {
			gl_canvas_close(&canvas); /* GL does not define it */
			continue;
		}
		bind_texel(canvas.gl, f, texel);
		set_env(canvas.gl, GL_TEXTURE_ENV_MODE, mode);
		canvas.gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
		gl_set_color(canvas.gl, own);
		gl_canvas_draw_all(canvas.gl);
		find_mode(mode, f, wanted);
		gl_expect_color_alpha(&canvas, modes[i / 10].name, 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

struct combiner_case {
	const char *name;
	GLenum combine, source[3], operand[3];
	int scale;
};

#define COLORS                                           \
	{                                                \
		GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA \
	}
#define TPC                                          \
	{                                            \
		GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT \
	}

static const struct combiner_case combiners[] = {
	{"replace by texture", GL_REPLACE, TPC, COLORS, 1},
	{"replace by constant", GL_REPLACE,
		{GL_CONSTANT, GL_TEXTURE, GL_TEXTURE}, COLORS, 1},
	{"replace by primary", GL_REPLACE,
		{GL_PRIMARY_COLOR, GL_TEXTURE, GL_TEXTURE}, COLORS, 1},
	{"replace by what is missing", GL_REPLACE, TPC,
		{GL_ONE_MINUS_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA}, 1},
	{"replace by alpha", GL_REPLACE, TPC,
		{GL_SRC_ALPHA, GL_SRC_COLOR, GL_SRC_ALPHA}, 1},
	{"replace by missing alpha", GL_REPLACE, TPC,
		{GL_ONE_MINUS_SRC_ALPHA, GL_SRC_COLOR, GL_SRC_ALPHA}, 1},
	{"modulate", GL_MODULATE, TPC, COLORS, 1},
	{"modulate, scaled by 2", GL_MODULATE, TPC, COLORS, 2},
	{"modulate, scaled by 4", GL_MODULATE, TPC, COLORS, 4},
	{"add", GL_ADD, {GL_CONSTANT, GL_PREVIOUS, GL_TEXTURE}, COLORS, 1},
	{"add signed", ADD_SIGNED, TPC, COLORS, 1},
	{"add signed, scaled by 2", ADD_SIGNED, TPC, COLORS, 2},
	{"subtract", SUBTRACT, {GL_PREVIOUS, GL_TEXTURE, GL_TEXTURE}, COLORS, 1},
	{"interpolate", INTERPOLATE, TPC, COLORS, 1},
	{"interpolate by colour", INTERPOLATE, TPC,
		{GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_COLOR}, 1},
	{"dot3 of texture and primary", GL_DOT3_RGB,
		{GL_TEXTURE, GL_PRIMARY_COLOR, GL_CONSTANT}, COLORS, 1},
	{"dot3 of texture and constant", GL_DOT3_RGB,
		{GL_TEXTURE, GL_CONSTANT, GL_CONSTANT}, COLORS, 1},
	{"dot3 of one colour", GL_DOT3_RGB,
		{GL_PRIMARY_COLOR, GL_PRIMARY_COLOR, GL_CONSTANT}, COLORS, 1},
	{"dot3, scaled by 2", GL_DOT3_RGB,
		{GL_PRIMARY_COLOR, GL_PRIMARY_COLOR, GL_CONSTANT}, COLORS, 2},
	{"dot3 into alpha too", GL_DOT3_RGBA,
		{GL_PRIMARY_COLOR, GL_PRIMARY_COLOR, GL_CONSTANT}, COLORS, 1},
};

static double argument(const struct combiner_case *c, int n, int i)
{
	const double *from = c->source[n] == GL_TEXTURE ? texel
		: c->source[n] == GL_CONSTANT           ? constant
							: own;
	bool alpha = c->operand[n] == GL_SRC_ALPHA ||
		c->operand[n] == GL_ONE_MINUS_SRC_ALPHA;
	bool missing = c->operand[n] == GL_ONE_MINUS_SRC_COLOR ||
		c->operand[n] == GL_ONE_MINUS_SRC_ALPHA;
	double value = from[alpha ? 3 : i];

	return missing ? 1 - value : value;
}

/* GL ES 1.1 table 3.19. */
static double combine(const struct combiner_case *c, int i)
{
	double a = argument(c, 0, i), b = argument(c, 1, i);
	double dot = 0;

	switch (c->combine) {
	case GL_REPLACE:
		return a;
	case GL_MODULATE:
		return a * b;
	case GL_ADD:
		return a + b;
	case ADD_SIGNED:
		return a + b - 0.5;
	case SUBTRACT:
		return a - b;
	case INTERPOLATE:
		return a * argument(c, 2, i) + b * (1 - argument(c, 2, i));
	default:
		for (int j = 0; j < 3; j++) {
			dot += 4 * (argument(c, 0, j) - 0.5) *
				(argument(c, 1, j) - 0.5);
		}
		return dot;
	}
}

static void tell_combiner(struct gl *gl, const struct combiner_case *c)
{
	GLfixed color[4];

	gl_fixed_all(constant, 4, color);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
	set_env(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	set_env(gl, GL_COMBINE_RGB, c->combine);
	for (GLenum n = 0; n < 3; n++) {
		set_env(gl, GL_SRC0_RGB + n, c->source[n]);
		set_env(gl, GL_OPERAND0_RGB + n, c->operand[n]);
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE, c->scale * ONE);
}

static void test_each_combiner_is_the_formulas(void **state)
{
	(void)state;
	for (size_t i = 0; i < 2 * sizeof(combiners) / sizeof(combiners[0]);
		i++) {
		const struct combiner_case *c = &combiners[i / 2];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		double wanted[4];

		bind_texel(canvas.gl, GL_RGBA, texel);
		tell_combiner(canvas.gl, c);
		gl_set_color(canvas.gl, own);
		gl_canvas_draw_all(canvas.gl);
		for (int j = 0; j < 3; j++) {
			wanted[j] = c->scale * combine(c, j);
		}
		wanted[3] = c->combine == GL_DOT3_RGBA ? wanted[0]
						       : texel[3] * own[3];
		gl_expect_color_alpha(&canvas, c->name, 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_alpha_is_combined_apart(void **state)
{
	static const struct {
		const char *name;
		GLenum combine;
		int scale;
		double alpha;
	} cases[] = {{"replace", GL_REPLACE, 1, 0.8},
		{"modulate", GL_MODULATE, 1, 0.48},
		{"modulate, by 2", GL_MODULATE, 2, 0.96}, {"add", GL_ADD, 1, 1},
		{"add signed", ADD_SIGNED, 1, 0.9},
		{"subtract", SUBTRACT, 1, 0.2}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);

		bind_texel(canvas.gl, GL_RGBA, texel);
		set_env(canvas.gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
		set_env(canvas.gl, GL_COMBINE_RGB, GL_REPLACE);
		set_env(canvas.gl, GL_COMBINE_ALPHA, cases[i].combine);
		canvas.gl->TexEnvx(
			GL_TEXTURE_ENV, ALPHA_SCALE, cases[i].scale * ONE);
		gl_set_color(canvas.gl, own);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color_alpha(&canvas, cases[i].name, 9, 9,
			(double[]){texel[0], texel[1], texel[2], cases[i].alpha});
		gl_canvas_end_and_close(&canvas);
	}
}

/* Relief as limber draws it: the dot product, then a second unit's colour. */
static void test_a_second_unit_takes_the_first_ones_colour(void **state)
{
	(void)state;
	for (int n = 0; n < 2; n++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[n]);
		struct gl *gl = canvas.gl;
		double wanted[4], dot = 0;

		bind_texel(gl, GL_RGBA, texel);
		set_env(gl, GL_TEXTURE_ENV_MODE, GL_COMBINE);
		set_env(gl, GL_COMBINE_RGB, GL_DOT3_RGB);
		set_env(gl, GL_SRC1_RGB, GL_PRIMARY_COLOR);
		gl->ActiveTexture(GL_TEXTURE1);
		bind_texel(gl, GL_RGB, constant);
		set_env(gl, GL_TEXTURE_ENV_MODE, GL_MODULATE);
		gl_set_color(gl, (double[]){0.2, 1, 0.4, 1});
		gl_canvas_draw_all(gl);
		for (int i = 0; i < 3; i++) {
			dot += 4 * (texel[i] - 0.5) *
				((double[]){0.2, 1, 0.4}[i] - 0.5);
		}
		for (int i = 0; i < 3; i++) {
			wanted[i] = (dot > 1 ? 1 : dot) * constant[i];
		}
		gl_expect_color(&canvas, "two units", 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

/* A floor from near to far: s and t at each pixel by its ray in double. */
static double floor_depth(int y)
{
	double ndc_y = 1 - (y + 0.5) * 2 / GL_CANVAS_HEIGHT;

	return -1 / ndc_y; /* of the plane y = -1 before a frustum of 90 deg */
}

static void draw_floor(struct gl *gl)
{
	static const float corner[4][3] = {
		{-9, -1, -1}, {9, -1, -1}, {-9, -1, -9}, {9, -1, -9}};
	static const float st[4][2] = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-ONE / 2, ONE / 2, -ONE / 2, ONE / 2, ONE / 2, 20 * ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, corner);
	gl->TexCoordPointer(2, GL_FLOAT, 0, st);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

static double ramp_at(double share)
{
	double at = share * 64 - 0.5;

	return (at < 0 ? 0 : at > 63 ? 63 : at) * 4 / 255;
}

/* 64 x 64 texels: red along s, green along t, 4 a texel. */
static void bind_ramps(struct gl *gl)
{
	static uint8_t texels[64][64][3];
	GLuint name;

	for (int i = 0; i < 64 * 64; i++) {
		texels[i / 64][i % 64][0] = (uint8_t)(i % 64 * 4);
		texels[i / 64][i % 64][1] = (uint8_t)(i / 64 * 4);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 64, 64, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
	gl->Enable(GL_TEXTURE_2D);
}

static void test_texels_lie_in_perspective(void **state)
{
	(void)state;
	for (int n = 0; n < 2; n++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[n]);

		bind_ramps(canvas.gl);
		draw_floor(canvas.gl);
		for (int y = GL_CANVAS_HEIGHT / 2 + 2; y < GL_CANVAS_HEIGHT;
			y++) {
			for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
				double d = floor_depth(y);
				double ndc_x =
					(x + 0.5) * 2 / GL_CANVAS_WIDTH - 1;
				double s = (ndc_x * d + 9) / 18, t = (d - 1) / 8;

				gl_expect_color(&canvas, "floor", x, y,
					(double[]){ramp_at(s), ramp_at(t), 0});
			}
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* What a new context has, but for the mode. */
static const struct texenv default_combine = {
	.mode = GL_COMBINE,
	.combine_rgb = GL_MODULATE,
	.combine_alpha = GL_MODULATE,
	.source_rgb = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
	.source_alpha = {GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT},
	.operand_rgb = {GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA},
	.operand_alpha = {GL_SRC_ALPHA, GL_SRC_ALPHA, GL_SRC_ALPHA},
	.scale_rgb = ONE,
	.scale_alpha = ONE,
};

static void expect_mode(
	const struct texenv *env, GLenum format, bool first, GLenum wanted)
{
	assert_int_equal(soft_find_mode(env, format, first), wanted);
}

/* A state takes as long however a program asks for it. */
static void test_combiners_that_a_mode_has_are_that_mode(void **state)
{
	struct texenv env = default_combine;

	(void)state;
	expect_mode(&env, GL_RGBA, false, GL_MODULATE);
	expect_mode(&env, GL_RGB, false, GL_MODULATE);
	expect_mode(&env, GL_ALPHA, false, GL_COMBINE);
	env.source_rgb[0] = GL_PREVIOUS;
	env.source_rgb[1] = GL_TEXTURE;
	expect_mode(&env, GL_LUMINANCE, false, GL_MODULATE);
	env.source_rgb[0] = GL_PRIMARY_COLOR;
	expect_mode(&env, GL_RGB, true, GL_MODULATE);
	expect_mode(&env, GL_RGB, false, GL_COMBINE);
	env = default_combine;
	env.scale_rgb = 2 * ONE;
	expect_mode(&env, GL_RGB, true, GL_COMBINE);
	env = default_combine;
	env.operand_rgb[1] = GL_ONE_MINUS_SRC_COLOR;
	expect_mode(&env, GL_RGB, true, GL_COMBINE);
	env = default_combine;
	env.combine_rgb = env.combine_alpha = GL_REPLACE;
	expect_mode(&env, GL_RGBA, true, GL_REPLACE);
	expect_mode(&env, GL_RGB, true, GL_COMBINE);
	env.source_alpha[0] = GL_PREVIOUS;
	expect_mode(&env, GL_RGB, true, GL_REPLACE);
	env.mode = GL_DECAL;
	expect_mode(&env, GL_RGB, true, GL_REPLACE);
	expect_mode(&env, GL_RGBA, true, GL_DECAL);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_mode_is_the_formulas),
		cmocka_unit_test(test_each_combiner_is_the_formulas),
		cmocka_unit_test(test_alpha_is_combined_apart),
		cmocka_unit_test(test_a_second_unit_takes_the_first_ones_colour),
		cmocka_unit_test(test_combiners_that_a_mode_has_are_that_mode),
		cmocka_unit_test(test_texels_lie_in_perspective),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
