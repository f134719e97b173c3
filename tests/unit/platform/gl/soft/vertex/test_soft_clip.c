/* Where pictures end: depth between triangles, clipping, viewports, reading. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <string.h>

#define ONE FX16_ONE

/* Planes z = a + b x + c y over the picture, the lower z in front. */
struct plane_case {
	const char *name;
	double red[3], green[3];
};

static const struct plane_case planes[] = {
	{"crossing at a column", {0, 0.8, 0}, {0, -0.8, 0}},
	{"crossing at a row", {0, 0, 0.7}, {0.1, 0, -0.2}},
	{"crossing aslant", {0.2, 0.3, -0.4}, {-0.1, -0.5, 0.2}},
	{"one before the other", {-0.01, 0.5, 0.4}, {0.01, 0.5, 0.4}},
	{"one behind the other", {0.01, 0.5, 0.4}, {-0.01, 0.5, 0.4}},
	{"flatly crossing", {0, 0.01, 0}, {0, -0.01, 0.002}},
};

static double plane_at(const double plane[3], double x, double y)
{
	return plane[0] + plane[1] * x + plane[2] * y;
}

static void draw_plane(struct gl *gl, const double plane[3])
{
	float corner[4][3];

	for (int i = 0; i < 4; i++) {
		corner[i][0] = i % 2 ? 1 : -1;
		corner[i][1] = i / 2 ? 1 : -1;
		corner[i][2] =
			(float)plane_at(plane, corner[i][0], corner[i][1]);
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, corner);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

static void test_the_nearer_of_crossing_triangles_is_seen(void **state)
{
	(void)state;
	for (size_t i = 0; i < 4 * sizeof(planes) / sizeof(planes[0]); i++) {
		const struct plane_case *c = &planes[i / 4];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		const double *colors[2] = {
			(double[]){1, 0, 0, 1}, (double[]){0, 1, 0, 1}};
		const double *drawn[2] = {c->red, c->green};
		int first = i / 2 % 2;

		canvas.gl->Enable(GL_DEPTH_TEST);
		for (int n = 0; n < 2; n++) {
			gl_set_color(canvas.gl, colors[first ^ n]);
			draw_plane(canvas.gl, drawn[first ^ n]);
		}
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			int column = p % GL_CANVAS_WIDTH,
			    row = p / GL_CANVAS_WIDTH;
			double x = (column + 0.5) * 2 / GL_CANVAS_WIDTH - 1;
			double y = 1 - (row + 0.5) * 2 / GL_CANVAS_HEIGHT;
			double gap = plane_at(c->red, x, y) -
				plane_at(c->green, x, y);

			if (fabs(gap) > 1e-4) { /* 3 steps of 16 bits */
				gl_expect_color(&canvas, c->name, column, row,
					colors[gap > 0]);
			}
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* Triangles that leave the volume; off pixels may differ along edges. */
static const struct clip_case {
	const char *name;
	float corner[3][3];
	bool frustum;
	int off;
} clips[] = {
	{"left", {{-3, -0.7f, 0}, {0.6f, -0.8f, 0}, {0.3f, 0.9f, 0}}, false, 6},
	{"right", {{3, -0.7f, 0}, {-0.6f, -0.8f, 0}, {0.3f, 0.9f, 0}}, false, 6},
	{"bottom", {{0, -4, 0}, {-0.8f, 0.6f, 0}, {0.7f, 0.5f, 0}}, false, 6},
	{"top", {{0, 4, 0}, {-0.8f, -0.6f, 0}, {0.7f, -0.5f, 0}}, false, 6},
	{"near", {{-0.8f, -0.9f, -3}, {0.9f, -0.7f, 0.5f}, {0, 0.8f, 0.5f}},
		false, 6},
	{"far", {{-0.8f, -0.9f, 3}, {0.9f, -0.7f, -0.5f}, {0, 0.8f, -0.5f}},
		false, 6},
	{"two corners near",
		{{-0.8f, -0.9f, 0}, {0.9f, -0.7f, -2}, {0, 0.8f, -2}}, false, 6},
	{"two corners far", {{-0.8f, -0.9f, 0}, {0.9f, -0.7f, 2}, {0, 0.8f, 3}},
		false, 6},
	{"all sides", {{-9, -8, 0}, {9, -7, 0}, {0.5f, 12, 0}}, false, 0},
	{"a corner of the volume",
		{{0.2f, 0.3f, 0}, {5, 0.5f, 0}, {0.4f, 7, 0}}, false, 6},
	{"near and far", {{-0.9f, -0.7f, -4}, {0.9f, -0.8f, 4}, {0.1f, 0.9f, 0}},
		false, 6},
	{"outside to the left", {{-3, 0, 0}, {-2, 1, 0}, {-1.1f, -1, 0}}, false,
		0},
	{"outside behind", {{-1, 0, 1.5f}, {0, 1, 2}, {1, -1, 3}}, false, 0},
	{"around a corner, outside", {{-3, 0.5f, 0}, {-0.5f, 3, 0}, {-3, 3, 0}},
		false, 0},
	{"behind the eye", {{-1, -1, 2}, {1, -1, -4}, {0, 1, -4}}, true, 6},
	{"two corners behind the eye",
		{{-1, -0.5f, 3}, {1, -0.5f, 3}, {0, -0.4f, -6}}, true, 6},
	{"a floor from behind to far",
		{{-20, -1, 30}, {20, -1, 30}, {0, -1, -300}}, true, 8},
	{"all behind the eye", {{-1, -1, 2}, {1, -1, 4}, {0, 1, 4}}, true, 0},
};

static void draw_clipped(struct gl *gl, const void *context)
{
	static const GLubyte colors[3][4] = {
		{255, 40, 40, 255}, {40, 255, 40, 190}, {40, 40, 255, 120}};
	const struct clip_case *c = context;

	gl->MatrixMode(GL_PROJECTION);
	if (c->frustum) {
		gl->Frustumx(-ONE, ONE, -ONE, ONE, ONE, 50 * ONE);
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, c->corner);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
}

/* Colours too: what is cut keeps running as it did. */
static void test_each_plane_cuts_as_osmesas_does(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(clips) / sizeof(clips[0]); i++) {
		int count = gl_count_differences(draw_clipped, &clips[i], 0, 8);

		if (count > clips[i].off) {
			fail_msg("%s: %d pixels differ", clips[i].name, count);
		}
	}
}

/* Draws in the colours themselves, or with each side lit to the full. */
static struct gl_canvas open_blended(
	const struct clip_case *c, enum pixel_format format, bool lit)
{
	struct gl_canvas canvas = gl_canvas_open("soft", format);
	struct gl *gl = canvas.gl;

	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ZERO);
	if (lit) {
		static const GLfixed white[] = {ONE, ONE, ONE, ONE};
		static const GLfixed from_behind[] = {0, 0, -ONE, 0};

		gl_canvas_set_up_light(gl);
		gl->Lightxv(GL_LIGHT1, GL_DIFFUSE, white);
		gl->Lightxv(GL_LIGHT1, GL_POSITION, from_behind);
		gl->Enable(GL_LIGHT1);
		gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
		gl->Enable(GL_COLOR_MATERIAL);
		gl->Normal3x(0, 0, -ONE);
		gl->FrontFace(GL_CW);
	}
	draw_clipped(gl, c);
	return canvas;
}

static void test_cuts_keep_the_colours_of_both_sides(void **state)
{
	static uint8_t plain[GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT][4];

	(void)state;
	for (size_t i = 0; i < sizeof(clips) / sizeof(clips[0]); i++) {
		const struct clip_case *c = &clips[i];
		enum pixel_format format = gl_expect_formats[i % 2];
		struct gl_canvas canvas = open_blended(c, format, false);

		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			gl_expect_read(&canvas, p % GL_CANVAS_WIDTH,
				p / GL_CANVAS_WIDTH, plain[p]);
		}
		gl_canvas_end_and_close(&canvas);
		canvas = open_blended(c, format, true);
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			gl_expect_color(&canvas, c->name, p % GL_CANVAS_WIDTH,
				p / GL_CANVAS_WIDTH,
				(double[]){plain[p][0] / 255.0,
					plain[p][1] / 255.0,
					plain[p][2] / 255.0});
		}
		gl_canvas_end_and_close(&canvas);
	}
}

