/* Counts of what is drawn (platform/gl/gl_counts.h). */
#include "platform/gl/gl_counts.h"
#include "tests/support/gl/gl_expect.h"

#include <stdlib.h>
#include <string.h>

enum {
	FIRST = 4,
	SIZE = 16, /* pixels; the canvas is larger */
	TRIANGLES = 2
};

/* Pixels as clip coordinates. */
static float place(int pixel, int pixels)
{
	return 2.0f * (float)pixel / (float)pixels - 1.0f;
}

/* A square inside of the window, of two triangles. */
static void draw_square(const struct gl_canvas *canvas)
{
	static const uint16_t index[] = {0, 1, 2, 2, 1, 3};
	int width = canvas->pixels.width, height = canvas->pixels.height;
	float corner[4][3];

	for (int i = 0; i < 4; i++) {
		corner[i][0] = place(FIRST + i % 2 * SIZE, width);
		corner[i][1] = place(FIRST + i / 2 * SIZE, height);
		corner[i][2] = 0.0f;
	}
	canvas->gl->EnableClientState(GL_VERTEX_ARRAY);
	canvas->gl->VertexPointer(3, GL_FLOAT, 0, corner);
	canvas->gl->DrawElements(
		GL_TRIANGLES, 3 * TRIANGLES, GL_UNSIGNED_SHORT, index);
}

static void count(struct gl_canvas *canvas, struct gl_counts *counts)
{
	canvas->context->driver->count(canvas->context, counts);
}

static void expect_square(const struct gl_counts *counts, enum gl_work_kind kind)
{
	const struct gl_work *work = &counts->work[kind];

	assert_true(counts->calls == 1.0);
	assert_true(counts->listed == TRIANGLES);
	assert_true(counts->vertices + counts->again == 4.0);
	assert_true(work->triangles == TRIANGLES);
	assert_true(work->rows == TRIANGLES * SIZE);
	assert_true(work->pixels == SIZE * SIZE);
}

static void test_a_square_counts_as_what_it_is(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts flat = {0}, plain = {0}, other = {0}, blended = {0};
	struct gl_counts hidden = {0}, unseen = {0};

	(void)state;
	canvas.gl->Enable(GL_STENCIL_TEST);
	canvas.gl->StencilFunc(GL_EQUAL, 0, 255);
	canvas.gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	count(&canvas, &flat);
	draw_square(&canvas);
	expect_square(&flat, GL_WORK_FLAT);
	canvas.gl->Disable(GL_STENCIL_TEST);

	canvas.gl->Enable(GL_DEPTH_TEST);
	count(&canvas, &plain);
	draw_square(&canvas);
	expect_square(&plain, GL_WORK_PLAIN);

	/* The same again lies behind itself. */
	count(&canvas, &hidden);
	draw_square(&canvas);
	assert_true(hidden.work[GL_WORK_PLAIN].pixels == 0.0);
	assert_true(hidden.hidden == SIZE * SIZE);

	canvas.gl->DepthFunc(GL_EQUAL);
	count(&canvas, &other);
	draw_square(&canvas);
	expect_square(&other, GL_WORK_SPANS);

	canvas.gl->Enable(GL_BLEND);
	canvas.gl->BlendFunc(GL_ONE, GL_ONE);
	count(&canvas, &blended);
	draw_square(&canvas);
	expect_square(&blended, GL_WORK_MIXED);

	/* Blended pixels are hidden as others are. */
	canvas.gl->DepthFunc(GL_LESS);
	canvas.gl->DepthMask(GL_FALSE);
	count(&canvas, &unseen);
	draw_square(&canvas);
	assert_true(unseen.work[GL_WORK_MIXED].pixels == 0.0);
	assert_true(unseen.hidden == SIZE * SIZE);
	gl_canvas_close(&canvas);
}

