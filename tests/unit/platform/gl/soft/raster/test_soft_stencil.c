/* Each stencil function and action, and fog, against the formulas. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>

#define ONE FX16_ONE

static const double black[] = {0, 0, 0, 1};
static const double red[] = {1, 0, 0, 1};
static const double green[] = {0, 1, 0, 1};

static struct gl_canvas open_cleared(int format, int stencil)
{
	struct gl_canvas canvas =
		gl_canvas_open("soft", gl_expect_formats[format]);

	canvas.gl->Enable(GL_STENCIL_TEST);
	canvas.gl->ClearStencil(stencil);
	canvas.gl->Clear(GL_STENCIL_BUFFER_BIT);
	gl_clear_to(canvas.gl, red);
	gl_set_color(canvas.gl, green);
	return canvas;
}

static void test_each_stencil_function_compares(void **state)
{
	static const struct {
		const char *name;
		GLenum function;
		int reference;
		unsigned mask;
		int stored;
		bool passes;
	} cases[] = {
		{"never", GL_NEVER, 3, 255, 3, false},
		{"less: 2 < 3", GL_LESS, 2, 255, 3, true},
		{"less: 3 < 3", GL_LESS, 3, 255, 3, false},
		{"less: 4 < 3", GL_LESS, 4, 255, 3, false},
		{"less: 127 < 128", GL_LESS, 127, 255, 128, true},
		{"equal: 3 = 3", GL_EQUAL, 3, 255, 3, true},
		{"equal: 2 = 3", GL_EQUAL, 2, 255, 3, false},
		{"equal: under a mask", GL_EQUAL, 0xF3, 0x0F, 0x53, true},
		{"lequal: 3 <= 3", GL_LEQUAL, 3, 255, 3, true},
		{"lequal: 4 <= 3", GL_LEQUAL, 4, 255, 3, false},
		{"greater: 4 > 3", GL_GREATER, 4, 255, 3, true},
		{"greater: 3 > 3", GL_GREATER, 3, 255, 3, false},
		{"notequal: 4, 3", GL_NOTEQUAL, 4, 255, 3, true},
		{"notequal: 3, 3", GL_NOTEQUAL, 3, 255, 3, false},
		{"gequal: 3 >= 3", GL_GEQUAL, 3, 255, 3, true},
		{"gequal: 2 >= 3", GL_GEQUAL, 2, 255, 3, false},
		{"always", GL_ALWAYS, 0, 255, 3, true},
		{"a mask of nothing", GL_NOTEQUAL, 9, 0, 3, false},
		{"a large reference is 255", GL_EQUAL, 999, 255, 255, true},
		{"a negative reference is 0", GL_EQUAL, -5, 255, 0, true},
	};

	(void)state;
	for (size_t i = 0; i < 4 * sizeof(cases) / sizeof(cases[0]); i++) {
		size_t n = i / 4;
		struct gl_canvas canvas =
			open_cleared((int)i & 1, cases[n].stored);

		(i & 2 ? canvas.gl->Enable : canvas.gl->Disable)(GL_DEPTH_TEST);
		canvas.gl->StencilFunc(
			cases[n].function, cases[n].reference, cases[n].mask);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color(&canvas, cases[n].name, 9, 9,
			cases[n].passes ? green : red);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Draws with the action in one of its three places; what is stored then. */
