/*
 * Lines and points of one pixel against the same as triangles, which the
 * reference draws, in random states and places; and which pixels they cover.
 */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/soft/span_scene.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
	SEEDS = RANDOM_CASES(1500),
	LINES = 6,
	ENDS = 2 * LINES,
	DEPTH_APART = 600, /* of pixels next to each other */
};

static GLenum find_function(uint32_t *seed)
{
	return GL_NEVER + (GLenum)random_between(seed, 1, 7);
}

/* What span functions leave to span/beside.c, and sizes of points. */
static void give_rare_state(const struct gl *gl, uint32_t *seed)
{
	if (random_one_in(seed, 6)) {
		gl->ColorMask(GL_TRUE, GL_FALSE, GL_TRUE, GL_FALSE);
	}
	if (random_one_in(seed, 6)) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_DST_COLOR, GL_ONE_MINUS_SRC_ALPHA);
	}
	if (random_one_in(seed, 6)) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_GREATER, 2, 255);
		gl->StencilOp(GL_KEEP, GL_INCR, GL_INVERT);
	}
	gl->PointSizex(random_one_in(seed, 2)
			? FX16_ONE
			: random_between(seed, 1, 70 * FX16_ONE));
}

static void give_state(const struct gl *gl, uint32_t *seed)
{
	if (random_one_in(seed, 3)) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	}
	if (random_one_in(seed, 4)) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(find_function(seed), 32768);
	}
	if (random_one_in(seed, 3)) {
		span_scene_fog(gl);
	}
	if (!random_one_in(seed, 4)) {
		gl->Enable(GL_DEPTH_TEST);
		gl->DepthFunc(
			random_one_in(seed, 2) ? GL_LESS : find_function(seed));
		gl->DepthMask(!random_one_in(seed, 3));
	}
	if (random_one_in(seed, 4)) {
		int x = random_between(seed, -20, 60);
		int y = random_between(seed, -20, 50);
		int width = random_between(seed, 0, 90);

		gl->Enable(GL_SCISSOR_TEST);
		gl->Scissor(x, y, width, random_between(seed, 0, 70));
	}
	gl->ShadeModel(random_one_in(seed, 4) ? GL_FLAT : GL_SMOOTH);
	give_rare_state(gl, seed);
}

/* At depths from 1.2 to 7, where w bends colours, or around 4. */
static void give_ends(struct span_corner corner[ENDS], uint32_t *seed)
{
	static const int sizes[] = {2, 8, 40, 200, 900};
	int size = sizes[random_between(seed, 0, 4)];
	int bend = random_between(seed, 0, 2) * 140;
	bool one_color = random_one_in(seed, 3);

	for (int i = 0; i < ENDS; i++) {
		struct span_corner *c = &corner[i];
		float w = 4.1f +
			(float)random_between(seed, -bend, bend) / 100.0f;
		int x = random_between(seed, -80, 80);
		int y = random_between(seed, -80, 80);

		*c = (struct span_corner){.position = {0, 0, -w}};
		c->position[0] = (float)x / 50.0f;
		c->position[1] = (float)y / 50.0f;
		for (int k = 0; k < 2 && i % 2; k++) {
			c->position[k] = corner[i - 1].position[k] +
				(float)random_between(seed, -size, size) / 50.0f;
		}
		for (int k = 0; k < 4; k++) {
			c->color[k] = (uint8_t)(one_color
					? 200
					: random_between(seed, 0, 255));
		}
	}
}

/* A slope that lines are before and behind, of either way of drawing. */
static void draw_slope(const struct gl *gl)
{
	static const struct span_corner slope[] = {
		{{-9, -6, -2.5f}, {90, 90, 90, 255}, {{0}}},
		{{9, -6, -4}, {90, 90, 90, 255}, {{0}}},
		{{0, 9, -7}, {90, 90, 90, 255}, {{0}}},
	};

	gl->Enable(GL_DEPTH_TEST);
	span_scene_draw(gl, slope, 3);
	gl->Disable(GL_DEPTH_TEST);
}