/* The rows of a strip a fifth of a pixel wide, which leans by so many pixels. */
static double count_thin_rows(struct gl_canvas *canvas, float lean)
{
	float width = (float)canvas->pixels.width;
	float bottom = place(FIRST, canvas->pixels.height);
	float top = place(FIRST + SIZE, canvas->pixels.height);
	float left = place(FIRST, canvas->pixels.width) + 1.2f / width;
	float thick = 0.4f / width, right = left + 2.0f * lean / width;
	const float corner[4][2] = {{left, bottom}, {left + thick, bottom},
		{right, top}, {right + thick, top}};
	struct gl_counts counts = {0};

	canvas->gl->VertexPointer(2, GL_FLOAT, 0, corner);
	count(canvas, &counts);
	canvas->gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	assert_true(counts.work[GL_WORK_SPANS].triangles == TRIANGLES);
	return counts.work[GL_WORK_SPANS].rows;
}

/* A thin triangle passes between the centres of pixels in most rows. */
static void test_rows_without_pixels_count_less(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);

	(void)state;
	canvas.gl->Enable(GL_DEPTH_TEST);
	canvas.gl->DepthFunc(GL_ALWAYS);
	canvas.gl->EnableClientState(GL_VERTEX_ARRAY);
	/* Four centres lie in its way, and less than a row at each. */
	assert_in_range((int)count_thin_rows(&canvas, 4), SIZE / 2, SIZE);
	gl_canvas_close(&canvas);
}

/* Small triangles behind all depths around them cost less than their rows. */
static void test_triangles_that_are_not_set_up_count_as_skipped(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts skipped = {0};

	(void)state;
	canvas.gl->Enable(GL_DEPTH_TEST);
	canvas.gl->Enable(GL_BLEND);
	canvas.gl->BlendFunc(GL_ONE, GL_ONE);
	canvas.gl->ClearDepthx(0);
	canvas.gl->Clear(GL_DEPTH_BUFFER_BIT);
	count(&canvas, &skipped);
	draw_square(&canvas);
	assert_true(skipped.skipped == TRIANGLES);
	assert_true(skipped.hidden == 0.0);
	assert_true(skipped.work[GL_WORK_MIXED].triangles == 0.0);
	gl_canvas_close(&canvas);
}

/* Lit on both sides, of which the back alone is drawn. */
static void draw_back_of_square(const struct gl_canvas *canvas)
{
	canvas->gl->Enable(GL_LIGHTING);
	canvas->gl->Enable(GL_LIGHT0);
	canvas->gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
	canvas->gl->Enable(GL_CULL_FACE);
	canvas->gl->CullFace(GL_FRONT);
	canvas->gl->FrontFace(GL_CW);
	draw_square(canvas);
}

static void test_back_faces_count_as_front_faces_do(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	(void)state;
	canvas.gl->Enable(GL_DEPTH_TEST);
	count(&canvas, &counts);
	draw_back_of_square(&canvas);
	expect_square(&counts, GL_WORK_PLAIN);
	assert_true(counts.shaded == 4.0);
	gl_canvas_close(&canvas);
}

static void test_faces_lit_on_both_sides_take_the_same_path(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
		struct gl_counts counts = {0};

		canvas.gl->Enable(GL_DEPTH_TEST);
		canvas.gl->Enable(GL_LIGHTING);
		canvas.gl->Enable(GL_LIGHT0);
		canvas.gl->LightModelx(GL_LIGHT_MODEL_TWO_SIDE, GL_TRUE);
		canvas.gl->FrontFace(i ? GL_CW : GL_CCW);
		count(&canvas, &counts);
		draw_square(&canvas);
		expect_square(&counts, GL_WORK_PLAIN);
		gl_canvas_close(&canvas);
	}
}

static void test_triangles_beside_the_scissor_box_are_not_shaded(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	(void)state;
	canvas.gl->Enable(GL_SCISSOR_TEST);
	canvas.gl->Scissor(GL_CANVAS_WIDTH - 1, 0, 1, GL_CANVAS_HEIGHT);
	count(&canvas, &counts);
	draw_square(&canvas);
	assert_true(counts.calls == 1.0);
	assert_true(counts.shaded == 0.0);
	gl_canvas_close(&canvas);
}