static void test_each_stencil_action_acts(void **state)
{
	static const struct {
		const char *name;
		GLenum action;
		int stored;
		unsigned write_mask;
		int after;
	} cases[] = {
		{"keep", GL_KEEP, 7, 255, 7},
		{"zero", GL_ZERO, 7, 255, 0},
		{"zero under a mask", GL_ZERO, 0xFF, 0x0F, 0xF0},
		{"replace", GL_REPLACE, 7, 255, 0x5A},
		{"replace under a mask", GL_REPLACE, 0x00, 0xF0, 0x50},
		{"incr", GL_INCR, 7, 255, 8},
		{"incr ends at 255", GL_INCR, 255, 255, 255},
		{"incr under a mask", GL_INCR, 0x1F, 0xF0, 0x2F},
		{"decr", GL_DECR, 7, 255, 6},
		{"decr ends at 0", GL_DECR, 0, 255, 0},
		{"invert", GL_INVERT, 0x35, 255, 0xCA},
		{"invert under a mask", GL_INVERT, 0x35, 0x0F, 0x3A},
		{"nothing may be written", GL_INCR, 7, 0, 7},
	};
	enum {
		FAIL,
		DEPTH_FAIL,
		PASS,
		PASS_UNTESTED,
		WAYS
	};

	(void)state;
	for (size_t i = 0; i < 2 * WAYS * sizeof(cases) / sizeof(cases[0]); i++) {
		size_t n = i / (2 * WAYS);
		int way = (int)i / 2 % WAYS;
		GLenum op = cases[n].action, keep = GL_KEEP;
		struct gl_canvas canvas =
			open_cleared((int)i % 2, cases[n].stored);
		struct gl *gl = canvas.gl;

		gl->StencilMask(cases[n].write_mask);
		gl->StencilFunc(way == FAIL ? GL_NEVER : GL_ALWAYS, 0x5A, 0xFF);
		gl->StencilOp(way == FAIL ? op : keep,
			way == DEPTH_FAIL ? op : keep, way >= PASS ? op : keep);
		gl->DepthFunc(way == DEPTH_FAIL ? GL_NEVER : GL_LESS);
		(way == PASS_UNTESTED ? gl->Disable : gl->Enable)(GL_DEPTH_TEST);
		gl_canvas_draw_all(gl);
		gl->Disable(GL_DEPTH_TEST);
		gl->StencilOp(keep, keep, keep);
		gl_clear_to(gl, red);
		gl->StencilFunc(GL_EQUAL, cases[n].after, 0xFF);
		gl_canvas_draw_all(gl);
		gl_expect_color(&canvas, cases[n].name, 9, 9, green);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_clearing_the_stencil_heeds_its_mask(void **state)
{
	struct gl_canvas canvas = open_cleared(0, 0x35);

	(void)state;
	canvas.gl->StencilMask(0x0F);
	canvas.gl->ClearStencil(0xCA);
	canvas.gl->Clear(GL_STENCIL_BUFFER_BIT);
	canvas.gl->StencilFunc(GL_EQUAL, 0x3A, 0xFF);
	gl_canvas_draw_all(canvas.gl);
	gl_expect_color(&canvas, "both halves", 9, 9, green);
	gl_canvas_end_and_close(&canvas);
}

/* A volume's two sides, as shadows are made: counted up, then down. */
static void test_sides_of_a_volume_count_up_and_down(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas = open_cleared(i, 0);
		struct gl *gl = canvas.gl;

		gl->Enable(GL_DEPTH_TEST);
		gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
		gl->DepthMask(GL_FALSE);
		gl->ColorMask(0, 0, 0, 0);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, -0.5f);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_DECR);
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, 0.5f);
		gl->ColorMask(1, 1, 1, 1);
		gl->Disable(GL_DEPTH_TEST);
		gl->StencilFunc(GL_NOTEQUAL, 0, 0xFF);
		gl_set_color(gl, black);
		gl_canvas_draw_all(gl);
		gl_expect_color(&canvas, "in the volume", 4, 9, black);
		gl_expect_color(&canvas, "through it", 28, 9, red);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Stripes, and over them a triangle whose alpha is 0 to 255. */
static void draw_over_stripes(
	struct gl *gl, bool stencil, int blending, bool alpha_test, int mask)
{
	static const GLenum factors[][2] = {{GL_ONE, GL_ZERO},
		{GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA}, {GL_ONE, GL_ONE},
		{GL_DST_COLOR, GL_ZERO}, {GL_ZERO, GL_SRC_COLOR},
		{GL_ONE_MINUS_DST_COLOR, GL_ONE}};
	static const float corner[3][2] = {{-1, -1}, {1, -0.9f}, {-0.2f, 1}};
	static const uint8_t color[3][4] = {
		{255, 40, 0, 0}, {0, 255, 90, 255}, {160, 0, 255, 130}};

	for (int i = 0; i < 8; i++) {
		const double stripe[] = {
			0.12 * i, 1 - 0.1 * i, i % 2, 0.5 + 0.06 * i};

		gl_set_color(gl, stripe);
		gl_canvas_draw_rectangle(gl, -1 + 0.25f * (float)i, -1,
			-0.75f + 0.25f * (float)i, 1, 0);
	}
	(stencil ? gl->Enable : gl->Disable)(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, 0, 0xFF);
	gl->StencilOp(GL_INCR, GL_INCR, GL_INCR);
	(blending ? gl->Enable : gl->Disable)(GL_BLEND);
	gl->BlendFunc(factors[blending][0], factors[blending][1]);
	(alpha_test ? gl->Enable : gl->Disable)(GL_ALPHA_TEST);
	gl->AlphaFuncx(GL_GREATER, ONE / 3);
	gl->ColorMask(mask & 1, mask & 2, mask & 4, 1);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, corner);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
	gl->DisableClientState(GL_COLOR_ARRAY);
}

