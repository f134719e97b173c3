/* The kinds of work that triangles count as (platform/gl/gl_counts.h). */
#include "platform/gl/gl_counts.h"
#include "tests/support/gl/gl_expect.h"

enum {
	FIRST = 4,
	SIZE = 16, /* pixels; the canvas is larger */
	TEXELS = 32,
	TRIANGLES = 2,
	ZOOM = 16 /* of the viewport, for triangles of more than 128 pixels */
};

/* A square and its state; what is not given is off. */
struct work_case {
	enum gl_work_kind kind,
		besides; /* besides GL_WORK_FLAT stands for none */
	GLenum texture, type;
	GLenum min, mag;
	GLenum depth; /* its function */
	bool unwritten, blended, added, alpha_tested, zoomed, marked;
	float far; /* w on the right; that on the left is 1 */
};

static void set_texture(struct gl *gl, const struct work_case *c)
{
	static const uint32_t texel[TEXELS * TEXELS];
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLfixed)c->min);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLfixed)c->mag);
	for (int level = 0; TEXELS >> level > 0; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)c->texture,
			TEXELS >> level, TEXELS >> level, 0, c->texture,
			c->type, texel);
	}
	gl->Enable(GL_TEXTURE_2D);
}

static void set_state(struct gl *gl, const struct work_case *c)
{
	if (c->texture) {
		set_texture(gl, c);
	}
	if (c->depth) {
		gl->Enable(GL_DEPTH_TEST);
		gl->DepthFunc(c->depth);
		gl->DepthMask(!c->unwritten);
	}
	if (c->blended) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(c->added ? GL_ONE : GL_SRC_ALPHA,
			c->added ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
	}
	if (c->alpha_tested) {
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GEQUAL, 0);
	}
	if (c->marked) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_ALWAYS, 1, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
	}
	if (c->zoomed) {
		gl->Viewport(-ZOOM * FIRST, -ZOOM * FIRST,
			ZOOM * GL_CANVAS_WIDTH, ZOOM * GL_CANVAS_HEIGHT);
	}
	if (c->far > 0) {
		const GLfixed half = 32768;

		gl->MatrixMode(GL_PROJECTION);
		gl->Frustumx(-half, half, -half, half, half, 64 * 65536);
	}
}

/* Pixels as clip coordinates. */
static float place(int pixel, int pixels)
{
	return 2.0f * (float)pixel / (float)pixels - 1.0f;
}

/*
 * A square of two triangles with indices of the type; of a strip if that is 0.
 * The corners are those of a strip.
 */
static void draw_square(struct gl *gl, float far, const void *index, GLenum type)
{
	float corner[4][3], s_t[4][2];

	for (int i = 0; i < 4; i++) {
		float w = i % 2 && far > 0 ? far : 1;

		corner[i][0] = place(FIRST + i % 2 * SIZE, GL_CANVAS_WIDTH) * w;
		corner[i][1] = place(FIRST + i / 2 * SIZE, GL_CANVAS_HEIGHT) * w;
		corner[i][2] = far > 0 ? -w : 0;
		s_t[i][0] = i % 2 ? 0.8f : 0.2f;
		s_t[i][1] = i / 2 ? 0.8f : 0.2f;
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, corner);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, s_t);
	if (type) {
		gl->DrawElements(GL_TRIANGLES, 3 * TRIANGLES, type, index);
	} else {
		gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	}
}

static const uint16_t strip[] = {0, 1, 2, 2, 1, 3};

#define TEXTURED_565                                                          \
	.texture = GL_RGB, .type = GL_UNSIGNED_SHORT_5_6_5, .min = GL_LINEAR, \
	.mag = GL_LINEAR
#define NEAREST_565                                                            \
	.texture = GL_RGB, .type = GL_UNSIGNED_SHORT_5_6_5, .min = GL_NEAREST, \
	.mag = GL_NEAREST
#define LUMINANCE                                          \
	.texture = GL_LUMINANCE, .type = GL_UNSIGNED_BYTE, \
	.min = GL_LINEAR_MIPMAP_NEAREST, .mag = GL_LINEAR