static void test_hidden_back_faces_are_neither_lit_nor_set_up(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts whole = {0}, cut = {0};

	(void)state;
	canvas.gl->Enable(GL_DEPTH_TEST);
	draw_square(&canvas);
	count(&canvas, &whole);
	draw_back_of_square(&canvas);
	assert_true(whole.skipped == TRIANGLES);
	assert_true(whole.shaded == 0.0);
	assert_true(whole.work[GL_WORK_PLAIN].triangles == 0.0);

	/* Beside the scissor box nothing hides them, and nothing is drawn. */
	canvas.gl->Clear(GL_DEPTH_BUFFER_BIT);
	canvas.gl->Enable(GL_SCISSOR_TEST);
	canvas.gl->Scissor(FIRST + 2, FIRST + 2, SIZE - 4, SIZE - 4);
	canvas.gl->Disable(GL_CULL_FACE);
	draw_square(&canvas);
	count(&canvas, &cut);
	draw_back_of_square(&canvas);
	assert_true(cut.skipped == TRIANGLES);
	gl_canvas_close(&canvas);
}

/* The same square with a colour at each corner. */
static void test_triangles_of_several_colors_count_besides(void **state)
{
	static const uint8_t same[4][4] = {{90, 80, 70, 255}, {90, 80, 70, 255},
		{90, 80, 70, 255}, {90, 80, 70, 255}};
	static const uint8_t two[4][4] = {{90, 80, 70, 255}, {90, 80, 70, 255},
		{90, 80, 70, 255}, {90, 8, 70, 255}};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts still = {0}, moving = {0};

	(void)state;
	canvas.gl->Enable(GL_DEPTH_TEST);
	canvas.gl->DepthFunc(GL_ALWAYS);
	canvas.gl->EnableClientState(GL_COLOR_ARRAY);
	canvas.gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, same);
	count(&canvas, &still);
	draw_square(&canvas);
	assert_true(still.work[GL_WORK_COLORED].triangles == 0.0);
	canvas.gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, two);
	count(&canvas, &moving);
	draw_square(&canvas);
	/* The second triangle has the corner that differs. */
	assert_true(moving.work[GL_WORK_COLORED].triangles == 1.0);
	assert_true(moving.work[GL_WORK_COLORED].pixels == SIZE * SIZE / 2);
	assert_true(moving.work[GL_WORK_SPANS].triangles == TRIANGLES);
	gl_canvas_close(&canvas);
}

/* Draws triangles of so many vertices, each of them once. */
static void draw_vertices(struct gl_canvas *canvas, const float (*position)[3],
	const uint16_t *index, int count)
{
	canvas->gl->EnableClientState(GL_VERTEX_ARRAY);
	canvas->gl->VertexPointer(3, GL_FLOAT, 0, position);
	canvas->gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, index);
}

static void test_vertices_that_a_cache_still_has_count_apart(void **state)
{
	static const float small[3][3], other[3][3], large[3000][3];
	static uint16_t index[3000];
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	(void)state;
	for (int i = 0; i < 3000; i++) {
		index[i] = (uint16_t)i;
	}
	count(&canvas, &counts);
	draw_vertices(&canvas, small, index, 3);
	draw_vertices(&canvas, small, index, 3);
	draw_vertices(&canvas, other, index, 3);
	assert_true(counts.vertices == 9.0);
	draw_vertices(&canvas, small, index, 3);
	assert_true(counts.vertices == 9.0);
	assert_true(counts.again == 3.0);
	/* Many vertices push others out, and the first of their own. */
	for (int i = 0; i < 3; i++) {
		draw_vertices(&canvas, large, index, 3000);
	}
	draw_vertices(&canvas, small, index, 3);
	assert_true(counts.vertices == 9012.0);
	assert_true(counts.again == 3.0);
	gl_canvas_close(&canvas);
}

/* A square whose texture coordinates end where they are told to. */
static struct gl_counts count_textured(float from, float to)
{
	static const uint16_t texel[8 * 8];
	const float s_t[4][2] = {{from, from}, {to, from}, {from, to}, {to, to}};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};
	GLuint name;

	canvas.gl->GenTextures(1, &name);
	canvas.gl->BindTexture(GL_TEXTURE_2D, name);
	canvas.gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
	canvas.gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB,
		GL_UNSIGNED_SHORT_5_6_5, texel);
	canvas.gl->Enable(GL_TEXTURE_2D);
	canvas.gl->Enable(GL_DEPTH_TEST);
	canvas.gl->DepthFunc(GL_ALWAYS);
	canvas.gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	canvas.gl->TexCoordPointer(2, GL_FLOAT, 0, s_t);
	count(&canvas, &counts);
	draw_square(&canvas);
	gl_canvas_close(&canvas);
	return counts;
}