static void test_a_stencil_that_passes_changes_no_colour(void **state)
{
	(void)state;
	for (int i = 0; i < 2 * 6 * 2 * 2; i++) {
		int blending = i / 2 % 6;
		bool alpha_test = i / 12 % 2;
		int mask = i / 24 ? 5 : 7;
		uint8_t rgba[2][GL_CANVAS_HEIGHT][GL_CANVAS_WIDTH][4];

		for (int stencil = 0; stencil < 2; stencil++) {
			struct gl_canvas canvas = gl_canvas_open(
				"soft", gl_expect_formats[i % 2]);

			draw_over_stripes(
				canvas.gl, stencil, blending, alpha_test, mask);
			for (int at = 0;
				at < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; at++) {
				int x = at % GL_CANVAS_WIDTH;
				int y = at / GL_CANVAS_WIDTH;

				gl_expect_read(
					&canvas, x, y, rgba[stencil][y][x]);
			}
			gl_canvas_end_and_close(&canvas);
		}
		for (size_t at = 0; at < sizeof(rgba[0]); at++) {
			/* A step of RGB565, of which blending may be one off. */
			assert_near(((uint8_t *)rgba[1])[at],
				((uint8_t *)rgba[0])[at], i % 2 ? 9 : 2);
		}
	}
}

struct fog_case {
	const char *name;
	GLenum mode;
	double density, start, end, distance;
};

static const struct fog_case fogs[] = {
	{"linear before its start", GL_LINEAR, 0, 2, 6, 1},
	{"linear, a quarter", GL_LINEAR, 0, 2, 6, 3},
	{"linear, near its end", GL_LINEAR, 0, 2, 6, 5.5},
	{"linear after its end", GL_LINEAR, 0, 2, 6, 8},
	{"linear, far away", GL_LINEAR, 0, 10, 3000, 9},
	{"linear, the other way", GL_LINEAR, 0, 6, 2, 3},
	{"linear, a thin layer", GL_LINEAR, 0, 2, 2.0625, 2.046875},
	{"linear, nothing between", GL_LINEAR, 0, 2, 2, 3},
	{"exp at once", GL_EXP, 0.25, 0, 0, 0.01},
	{"exp", GL_EXP, 0.25, 0, 0, 3},
	{"exp, thin", GL_EXP, 0.01, 0, 0, 7},
	{"exp, thick", GL_EXP, 3, 0, 0, 9},
	{"exp of nothing", GL_EXP, 0, 0, 0, 9},
	{"exp2 at once", GL_EXP2, 0.25, 0, 0, 0.01},
	{"exp2", GL_EXP2, 0.25, 0, 0, 3},
	{"exp2, thin", GL_EXP2, 0.05, 0, 0, 9},
	{"exp2, thick", GL_EXP2, 3, 0, 0, 9},
};

/* How much of the fragment's own colour is left: section 3.8. */
static double left_by(const struct fog_case *c)
{
	double thick = c->density * c->distance;
	double range = c->end == c->start ? 1e-9 : c->end - c->start;
	double left = c->mode == GL_LINEAR
		? (c->end - c->distance) / range
		: exp(c->mode == GL_EXP ? -thick : -thick * thick);

	return left < 0 ? 0 : left > 1 ? 1 : left;
}

static void test_each_fog_is_the_formulas(void **state)
{
	static const double own[] = {1, 0.2, 0.6, 0.5};
	static const double mist[] = {0.2, 0.8, 0.4, 1};
	GLfixed color[4];

	(void)state;
	gl_fixed_all(mist, 4, color);
	for (size_t i = 0; i < 2 * sizeof(fogs) / sizeof(fogs[0]); i++) {
		const struct fog_case *c = &fogs[i / 2];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		double wanted[4] = {0, 0, 0, own[3]};

		gl->MatrixMode(GL_PROJECTION);
		gl->Orthox(-ONE, ONE, -ONE, ONE, 0, 10 * ONE);
		gl->Fogx(GL_FOG_MODE, (GLfixed)c->mode);
		gl->Fogx(GL_FOG_DENSITY, gl_fixed(c->density));
		gl->Fogx(GL_FOG_START, gl_fixed(c->start));
		gl->Fogx(GL_FOG_END, gl_fixed(c->end));
		gl->Fogxv(GL_FOG_COLOR, color);
		gl->Enable(GL_FOG);
		gl_set_color(gl, own);
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, (float)-c->distance);
		for (int j = 0; j < 3; j++) {
			wanted[j] = left_by(c) * own[j] +
				(1 - left_by(c)) * mist[j];
		}
		gl_expect_color_alpha(&canvas, c->name, 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_stencil_function_compares),
		cmocka_unit_test(test_each_stencil_action_acts),
		cmocka_unit_test(test_clearing_the_stencil_heeds_its_mask),
		cmocka_unit_test(test_sides_of_a_volume_count_up_and_down),
		cmocka_unit_test(test_a_stencil_that_passes_changes_no_colour),
		cmocka_unit_test(test_each_fog_is_the_formulas),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
