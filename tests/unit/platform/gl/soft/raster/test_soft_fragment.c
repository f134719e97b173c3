/* Tests of fragments and triangles, a table each, by GL ES 1.1 chapter 4. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <stdio.h>

#define ONE FX16_ONE

static const double black[] = {0, 0, 0, 1};
static const double red[] = {1, 0, 0, 1};
static const double green[] = {0, 1, 0, 1};

/* GL_NEVER and those after it: less, equal, greater. */
static const struct comparison {
	GLenum function;
	const char *name;
	bool less, equal, greater;
} comparisons[] = {
	{GL_NEVER, "NEVER", false, false, false},
	{GL_LESS, "LESS", true, false, false},
	{GL_EQUAL, "EQUAL", false, true, false},
	{GL_LEQUAL, "LEQUAL", true, true, false},
	{GL_GREATER, "GREATER", false, false, true},
	{GL_NOTEQUAL, "NOTEQUAL", true, false, true},
	{GL_GEQUAL, "GEQUAL", false, true, true},
	{GL_ALWAYS, "ALWAYS", true, true, true},
};

enum {
	COMPARISONS = sizeof(comparisons) / sizeof(comparisons[0]),
	/* Columns of a picture: less, equal, greater. */
	LESS_X = 4,
	EQUAL_X = 15,
	GREATER_X = 27,
};

static void draw_third(struct gl *gl, int third, float z)
{
	float left = (float)third * 0.7f - 1.0f;

	gl_canvas_draw_rectangle(gl, left, -1, left + 0.6f, 1, z);
}

static void expect_thirds(
	const struct gl_canvas *canvas, const struct comparison *c)
{
	gl_expect_color(canvas, c->name, LESS_X, 9, c->less ? green : red);
	gl_expect_color(canvas, c->name, EQUAL_X, 9, c->equal ? green : red);
	gl_expect_color(canvas, c->name, GREATER_X, 9, c->greater ? green : red);
}

static struct gl_canvas open_red(int format)
{
	struct gl_canvas canvas =
		gl_canvas_open("soft", gl_expect_formats[format]);

	gl_clear_to(canvas.gl, red);
	gl_set_color(canvas.gl, green);
	return canvas;
}

static void test_each_alpha_function_compares(void **state)
{
	(void)state;
	for (int i = 0; i < 2 * COMPARISONS; i++) {
		const struct comparison *c = &comparisons[i / 2];
		struct gl_canvas canvas = open_red(i % 2);

		canvas.gl->Enable(GL_ALPHA_TEST);
		canvas.gl->AlphaFuncx(c->function, ONE / 5 * 2 + 1);
		for (int third = 0; third < 3; third++) {
			canvas.gl->Color4x(0, ONE, 0, ONE / 5 * (third + 1) + 1);
			draw_third(canvas.gl, third, 0);
		}
		expect_thirds(&canvas, c);
		gl_canvas_end_and_close(&canvas);
	}
}