static int count_white(const struct gl_canvas *canvas)
{
	int white = 0;

	for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
		uint8_t rgba[4];

		gl_expect_read(
			canvas, p % GL_CANVAS_WIDTH, p / GL_CANVAS_WIDTH, rgba);
		white += rgba[0] == 255;
	}
	return white;
}

/* A corner whose w is 0 is within all planes, and yet at no place. */
static void test_corners_without_w_are_at_no_place(void **state)
{
	/* clip coordinates are x, y, 0 and z */
	static const GLfixed w_is_z[16] = {[0] = ONE, [5] = ONE, [11] = ONE};
	static const float seen[2][3] = {{0.5f, 0.25f, 1}, {-0.5f, 0.25f, 1}};
	static const GLenum modes[] = {GL_LINES, GL_TRIANGLES};

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		int corners = 2 + i / 3;
		float corner[3][3] = {{0}};

		for (int k = 0; k < corners - 1; k++) {
			memcpy(corner[(i + k) % corners], seen[k],
				sizeof(corner[0]));
		}
		gl->MatrixMode(GL_PROJECTION);
		gl->LoadMatrixx(w_is_z);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(3, GL_FLOAT, 0, corner);
		gl->DrawArrays(modes[i / 3], 0, corners);
		assert_int_equal(count_white(&canvas), 0);
		for (int k = 0; k < corners; k++) {
			corner[k][2] = 1;
		}
		gl->DrawArrays(modes[i / 3], 0, corners);
		assert_true(count_white(&canvas) > 2);
		gl_canvas_end_and_close(&canvas);
	}
}

