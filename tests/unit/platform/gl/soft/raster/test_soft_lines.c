/* Points and lines: GL ES 1.1 sections 3.3 and 3.4. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"

#include <math.h>
#include <stdlib.h>

#define ONE FX16_ONE

enum {
	WIDTH = GL_CANVAS_WIDTH,
	HEIGHT = GL_CANVAS_HEIGHT,
	ROUNDS = 400,
};

/* A pixel is one unit; GL's y, upwards. */
static struct gl_canvas open_flat(enum pixel_format format)
{
	struct gl_canvas canvas = gl_canvas_open("soft", format);
	struct gl *gl = canvas.gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Orthox(0, WIDTH * ONE, 0, HEIGHT * ONE, -ONE, ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->Color4x(ONE, ONE, ONE, ONE);
	return canvas;
}

static int value_at(const struct gl_canvas *canvas, int x, int y_up)
{
	return canvas->pixels.data[4 * ((HEIGHT - 1 - y_up) * WIDTH + x)];
}

static int alpha_at(const struct gl_canvas *canvas, int x, int y_up)
{
	return canvas->pixels.data[4 * ((HEIGHT - 1 - y_up) * WIDTH + x) + 3];
}

static void draw(const struct gl_canvas *canvas, GLenum mode,
	const float *vertices, int count)
{
	struct gl *gl = canvas->gl;

	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->VertexPointer(2, GL_FLOAT, 0, vertices);
	gl->DrawArrays(mode, 0, count);
}

/* Columns of a line that is more across than down, rows of the others. */
static void count_across(
	const struct gl_canvas *canvas, bool flat, int count[WIDTH])
{
	for (int i = 0; i < WIDTH; i++) {
		count[i] = 0;
		for (int k = 0; k < (flat ? HEIGHT : WIDTH); k++) {
			if (flat || i < HEIGHT) {
				count[i] += value_at(canvas, flat ? i : k,
						    flat ? k : i) != 0;
			}
		}
	}
}

/* Far enough from the picture's edges for lines that are 5 wide. */
static float random_place(uint32_t *seed, int most)
{
	return (float)random_between(seed, 4 * 16, (most - 4) * 16) / 16.0f;
}

static void test_lines_are_as_wide_in_all_of_their_columns(void **state)
{
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	uint32_t seed = 3;

	(void)state;
	for (int round = 0; round < ROUNDS; round++) {
		float v[4];
		int count[WIDTH], width = random_between(&seed, 1, 5);

		for (int i = 0; i < 4; i++) {
			v[i] = random_place(&seed, i % 2 ? HEIGHT : WIDTH);
		}
		bool flat = fabsf(v[2] - v[0]) >= fabsf(v[3] - v[1]);
		float from = v[!flat], to = v[2 + !flat];

		canvas.gl->LineWidthx(width * ONE);
		draw(&canvas, GL_LINES, v, 2);
		count_across(&canvas, flat, count);
		for (int i = 0; i < WIDTH; i++) {
			float centre = (float)i + 0.5f;
			bool in = (centre >= from) != (centre >= to);

			/* At its ends on centres, it depends on the direction. */
			if (centre != from && centre != to) {
				assert_int_equal(count[i], in ? width : 0);
			}
		}
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* A strip along centres has each pixel once, and leaves the last one out. */
static void test_strips_share_no_pixel(void **state)
{
	static const float strip[] = {
		2.5f, 2.5f, 9.5f, 2.5f, 9.5f, 9.5f, 4.5f, 9.5f, 4.5f, 5.5f};
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	int seen = 0;

	(void)state;
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_ONE, GL_ONE);
	gl->Color4x(ONE / 4, 0, 0, ONE);
	draw(&canvas, GL_LINE_STRIP, strip, 5);
	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		int value = canvas.pixels.data[4 * i];

		assert_true(value == 0 || value == 64);
		seen += value != 0;
	}
	assert_int_equal(seen, 7 + 7 + 5 + 4);
	assert_int_equal(value_at(&canvas, 2, 2), 64);
	assert_int_equal(value_at(&canvas, 4, 5), 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* Odd sizes lie around the pixel, even ones around the nearest corner. */
static void test_points_are_squares_around_their_place(void **state)
{
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	uint32_t seed = 11;

	(void)state;
	for (int round = 0; round < ROUNDS; round++) {
		const float v[2] = {random_place(&seed, WIDTH),
			random_place(&seed, HEIGHT)};
		int size = random_between(&seed, 1, 6);
		float half = (float)(size - 1) / 2.0f;
		int left = (int)floorf(v[0] - half);
		int bottom = (int)floorf(v[1] - half);

		canvas.gl->PointSizex(size * ONE);
		draw(&canvas, GL_POINTS, v, 1);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			int x = i % WIDTH, y = i / WIDTH;
			bool in = x >= left && x < left + size && y >= bottom &&
				y < bottom + size;

			assert_int_equal(value_at(&canvas, x, y), in ? 255 : 0);
		}
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

static double sum_of(const struct gl_canvas *canvas)
{
	double sum = 0.0;

	for (int i = 0; i < WIDTH * HEIGHT; i++) {
		sum += canvas->pixels.data[4 * i] / 255.0;
	}
	return sum;
}

/* The shares of pixels are together as large as the shape. */
static void test_smooth_edges_cover_the_shape(void **state)
{
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	uint32_t seed = 7;

	(void)state;
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Enable(GL_LINE_SMOOTH);
	gl->Enable(GL_POINT_SMOOTH);
	for (int round = 0; round < ROUNDS; round++) {
		int size_q8 = random_between(&seed, 256, 5 * 256);
		double size = size_q8 / 256.0, length;
		float v[4];

		for (int i = 0; i < 4; i++) {
			v[i] = random_place(&seed, i % 2 ? HEIGHT : WIDTH);
		}
		length = hypot(v[2] - v[0], v[3] - v[1]);
		gl->LineWidthx(size_q8 * 256);
		gl->PointSizex(size_q8 * 256);
		draw(&canvas, GL_LINES, v, 2);
		assert_true(fabs(sum_of(&canvas) - length * size) <
			0.07 * length * size + 0.5);
		draw(&canvas, GL_POINTS, v, 1);
		assert_true(fabs(sum_of(&canvas) - 0.785398 * size * size) <
			0.1 * size * size + 0.3);
	}
	gl->Disable(GL_LINE_SMOOTH);
	assert_int_equal(gl->GetError(), GL_NO_ERROR);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* By how far the pixel's centre lies inside of the disk's edge. */
static void test_smooth_points_are_disks(void **state)
{
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	uint32_t seed = 5;

	(void)state;
	canvas.gl->ClearColorx(0, 0, 0, 0);
	canvas.gl->Enable(GL_POINT_SMOOTH);
	for (int round = 0; round < ROUNDS; round++) {
		const float v[2] = {
			(float)random_between(&seed, 1, 16 * WIDTH - 1) / 16,
			(float)random_between(&seed, 1, 16 * HEIGHT - 1) / 16};
		const int size_q4 = random_between(&seed, 16, 400);

		canvas.gl->PointSizex(size_q4 * ONE / 16);
		draw(&canvas, GL_POINTS, v, 1);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			const int x = i % WIDTH, y = i / WIDTH;
			const double inside = size_q4 / 32.0 + 0.5 -
				hypot(x + 0.5 - v[0], y + 0.5 - v[1]);
			const double share = fmin(fmax(inside, 0.0), 1.0);

			assert_true(fabs(alpha_at(&canvas, x, y) -
					    255.0 * share) <= 3.0);
		}
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* Colours that are divided by w leave the edges where they are. */
static void test_colors_do_not_change_smooth_edges(void **state)
{
	static const float v[2][3] = {{-0.9f, -0.7f, -1}, {16, 15, -20}};
	static const uint8_t colors[2][4] = {
		{0, 255, 0, 255}, {255, 0, 99, 255}};
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	int white[WIDTH * HEIGHT], covered = 0;

	(void)state;
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-ONE, ONE, -ONE, ONE, ONE, 100 * ONE);
	gl->Enable(GL_LINE_SMOOTH);
	gl->LineWidthx(3 * ONE);
	gl->VertexPointer(3, GL_FLOAT, 0, v);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	gl->ClearColorx(0, 0, 0, 0);
	for (int colored = 0; colored < 2; colored++) {
		gl->Clear(GL_COLOR_BUFFER_BIT);
		gl->DrawArrays(GL_LINES, 0, 2);
		gl->EnableClientState(GL_COLOR_ARRAY);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			const int own = alpha_at(&canvas, i % WIDTH, i / WIDTH);

			white[i] = colored ? white[i] : own;
			covered += own > 0;
			assert_int_equal(own, white[i]);
		}
	}
	assert_true(covered > WIDTH);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

static void test_sizes_are_told(void **state)
{
	static const GLenum names[] = {GL_SMOOTH_POINT_SIZE_RANGE,
		GL_SMOOTH_LINE_WIDTH_RANGE, GL_ALIASED_POINT_SIZE_RANGE,
		GL_ALIASED_LINE_WIDTH_RANGE};
	struct gl_canvas canvas = open_flat(PIXELS_RGB565);

	(void)state;
	for (int i = 0; i < 4; i++) {
		GLint range[2] = {0, 0};

		canvas.gl->GetIntegerv(names[i], range);
		assert_int_equal(range[0], 1);
		assert_int_equal(range[1], 64);
	}
	assert_int_equal(canvas.gl->GetError(), GL_NO_ERROR);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

/* Of a texture and colours that run along the line. */
static void test_values_run_from_end_to_end(void **state)
{
	static const float v[] = {2.5f, 12.5f, 29.5f, 12.5f};
	static const uint8_t colors[2][4] = {{0, 255, 0, 255}, {255, 0, 0, 255}};
	struct gl_canvas canvas = open_flat(PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	for (int smooth = 0; smooth < 2; smooth++) {
		(smooth ? gl->Enable : gl->Disable)(GL_LINE_SMOOTH);
		draw(&canvas, GL_LINES, v, 2);
		for (int x = 3; x < 29; x++) {
			int expected = (x - 2) * 255 / 27;

			assert_true(abs(value_at(&canvas, x, 12) - expected) <=
				6 + 5 * smooth);
		}
	}
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lines_are_as_wide_in_all_of_their_columns),
		cmocka_unit_test(test_strips_share_no_pixel),
		cmocka_unit_test(test_points_are_squares_around_their_place),
		cmocka_unit_test(test_smooth_edges_cover_the_shape),
		cmocka_unit_test(test_smooth_points_are_disks),
		cmocka_unit_test(test_colors_do_not_change_smooth_edges),
		cmocka_unit_test(test_sizes_are_told),
		cmocka_unit_test(test_values_run_from_end_to_end),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
