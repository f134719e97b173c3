/* Every pair of blend factors, against GL ES 1.1 section 4.1.7 in double. */
#include "tests/support/gl/gl_expect.h"

#include <stdio.h>

enum {
	SRC_ALPHA_SATURATE = 0x0308, /* of ES 1.1, of no call of limber's */
};

struct factor {
	GLenum value;
	const char *name;
};

static const struct factor sources[] = {
	{GL_ZERO, "ZERO"},
	{GL_ONE, "ONE"},
	{GL_DST_COLOR, "DST_COLOR"},
	{GL_ONE_MINUS_DST_COLOR, "ONE_MINUS_DST_COLOR"},
	{GL_SRC_ALPHA, "SRC_ALPHA"},
	{GL_ONE_MINUS_SRC_ALPHA, "ONE_MINUS_SRC_ALPHA"},
	{GL_DST_ALPHA, "DST_ALPHA"},
	{GL_ONE_MINUS_DST_ALPHA, "ONE_MINUS_DST_ALPHA"},
	{SRC_ALPHA_SATURATE, "SRC_ALPHA_SATURATE"},
};

static const struct factor destinations[] = {
	{GL_ZERO, "ZERO"},
	{GL_ONE, "ONE"},
	{GL_SRC_COLOR, "SRC_COLOR"},
	{GL_ONE_MINUS_SRC_COLOR, "ONE_MINUS_SRC_COLOR"},
	{GL_SRC_ALPHA, "SRC_ALPHA"},
	{GL_ONE_MINUS_SRC_ALPHA, "ONE_MINUS_SRC_ALPHA"},
	{GL_DST_ALPHA, "DST_ALPHA"},
	{GL_ONE_MINUS_DST_ALPHA, "ONE_MINUS_DST_ALPHA"},
};

/* What is drawn, over what; as 255ths, so that 8 bits hold them. */
static const double pairs[][2][4] = {
	{{0.8, 0.4, 0.2, 0.6}, {0.2, 0.6, 1, 0.4}},
	{{1, 0.2, 0, 1}, {0.4, 0.8, 0.2, 0.2}},
	{{0.6, 1, 0.4, 0}, {1, 0.2, 0.6, 1}},
	{{0, 0, 0, 0.8}, {0.6, 0.6, 0.6, 0}},
	{{1, 1, 1, 0.2}, {1, 1, 1, 0.8}},
};

enum {
	PAIRS = sizeof(pairs) / sizeof(pairs[0]),
	SOURCES = sizeof(sources) / sizeof(sources[0]),
	DESTINATIONS = sizeof(destinations) / sizeof(destinations[0]),
};

static double weigh(
	GLenum factor, const double source[4], const double target[4], int i)
{
	double rest = 1 - target[3];

	switch (factor) {
	case GL_ZERO:
		return 0;
	case GL_ONE:
		return 1;
	case GL_SRC_COLOR:
		return source[i];
	case GL_ONE_MINUS_SRC_COLOR:
		return 1 - source[i];
	case GL_DST_COLOR:
		return target[i];
	case GL_ONE_MINUS_DST_COLOR:
		return 1 - target[i];
	case GL_SRC_ALPHA:
		return source[3];
	case GL_ONE_MINUS_SRC_ALPHA:
		return 1 - source[3];
	case GL_DST_ALPHA:
		return target[3];
	case GL_ONE_MINUS_DST_ALPHA:
		return rest;
	default:
		return i == 3 ? 1 : source[3] < rest ? source[3] : rest;
	}
}