/* Runs that read texels at both edges are cut, and their parts count. */
static void test_runs_across_a_textures_edge_count_besides(void **state)
{
	struct gl_counts inside = count_textured(0.125f, 0.875f);
	struct gl_counts across = count_textured(0.5f, 1.5f);
	const struct gl_work *crossed = &across.work[GL_WORK_CROSSED];

	(void)state;
	assert_true(inside.work[GL_WORK_CROSSED].triangles == 0.0);
	assert_true(crossed->triangles == TRIANGLES);
	/* In each row a texel, two pixels wide; all pixels of two rows. */
	assert_true(crossed->rows >= SIZE);
	assert_true(crossed->pixels >= 2 * SIZE + 2 * SIZE - 4);
	assert_true(crossed->pixels < SIZE * SIZE);
}

static void test_nothing_is_counted_after_null(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	(void)state;
	count(&canvas, &counts);
	count(&canvas, NULL);
	draw_square(&canvas);
	assert_true(counts.calls == 0.0);
	gl_canvas_close(&canvas);
}

static void test_counting_changes_no_pixel(void **state)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	size_t size = (size_t)canvas.pixels.stride_bytes *
		(size_t)canvas.pixels.height;
	struct gl_counts counts = {0};
	void *without = malloc(size);

	(void)state;
	assert_non_null(without);
	canvas.gl->Enable(GL_DEPTH_TEST);
	draw_square(&canvas);
	gl_canvas_end_frame(&canvas);
	memcpy(without, canvas.pixels.data, size);
	gl_clear_to(canvas.gl, (double[]){0, 0, 0, 1});
	canvas.gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	count(&canvas, &counts);
	draw_square(&canvas);
	gl_canvas_end_frame(&canvas);
	assert_memory_equal(without, canvas.pixels.data, size);
	free(without);
	gl_canvas_close(&canvas);
}

static void test_scaled_counts_are_all_scaled(void **state)
{
	struct gl_counts counts = {.calls = 2,
		.listed = 4,
		.vertices = 6,
		.again = 24,
		.single = 20,
		.shaded = 8,
		.hidden = 16,
		.skipped = 22,
		.fine = 18,
		.work[GL_WORK_LUMINANCE] = {10, 12, 14}};

	(void)state;
	gl_counts_scale(&counts, 0.5);
	assert_true(counts.calls == 1 && counts.listed == 2 &&
		counts.vertices == 3 && counts.shaded == 4 &&
		counts.hidden == 8 && counts.skipped == 11 &&
		counts.again == 12 && counts.single == 10 && counts.fine == 9);
	assert_true(counts.work[GL_WORK_LUMINANCE].triangles == 5 &&
		counts.work[GL_WORK_LUMINANCE].rows == 6 &&
		counts.work[GL_WORK_LUMINANCE].pixels == 7);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_square_counts_as_what_it_is),
		cmocka_unit_test(test_rows_without_pixels_count_less),
		cmocka_unit_test(
			test_triangles_that_are_not_set_up_count_as_skipped),
		cmocka_unit_test(test_back_faces_count_as_front_faces_do),
		cmocka_unit_test(test_faces_lit_on_both_sides_take_the_same_path),
		cmocka_unit_test(
			test_triangles_beside_the_scissor_box_are_not_shaded),
		cmocka_unit_test(
			test_hidden_back_faces_are_neither_lit_nor_set_up),
		cmocka_unit_test(test_triangles_of_several_colors_count_besides),
		cmocka_unit_test(
			test_vertices_that_a_cache_still_has_count_apart),
		cmocka_unit_test(test_runs_across_a_textures_edge_count_besides),
		cmocka_unit_test(test_nothing_is_counted_after_null),
		cmocka_unit_test(test_counting_changes_no_pixel),
		cmocka_unit_test(test_scaled_counts_are_all_scaled),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