static struct span_scene *begin(enum pixel_format format)
{
	struct span_scene *scene = span_scene_begin(format, false);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-20000, 20000, -16000, 16000, 65536, 8 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	draw_slope(gl);
	return scene;
}

static struct span_scene *draw(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = begin(format);
	struct span_corner corner[ENDS];
	const struct gl *gl = scene->gl;

	reference_use(scene->soft, reference);
	give_state(gl, &seed);
	give_ends(corner, &seed);
	gl->VertexPointer(3, GL_FLOAT, sizeof(*corner), corner->position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, sizeof(*corner), corner->color);
	gl->DrawArrays(random_one_in(&seed, 4) ? GL_POINTS : GL_LINES, 0, ENDS);
	return scene;
}

/* Whether the other scene has this pixel's colour, and depth, next to it. */
static bool is_found(
	const struct span_scene *own, const struct span_scene *other, int at)
{
	for (int i = 0; i < 9; i++) {
		int x = at % SPAN_WIDTH + i % 3 - 1,
		    y = at / SPAN_WIDTH + i / 3 - 1;
		int there = y * SPAN_WIDTH + x;

		if (x >= 0 && x < SPAN_WIDTH && y >= 0 && y < SPAN_HEIGHT &&
			span_scene_is_near(own, at, other, there) &&
			abs(own->soft->buffers.depth[at] -
				other->soft->buffers.depth[there]) <=
				DEPTH_APART) {
			return true;
		}
	}
	return false;
}

/* Adds to drawn the pixels that are not as in the empty scene. */
static int count_differences(const struct span_scene *a,
	const struct span_scene *b, const struct span_scene *empty, int *drawn)
{
	int count = 0;

	for (int i = 0; i < SPAN_PIXELS; i++) {
		count += !is_found(a, b, i) || !is_found(b, a, i);
		*drawn += !span_scene_is_near(a, i, empty, i);
	}
	return count;
}

static void check(enum pixel_format format)
{
	int drawn = 0, different = 0, listed = 0;

	for (uint32_t seed = 1; seed <= SEEDS; seed++) {
		struct span_scene *empty = begin(format);
		struct span_scene *slow = draw(format, seed * 7919, true);
		struct span_scene *fast = draw(format, seed * 7919, false);

		assert_false(slow->soft->draw->lists);
		listed += fast->soft->draw->lists;
		different += count_differences(fast, slow, empty, &drawn);
		span_scene_close(fast);
		span_scene_close(slow);
		span_scene_close(empty);
	}
	assert_true(drawn > SEEDS * LINES);
	assert_true(different * 100 < drawn);
	/* all that draw anything */
	assert_true(listed * 100 > SEEDS * 85);
}

static void test_lines_of_565_are_those_of_triangles(void **state)
{
	(void)state;
	check(PIXELS_RGB565);
}

static void test_lines_of_8888_are_those_of_triangles(void **state)
{
	(void)state;
	check(PIXELS_RGBA8888);
}

/* A line whose ends lie on 16ths of pixels, y downwards; z from 0 to 1. */
struct exact_line {
	int x[2], y[2];
	double z[2], w[2], red[2];
};

/* Which pixel of a column, or of a row where the line is steep; -1 for none. */
static int find_pixel(const struct exact_line *line, bool flat, int column)
{
	const int *u = flat ? line->x : line->y, *v = flat ? line->y : line->x;
	int centre = 16 * column + 8, length = abs(u[1] - u[0]);
	bool in = u[0] < u[1] ? centre >= u[0] && centre < u[1]
			      : centre <= u[0] && centre > u[1];
	/* On a border it is the pixel below, or to the left. */
	int64_t at = (int64_t)v[0] * length +
		(int64_t)(v[1] - v[0]) * abs(centre - u[0]) +
		(flat ? length - 1 : -1);

	return in ? (int)(at / (16 * length)) : -1;
}