/* A square of half its size in viewports of any place. */
static void test_viewports_place_the_picture(void **state)
{
	static const struct {
		const char *name;
		int x, y, width, height;
	} cases[] = {{"all", 0, 0, 32, 24}, {"a part", 8, 4, 16, 8},
		{"two pixels", 5, 5, 4, 4}, {"beyond the right", 16, 0, 32, 24},
		{"beyond the left", -16, -8, 32, 24},
		{"larger", -32, -24, 96, 72},
		{"much larger", -800, -600, 1632, 1224},
		{"off the picture", 100, 100, 32, 24}, {"nothing", 4, 4, 0, 0}};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		size_t n = i / 2;
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);

		canvas.gl->Viewport(cases[n].x, cases[n].y, cases[n].width,
			cases[n].height);
		gl_canvas_draw_rectangle(canvas.gl, -0.5f, -0.5f, 0.5f, 0.5f, 0);
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			int column = p % GL_CANVAS_WIDTH,
			    row = p / GL_CANVAS_WIDTH;
			double x = (column + 0.5 - cases[n].x) * 2;
			double y =
				(GL_CANVAS_HEIGHT - row - 0.5 - cases[n].y) * 2;
			double on = x > cases[n].width * 0.5 &&
				x < cases[n].width * 1.5 &&
				y > cases[n].height * 0.5 &&
				y < cases[n].height * 1.5;

			gl_expect_color(&canvas, cases[n].name, column, row,
				(double[]){on, on, on});
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* What is drawn beyond a viewport is cut there, not at the picture's end. */
static void test_viewports_cut_triangles(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i]);

		canvas.gl->Viewport(8, 6, 16, 12);
		gl_canvas_draw_rectangle(canvas.gl, -1.5f, -7, 9, 1.25f, 0);
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			int x = p % GL_CANVAS_WIDTH, y = p / GL_CANVAS_WIDTH;
			double on = x >= 8 && x < 24 && y >= 6 && y < 18;

			gl_expect_color(
				&canvas, "cut", x, y, (double[]){on, on, on});
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* Rows of four numbers, from below, each beginning at the alignment. */
static void test_pixels_are_read_as_they_were_drawn(void **state)
{
	static const int alignments[] = {1, 2, 4, 8};

	(void)state;
	for (int i = 0; i < 8; i++) {
		int align = alignments[i / 2],
		    row = (3 * 4 + align - 1) / align * align;
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		uint8_t pixels[64], gap = 0xEE;

		memset(pixels, gap, sizeof(pixels));
		gl_set_color(gl, (double[]){1, 0, 0, 1});
		gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
		gl_set_color(gl, (double[]){0, 1, 1, 1});
		gl_canvas_draw_rectangle(gl, -1, -1, 1, 0, 0);
		gl->PixelStorei(GL_PACK_ALIGNMENT, align);
		gl->ReadPixels(15, 11, 3, 2, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
		for (int x = 0; x < 3; x++) {
			assert_memory_equal(pixels + 4 * x,
				((uint8_t[]){0, 255, 255, 255}), 4);
			assert_memory_equal(pixels + row + 4 * x,
				((uint8_t[]){x ? 0 : 255, 0, 0, 255}), 4);
		}
		for (int n = 12; n < row; n++) {
			assert_int_equal(pixels[n], gap);
		}
		assert_int_equal(pixels[row + 12], gap);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Outside of the picture nothing is defined, and nothing breaks. */
static void test_reading_may_leave_the_picture(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	uint8_t pixels[4 * 4][4];

	(void)state;
	gl_clear_to(canvas.gl, (double[]){1, 1, 1, 1});
	canvas.gl->ReadPixels(-2, -2, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	assert_int_equal(pixels[15][0], 255);
	canvas.gl->ReadPixels(GL_CANVAS_WIDTH - 1, GL_CANVAS_HEIGHT - 1, 4, 4,
		GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	assert_int_equal(pixels[0][0], 255);
	canvas.gl->ReadPixels(
		INT32_MAX, INT32_MAX, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	canvas.gl->ReadPixels(
		INT32_MIN, INT32_MIN, 4, 4, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
	gl_canvas_end_and_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_nearer_of_crossing_triangles_is_seen),
		cmocka_unit_test(test_each_plane_cuts_as_osmesas_does),
		cmocka_unit_test(test_cuts_keep_the_colours_of_both_sides),
		cmocka_unit_test(test_corners_without_w_are_at_no_place),
		cmocka_unit_test(test_viewports_place_the_picture),
		cmocka_unit_test(test_viewports_cut_triangles),
		cmocka_unit_test(test_pixels_are_read_as_they_were_drawn),
		cmocka_unit_test(test_reading_may_leave_the_picture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