static void check_pair(const struct gl_canvas *canvas,
	const struct factor *source, const struct factor *destination,
	const double colors[2][4])
{
	double over[4], wanted[4];
	char name[64];

	for (int i = 0; i < 4; i++) {
		over[i] = colors[1][i];
	}
	if (canvas->pixels.format == PIXELS_RGB565) {
		over[3] = 1; /* there is no other */
	}
	for (int i = 0; i < 4; i++) {
		wanted[i] = colors[0][i] *
				weigh(source->value, colors[0], over, i) +
			over[i] * weigh(destination->value, colors[0], over, i);
	}
	gl_clear_to(canvas->gl, colors[1]);
	gl_set_color(canvas->gl, colors[0]);
	canvas->gl->BlendFunc(source->value, destination->value);
	gl_canvas_draw_all(canvas->gl);
	snprintf(name, sizeof(name), "%s, %s", source->name, destination->name);
	gl_expect_color_alpha(canvas, name, 13, 11, wanted);
}

static void check_pairs(enum pixel_format format)
{
	struct gl_canvas canvas = gl_canvas_open("soft", format);

	canvas.gl->Enable(GL_BLEND);
	for (int i = 0; i < SOURCES * DESTINATIONS * PAIRS; i++) {
		check_pair(&canvas, &sources[i / PAIRS / DESTINATIONS],
			&destinations[i / PAIRS % DESTINATIONS],
			pairs[i % PAIRS]);
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

static void test_every_pair_of_factors_is_the_formulas(void **state)
{
	(void)state;
	check_pairs(PIXELS_RGBA8888);
}

static void test_every_pair_of_factors_is_the_formulas_in_565(void **state)
{
	(void)state;
	check_pairs(PIXELS_RGB565);
}

/* Alpha runs from 0 to 1 across the picture. */
static void test_alpha_blends_between_vertices(void **state)
{
	static const float colors[4][4] = {
		{1, 0, 0, 0}, {1, 0, 0, 1}, {1, 0, 0, 0}, {1, 0, 0, 1}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i]);
		struct gl *gl = canvas.gl;

		gl_clear_to(gl, (double[]){0, 1, 0.5, 1});
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->ColorPointer(4, GL_FLOAT, 0, colors);
		gl_canvas_draw_all(gl);
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			double a = (x + 0.5) / GL_CANVAS_WIDTH;

			gl_expect_color(&canvas, "mixed", x, 7,
				(double[]){a, 1 - a, 0.5 * (1 - a)});
		}
		gl_canvas_end_frame(&canvas);
		gl_canvas_close(&canvas);
	}
}

static void test_without_blending_factors_do_nothing(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i]);

		gl_clear_to(canvas.gl, pairs[0][1]);
		gl_set_color(canvas.gl, pairs[0][0]);
		canvas.gl->BlendFunc(GL_ZERO, GL_SRC_ALPHA);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color_alpha(&canvas, "replaced", 4, 4, pairs[0][0]);
		gl_canvas_end_frame(&canvas);
		gl_canvas_close(&canvas);
	}
}

/* Each bit of a number is a channel that may be written. */
static void test_the_colour_mask_keeps_channels(void **state)
{
	(void)state;
	for (int bits = 0; bits < 32; bits++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[bits >> 4]);
		struct gl *gl = canvas.gl;
		double wanted[4];

		for (int i = 0; i < 4; i++) {
			wanted[i] = pairs[0][bits >> i & 1 ? 0 : 1][i];
		}
		gl_clear_to(gl, pairs[0][1]);
		gl->ColorMask(
			bits & 1, bits >> 1 & 1, bits >> 2 & 1, bits >> 3 & 1);
		gl_set_color(gl, pairs[0][0]);
		gl_canvas_draw_all(gl);
		gl_expect_color_alpha(&canvas, "drawn", 20, 20, wanted);
		gl_clear_to(gl, pairs[0][0]);
		gl_expect_color_alpha(&canvas, "cleared", 20, 20, wanted);
		gl_canvas_end_frame(&canvas);
		gl_canvas_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_pair_of_factors_is_the_formulas),
		cmocka_unit_test(
			test_every_pair_of_factors_is_the_formulas_in_565),
		cmocka_unit_test(test_alpha_blends_between_vertices),
		cmocka_unit_test(test_without_blending_factors_do_nothing),
		cmocka_unit_test(test_the_colour_mask_keeps_channels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