/* What the line has at the centre of a pixel along it, and what it shows. */
static void check_pixel(const struct span_scene *scene,
	const struct exact_line *line, bool flat, int x, int y)
{
	const int *u = flat ? line->x : line->y;
	double t = (16.0 * (flat ? x : y) + 8 - u[0]) / (u[1] - u[0]);
	double q[2] = {(1 - t) / line->w[0], t / line->w[1]};
	double red = (line->red[0] * q[0] + line->red[1] * q[1]) / (q[0] + q[1]);
	double z = 1 + 65533 * (line->z[0] * (1 - t) + line->z[1] * t);
	int at = y * SPAN_WIDTH + x;

	if (fabs(scene->bytes[4 * at] - red) > 2 ||
		fabs(scene->soft->buffers.depth[at] - z) > 3) {
		fail_msg("(%d, %d) to (%d, %d): at %d,%d red is %d for %f, "
			 "depth %d for %f",
			line->x[0], line->y[0], line->x[1], line->y[1], x, y,
			scene->bytes[4 * at], red,
			scene->soft->buffers.depth[at], z);
	}
}

static void draw_exact(
	const struct span_scene *scene, const struct exact_line *line)
{
	/* w is z, from 1 to 24; as find_depth() has it. */
	const GLfixed project[16] = {65536, 0, 0, 0, 0, 65536, 0, 0, 0, 0,
		65536 * 25 / 23, 65536, 0, 0, -65536 * 48 / 23, 0};
	const struct gl *gl = scene->gl;
	float position[2][3];
	uint8_t color[2][4];

	for (int i = 0; i < 2; i++) {
		double ndc[2] = {line->x[i] / (8.0 * SPAN_WIDTH) - 1,
			1 - line->y[i] / (8.0 * SPAN_HEIGHT)};

		position[i][0] = (float)(ndc[0] * line->w[i]);
		position[i][1] = (float)(ndc[1] * line->w[i]);
		position[i][2] = (float)line->w[i];
		for (int k = 0; k < 4; k++) {
			color[i][k] = (uint8_t)line->red[i];
		}
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadMatrixx(project);
	gl->VertexPointer(3, GL_FLOAT, 0, position);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, color);
	gl->DrawArrays(GL_LINES, 0, 2);
}

/* From 0 to 1. */
static double find_depth(double w)
{
	return (25.0 / 23 - 48.0 / 23 / w + 1) / 2;
}

static void make_exact(struct exact_line *line, uint32_t *seed)
{
	int size = random_between(seed, 4, 2000);

	for (int i = 0; i < 2; i++) {
		int x = random_between(seed, 8, SPAN_WIDTH * 16 - 8);
		int y = random_between(seed, 8, SPAN_HEIGHT * 16 - 8);

		if (i == 1) {
			x = line->x[0] + random_between(seed, -size, size);
			y = line->y[0] + random_between(seed, -size, size);
		}
		line->x[i] = x < 8                ? 8
			: x > SPAN_WIDTH * 16 - 8 ? SPAN_WIDTH * 16 - 8
						  : x;
		line->y[i] = y < 8                 ? 8
			: y > SPAN_HEIGHT * 16 - 8 ? SPAN_HEIGHT * 16 - 8
						   : y;
		line->w[i] = i == 1 && random_one_in(seed, 3)
			? line->w[0]
			: random_between(seed, 17, 200) / 16.0;
		line->z[i] = find_depth(line->w[i]);
		line->red[i] = random_between(seed, 1, 255);
	}
}