/* What alpha refuses leaves the depth alone. */
static void test_alpha_is_tested_before_depth_is_written(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas = open_red(i);

		canvas.gl->Enable(GL_ALPHA_TEST);
		canvas.gl->Enable(GL_DEPTH_TEST);
		canvas.gl->AlphaFuncx(GL_GREATER, ONE / 2);
		canvas.gl->Color4x(0, 0, ONE, ONE / 4);
		gl_canvas_draw_rectangle(canvas.gl, -1, -1, 1, 1, -0.5f);
		gl_set_color(canvas.gl, green);
		gl_canvas_draw_rectangle(canvas.gl, -1, -1, 1, 1, 0.5f);
		gl_expect_color(&canvas, "behind", 9, 9, green);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_each_depth_function_compares(void **state)
{
	(void)state;
	for (int i = 0; i < 2 * COMPARISONS; i++) {
		const struct comparison *c = &comparisons[i / 2];
		struct gl_canvas canvas = open_red(i % 2);

		canvas.gl->Enable(GL_DEPTH_TEST);
		gl_set_color(canvas.gl, red);
		gl_canvas_draw_all(canvas.gl);
		gl_set_color(canvas.gl, green);
		canvas.gl->DepthFunc(c->function);
		for (int third = 0; third < 3; third++) {
			draw_third(canvas.gl, third, (float)(third - 1) / 2);
		}
		expect_thirds(&canvas, c);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_the_depth_mask_keeps_depth(void **state)
{
	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl_canvas canvas = open_red(i / 2);
		struct gl *gl = canvas.gl;

		gl->Enable(GL_DEPTH_TEST);
		gl->DepthMask(i % 2 ? GL_TRUE : GL_FALSE);
		gl_set_color(gl, red);
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, -0.5f);
		gl_set_color(gl, green);
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, 0.5f);
		gl_expect_color(&canvas, "masked", 9, 9, i % 2 ? red : green);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Without the test, GL writes no depth. */
static void test_depth_is_written_by_the_test_alone(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas = open_red(i);

		gl_set_color(canvas.gl, red);
		gl_canvas_draw_rectangle(canvas.gl, -1, -1, 1, 1, -0.9f);
		canvas.gl->Enable(GL_DEPTH_TEST);
		gl_set_color(canvas.gl, green);
		gl_canvas_draw_rectangle(canvas.gl, -1, -1, 1, 1, 0.5f);
		gl_expect_color(&canvas, "untested", 9, 9, green);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Cleared depths of 0..1; something in the middle is nearer or not. */
static void test_depth_clears_to_a_value(void **state)
{
	static const struct {
		const char *name;
		GLfixed clear;
		bool drawn;
	} cases[] = {{"0", 0, false}, {"0.4", 26214, false},
		{"0.6", 39322, true}, {"1", ONE, true},
		{"below 0", -ONE, false}, {"above 1", 2 * ONE, true}};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas = open_red((int)i % 2);

		canvas.gl->ClearDepthx(cases[i / 2].clear);
		canvas.gl->Clear(GL_DEPTH_BUFFER_BIT);
		canvas.gl->Enable(GL_DEPTH_TEST);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color(&canvas, cases[i / 2].name, 9, 9,
			cases[i / 2].drawn ? green : red);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_scissors_cut_drawing_and_clearing(void **state)
{
	static const struct {
		const char *name;
		int box[4];
	} cases[] = {{"inner", {5, 3, 10, 7}}, {"one pixel", {31, 23, 1, 1}},
		{"nothing", {5, 5, 0, 9}}, {"all", {0, 0, 32, 24}},
		{"beyond", {-7, -9, 20, 15}}, {"huge", {-1000, 4, 5000, 3}},
		{"far off", {40, 40, 9, 9}}, {"to the left", {-9, 2, 5, 5}},
		{"largest", {1, 1, INT32_MAX, INT32_MAX}}};

	(void)state;
	for (size_t i = 0; i < 4 * sizeof(cases) / sizeof(cases[0]); i++) {
		const int *box = cases[i / 4].box;
		struct gl_canvas canvas = open_red((int)i % 2);

		canvas.gl->Enable(GL_SCISSOR_TEST);
		canvas.gl->Scissor(box[0], box[1], box[2], box[3]);
		if (i & 2) {
			gl_clear_to(canvas.gl, green);
		} else {
			gl_canvas_draw_all(canvas.gl);
		}
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			int x = p % GL_CANVAS_WIDTH;
			int y = GL_CANVAS_HEIGHT - 1 - p / GL_CANVAS_WIDTH;
			bool in = x >= box[0] && x - box[0] < box[2] &&
				y >= box[1] && y - box[1] < box[3];

			gl_expect_color(&canvas, cases[i / 4].name, x,
				p / GL_CANVAS_WIDTH, in ? green : red);
		}
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_culling_goes_by_face_and_winding(void **state)
{
	static const struct {
		const char *name;
		GLenum face, front;
		bool ccw, cw; /* whether such a triangle is drawn */
	} cases[] = {
		{"back, ccw", GL_BACK, GL_CCW, true, false},
		{"back, cw", GL_BACK, GL_CW, false, true},
		{"front, ccw", GL_FRONT, GL_CCW, false, true},
		{"front, cw", GL_FRONT, GL_CW, true, false},
		{"both, ccw", GL_FRONT_AND_BACK, GL_CCW, false, false},
		{"both, cw", GL_FRONT_AND_BACK, GL_CW, false, false},
		{"none", 0, GL_CCW, true, true},
	};
	static const float triangles[] = {
		-1, -1, 0, -1, -0.5f, 1, 0, -1, 0.5f, 1, 1, -1};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas = open_red((int)i % 2);
		struct gl *gl = canvas.gl;

		if (cases[i / 2].face) {
			gl->Enable(GL_CULL_FACE);
			gl->CullFace(cases[i / 2].face);
		}
		gl->FrontFace(cases[i / 2].front);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(2, GL_FLOAT, 0, triangles);
		gl->DrawArrays(GL_TRIANGLES, 0, 6);
		gl_expect_color(&canvas, cases[i / 2].name, 8, 16,
			cases[i / 2].ccw ? green : red);
		gl_expect_color(&canvas, cases[i / 2].name, 24, 16,
			cases[i / 2].cw ? green : red);
		gl_canvas_end_and_close(&canvas);
	}
}

/*
 * A slope of 0.5 in z / 16 columns, which is 1/64 of depth a column; the
 * second is the same but for the offset, and seen where it is nearer.
 */
static void test_polygon_offset_moves_depth(void **state)
{
	static const struct {
		const char *name;
		double factor, units;
		bool on, nearer;
	} cases[] = {
		{"off", -1, -9, false, false},
		{"none", 0, 0, true, false},
		{"units nearer", 0, -2, true, true},
		{"units farther", 0, 2, true, false},
		{"factor nearer", -1, 0, true, true},
		{"factor farther", 1, 0, true, false},
		{"factor wins", -1, 100, true, true},
		{"units win", 0.01, -200, true, true},
		/* beyond either end of depths, where nothing wraps around */
		{"units much nearer", 0, -32767, true, true},
		{"units much farther", 0, 32767, true, false},
		{"factor much nearer", -32767, 0, true, true},
		{"factor much farther", 32767, 0, true, false},
	};
	static const float sloped[] = {
		-1, -1, -0.5f, 1, -1, 0.5f, -1, 1, -0.5f, 1, 1, 0.5f};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		struct gl_canvas canvas = open_red((int)i % 2);
		struct gl *gl = canvas.gl;

		gl->Enable(GL_DEPTH_TEST);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(3, GL_FLOAT, 0, sloped);
		gl_set_color(gl, red);
		gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
		gl_set_color(gl, green);
		(cases[i / 2].on ? gl->Enable : gl->Disable)(
			GL_POLYGON_OFFSET_FILL);
		gl->PolygonOffsetx(gl_fixed(cases[i / 2].factor),
			gl_fixed(cases[i / 2].units));
		gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			gl_expect_color(&canvas, cases[i / 2].name, x, 11,
				cases[i / 2].nearer ? green : red);
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/*
 * An offset as large as the distance of two planes, whose depths rise by 1024
 * units a pixel, but for a little. The second plane is green.
 */
static void test_polygon_offset_has_its_size(void **state)
{
	static const struct {
		const char *name;
		double behind, factor,
			units; /* behind: the red plane, in units */
		bool nearer;
	} cases[] = {
		{"units too few", 3000, 0, -2990, false},
		{"units enough", 3000, 0, -3010, true},
		{"units back too few", -3000, 0, 2990, true},
		{"units back enough", -3000, 0, 3010, false},
		{"factor too small", 10240, -9.97, 0, false},
		{"factor enough", 10240, -10.03, 0, true},
		{"factor back too small", -10240, 9.97, 0, true},
		{"factor back enough", -10240, 10.03, 0, false},
		{"both", 0, -10, 10210, true},
		{"both, back", 0, -10, 10270, false},
	};

	(void)state;
	for (size_t i = 0; i < 4 * sizeof(cases) / sizeof(cases[0]); i++) {
		const bool down = i % 4 >= 2;
		struct gl_canvas canvas = open_red((int)i % 2);
		struct gl *gl = canvas.gl;
		const float rise = down ? 0.75f : 1.0f; /* in all */

		gl->Enable(GL_DEPTH_TEST);
		for (int n = 0; n < 2; n++) {
			float moved =
				n ? (float)(cases[i / 4].behind * 2 / 65535) : 0;
			float corner[4][3];

			for (int c = 0; c < 4; c++) {
				int rises = down ? c / 2 : c % 2;

				corner[c][0] = c % 2 ? 1 : -1;
				corner[c][1] = c / 2 ? 1 : -1;
				corner[c][2] =
					(rises ? rise : -rise) / 2 + moved;
			}
			gl->EnableClientState(GL_VERTEX_ARRAY);
			gl->VertexPointer(3, GL_FLOAT, 0, corner);
			gl_set_color(gl, n ? green : red);
			gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
			gl->Enable(GL_POLYGON_OFFSET_FILL);
			gl->PolygonOffsetx(gl_fixed(cases[i / 4].factor),
				gl_fixed(cases[i / 4].units));
		}
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			gl_expect_color(&canvas, cases[i / 4].name, x, 11,
				cases[i / 4].nearer ? green : red);
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* Flat triangles have the last vertex's colour, of strips and fans too. */
static void test_flat_shading_takes_the_last_vertex(void **state)
{
	static const float square[] = {-1, -1, 1, -1, 1, 1, -1, 1};
	static const GLubyte colors[4][4] = {{255, 255, 255, 255},
		{0, 0, 255, 255}, {255, 0, 0, 255}, {0, 255, 0, 255}};
	static const GLubyte strip[] = {1, 0, 2, 3};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl_canvas canvas = open_red(i % 2);
		struct gl *gl = canvas.gl;

		gl_clear_to(gl, black);
		gl->ShadeModel(GL_FLAT);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->EnableClientState(GL_COLOR_ARRAY);
		gl->VertexPointer(2, GL_FLOAT, 0, square);
		gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
		if (i / 2) {
			gl->DrawArrays(GL_TRIANGLE_FAN, 0, 4);
		} else {
			gl->DrawElements(
				GL_TRIANGLE_STRIP, 4, GL_UNSIGNED_BYTE, strip);
		}
		gl_expect_color(&canvas, "first", 30, 20, red);
		gl_expect_color(&canvas, "second", 1, 3, green);
		gl_canvas_end_and_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_alpha_function_compares),
		cmocka_unit_test(test_alpha_is_tested_before_depth_is_written),
		cmocka_unit_test(test_each_depth_function_compares),
		cmocka_unit_test(test_the_depth_mask_keeps_depth),
		cmocka_unit_test(test_depth_is_written_by_the_test_alone),
		cmocka_unit_test(test_depth_clears_to_a_value),
		cmocka_unit_test(test_scissors_cut_drawing_and_clearing),
		cmocka_unit_test(test_culling_goes_by_face_and_winding),
		cmocka_unit_test(test_polygon_offset_moves_depth),
		cmocka_unit_test(test_polygon_offset_has_its_size),
		cmocka_unit_test(test_flat_shading_takes_the_last_vertex),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