static const struct work_case cases[] = {
	{.kind = GL_WORK_BACKDROP},
	{.kind = GL_WORK_PLAIN, .besides = GL_WORK_COLORED, .depth = GL_LESS},
	{.kind = GL_WORK_SPANS, .depth = GL_LESS, .unwritten = true},
	{.kind = GL_WORK_PLAIN, .besides = GL_WORK_COLORED, .depth = GL_LEQUAL},
	{.kind = GL_WORK_SPANS, .depth = GL_GEQUAL},
	{.kind = GL_WORK_MIXED, .blended = true},
	{.kind = GL_WORK_MIXED, .alpha_tested = true},
	{.kind = GL_WORK_MIXED, .depth = GL_LEQUAL, .alpha_tested = true},
	{.kind = GL_WORK_TEXTURED,
		.besides = GL_WORK_COLORED,
		TEXTURED_565,
		.depth = GL_LESS},
	{.kind = GL_WORK_TEXTURED, TEXTURED_565, .depth = GL_GEQUAL},
	{.kind = GL_WORK_TEXTURED,
		.besides = GL_WORK_BENT,
		TEXTURED_565,
		.depth = GL_GEQUAL,
		.far = 1.5f},
	{.kind = GL_WORK_SPANS_TEXTURED, TEXTURED_565, .zoomed = true},
	{.kind = GL_WORK_SPANS_DIVIDED, TEXTURED_565, .far = 8},
	{.kind = GL_WORK_SPANS_NEAREST, NEAREST_565, .depth = GL_GEQUAL},
	{.kind = GL_WORK_SPANS_NEAREST, NEAREST_565, .depth = GL_GEQUAL, .far = 8},
	{.kind = GL_WORK_TESTED, TEXTURED_565, .alpha_tested = true},
	{.kind = GL_WORK_TESTED, NEAREST_565, .alpha_tested = true},
	{.kind = GL_WORK_TESTED,
		.besides = GL_WORK_BENT,
		TEXTURED_565,
		.alpha_tested = true,
		.blended = true,
		.far = 1.5f},
	{.kind = GL_WORK_TESTED_SPANS,
		TEXTURED_565,
		.alpha_tested = true,
		.zoomed = true},
	{.kind = GL_WORK_TESTED_SPANS,
		TEXTURED_565,
		.alpha_tested = true,
		.far = 8},
	{.kind = GL_WORK_MIXED_TEXTURED, TEXTURED_565, .blended = true},
	{.kind = GL_WORK_MIXED_TEXTURED, NEAREST_565, .blended = true},
	{.kind = GL_WORK_MIXED_SPANS,
		TEXTURED_565,
		.blended = true,
		.zoomed = true},
	{.kind = GL_WORK_MIXED_DIVIDED, TEXTURED_565, .blended = true, .far = 8},
	{.kind = GL_WORK_MIXED_TEXTURED,
		.besides = GL_WORK_ADDED,
		TEXTURED_565,
		.blended = true,
		.added = true},
	{.kind = GL_WORK_MIXED,
		.besides = GL_WORK_ADDED,
		.blended = true,
		.added = true},
	{.kind = GL_WORK_SPANS,
		.besides = GL_WORK_PARTED,
		.depth = GL_LEQUAL,
		.marked = true},
	{.kind = GL_WORK_SPANS, .besides = GL_WORK_PARTED, .depth = GL_EQUAL},
	{.kind = GL_WORK_SPANS_DIVIDED,
		.besides = GL_WORK_PARTED,
		TEXTURED_565,
		.depth = GL_LESS,
		.far = 8,
		.marked = true},
	{.kind = GL_WORK_MIXED,
		.besides = GL_WORK_PARTED,
		.blended = true,
		.marked = true},
	{.kind = GL_WORK_LUMINANCE, LUMINANCE},
	{.kind = GL_WORK_LUMINANCE,
		.besides = GL_WORK_DEEP,
		LUMINANCE,
		.depth = GL_ALWAYS},
	{.kind = GL_WORK_LUMINANCE,
		LUMINANCE,
		.depth = GL_ALWAYS,
		.unwritten = true},
};

static void test_each_kind_of_triangle_counts_as_its_own(void **state)
{
	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const struct work_case *c = &cases[i];
		struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
		struct gl_counts counts = {0};

		set_state(canvas.gl, c);
		canvas.context->driver->count(canvas.context, &counts);
		draw_square(canvas.gl, c->far, strip, GL_UNSIGNED_SHORT);
		for (int kind = 0; kind < GL_WORK_KINDS; kind++) {
			bool is = kind == (int)c->kind ||
				(c->besides && kind == (int)c->besides);
			double want = is ? TRIANGLES : 0.0;

			if (counts.work[kind].triangles != want) {
				fail_msg("case %zu: %g triangles of kind %d", i,
					counts.work[kind].triangles, kind);
			}
			if (is && !c->zoomed) {
				assert_true(counts.work[kind].rows ==
					TRIANGLES * SIZE);
				assert_true(counts.work[kind].pixels ==
					SIZE * SIZE);
			}
		}
		gl_canvas_close(&canvas);
	}
}