/* Bresenham's pixels, one in each column or row, and no other. */
static void test_pixels_depths_and_colours_are_exact(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int round = 0; round < 2000; round++) {
		struct span_scene *scene =
			span_scene_begin(PIXELS_RGBA8888, false);
		struct exact_line line;
		bool flat;
		int expected = 0, seen = 0;

		make_exact(&line, &seed);
		flat = abs(line.x[1] - line.x[0]) >= abs(line.y[1] - line.y[0]);
		scene->gl->Enable(GL_DEPTH_TEST);
		scene->gl->DepthFunc(GL_ALWAYS);
		memset(scene->bytes, 0, sizeof(scene->bytes));
		draw_exact(scene, &line);
		for (int i = 0; i < (flat ? SPAN_WIDTH : SPAN_HEIGHT); i++) {
			int pixel = find_pixel(&line, flat, i);

			if (pixel >= 0) {
				expected++;
				check_pixel(scene, &line, flat,
					flat ? i : pixel, flat ? pixel : i);
			}
		}
		for (int i = 0; i < SPAN_PIXELS; i++) {
			seen += scene->bytes[4 * i] != 0;
		}
		assert_int_equal(seen, expected);
		span_scene_close(scene);
	}
}

/* Neither formats, nor depth functions, nor blending. */
static void test_no_state_changes_the_pixels(void **state)
{
	static const float v[] = {
		-0.9f, -0.7f, 0.8f, 0.75f, -0.3f, 0.9f, 0.1f, -0.95f};
	uint8_t first[SPAN_PIXELS];

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct span_scene *scene = span_scene_begin(
			i % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888, false);
		const struct gl *gl = scene->gl;

		gl->Enable(GL_DEPTH_TEST);
		gl->DepthFunc(i / 2 == 1 ? GL_ALWAYS : GL_LESS);
		(i / 2 == 2 ? gl->Enable : gl->Disable)(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(2, GL_FLOAT, 0, v);
		gl->DrawArrays(GL_LINE_LOOP, 0, 4);
		for (int k = 0; k < SPAN_PIXELS; k++) {
			uint8_t is = scene->soft->buffers.depth[k] !=
				scene->soft->buffers.depth[0];

			first[k] = i == 0 ? is : first[k];
			assert_int_equal(is, first[k]);
		}
		span_scene_close(scene);
	}
}

/* A white line from left to right, in the middle of row 11. */
static void draw_level_line(struct gl *gl)
{
	static const float ends[] = {-1, 1.0f / 24, 1, 1.0f / 24};

	gl->Color4x(FX16_ONE, FX16_ONE, FX16_ONE, FX16_ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, ends);
	gl->DrawArrays(GL_LINES, 0, 2);
}

static int count_rows(const struct gl_canvas *canvas)
{
	int rows = 0;

	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		uint8_t rgba[4];

		gl_expect_read(canvas, 9, y, rgba);
		rows += rgba[1] > 0;
	}
	return rows;
}

static void test_widths_are_rounded(void **state)
{
	static const GLfixed one_and_a_half = FX16_ONE * 3 / 2;

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i / 2]);

		canvas.gl->LineWidthx(one_and_a_half - (i % 2 == 0));
		draw_level_line(canvas.gl);
		assert_int_equal(count_rows(&canvas), i % 2 ? 2 : 1);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_lines_obey_masks_and_the_stencil(void **state)
{
	static const double cyan[3] = {0, 1, 1};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i]);
		struct gl *gl = canvas.gl;

		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 1, 255);
		draw_level_line(gl);
		assert_int_equal(count_rows(&canvas), 0);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->ColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
		draw_level_line(gl);
		assert_int_equal(count_rows(&canvas), 1);
		gl_expect_color(&canvas, "a line without red", 9, 11, cyan);
		gl->Disable(GL_STENCIL_TEST);
		gl->Clear(GL_COLOR_BUFFER_BIT);
		draw_level_line(gl);
		gl_expect_color(&canvas, "the same alone", 9, 11, cyan);
		gl_canvas_end_and_close(&canvas);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_widths_are_rounded),
		cmocka_unit_test(test_lines_obey_masks_and_the_stencil),
		cmocka_unit_test(test_lines_of_565_are_those_of_triangles),
		cmocka_unit_test(test_lines_of_8888_are_those_of_triangles),
		cmocka_unit_test(test_pixels_depths_and_colours_are_exact),
		cmocka_unit_test(test_no_state_changes_the_pixels),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