/* The square's rows, which are longer here, with w on the right. */
static double count_rows_of(enum gl_work_kind kind, float far)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	set_state(canvas.gl, &(struct work_case){TEXTURED_565, .far = far});
	canvas.gl->Viewport(-5, 0, 56, GL_CANVAS_HEIGHT);
	canvas.context->driver->count(canvas.context, &counts);
	draw_square(canvas.gl, far, strip, GL_UNSIGNED_SHORT);
	gl_canvas_close(&canvas);
	assert_true(counts.work[kind].triangles == TRIANGLES);
	return counts.work[kind].rows;
}

/* In strong perspective, rows of more than 16 pixels are divided anew. */
static void test_rows_count_as_their_runs(void **state)
{
	(void)state;
	assert_true(count_rows_of(GL_WORK_TEXTURED, 1) == TRIANGLES * SIZE);
	assert_true(count_rows_of(GL_WORK_SPANS_DIVIDED, 8) >
		1.4 * TRIANGLES * SIZE);
}

static double count_shaded(struct gl_canvas *canvas, const uint16_t *index)
{
	struct gl_counts counts = {0};

	canvas->context->driver->count(canvas->context, &counts);
	draw_square(canvas->gl, 0, index, index ? GL_UNSIGNED_SHORT : 0);
	canvas->context->driver->count(canvas->context, NULL);
	return counts.shaded;
}

static void test_each_vertex_counts_as_shaded_once_a_call(void **state)
{
	/* one provoking vertex, the last of a triangle, for both triangles */
	static const uint16_t one_last[] = {0, 1, 2, 1, 3, 2};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);

	(void)state;
	set_state(canvas.gl, &(struct work_case){.depth = GL_ALWAYS});
	assert_true(count_shaded(&canvas, strip) == 4.0);
	assert_true(count_shaded(&canvas, strip) == 4.0);
	assert_true(count_shaded(&canvas, NULL) == 4.0);
	/* GL_FLAT: copying a triangle's corners counts as shading one. */
	canvas.gl->ShadeModel(GL_FLAT);
	assert_true(count_shaded(&canvas, strip) == 4.0);
	assert_true(count_shaded(&canvas, one_last) == 3.0);
	gl_canvas_close(&canvas);
}

static void test_other_lists_count_by_vertices(void **state)
{
	static const uint8_t bytes[] = {0, 1, 2, 2, 1, 3};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	(void)state;
	canvas.context->driver->count(canvas.context, &counts);
	draw_square(canvas.gl, 0, NULL, 0);
	assert_true(counts.calls == 1.0 && counts.listed == 4.0);
	assert_true(counts.single == 4.0 && counts.vertices == 0.0);
	draw_square(canvas.gl, 0, bytes, GL_UNSIGNED_BYTE);
	assert_true(counts.calls == 2.0 && counts.listed == 4.0 + TRIANGLES);
	assert_true(counts.single == 8.0 && counts.vertices == 0.0);
	gl_canvas_close(&canvas);
}

/* Draws a rectangle of columns x rows pixels behind all depths. */
static double count_skipped(int columns, int rows)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl_counts counts = {0};

	set_state(canvas.gl,
		&(struct work_case){.depth = GL_LESS, .blended = true});
	canvas.gl->ClearDepthx(0);
	canvas.gl->Clear(GL_DEPTH_BUFFER_BIT);
	canvas.context->driver->count(canvas.context, &counts);
	gl_canvas_draw_rectangle(canvas.gl, place(2, GL_CANVAS_WIDTH),
		place(2, GL_CANVAS_HEIGHT), place(2 + columns, GL_CANVAS_WIDTH),
		place(2 + rows, GL_CANVAS_HEIGHT), 0);
	gl_canvas_close(&canvas);
	return counts.skipped;
}

static void test_hidden_triangles_of_a_single_column_are_drawn(void **state)
{
	(void)state;
	assert_true(count_skipped(1, 9) == 0.0);
	assert_true(count_skipped(2, 9) == TRIANGLES);
	assert_true(count_skipped(2, 1) == TRIANGLES);
	assert_true(count_skipped(20, 20) == TRIANGLES);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_kind_of_triangle_counts_as_its_own),
		cmocka_unit_test(test_rows_count_as_their_runs),
		cmocka_unit_test(test_each_vertex_counts_as_shaded_once_a_call),
		cmocka_unit_test(test_other_lists_count_by_vertices),
		cmocka_unit_test(
			test_hidden_triangles_of_a_single_column_are_drawn),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
