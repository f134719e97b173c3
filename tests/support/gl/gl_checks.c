#include "tests/support/gl/gl_checks.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"

#define ONE FX16_ONE

void gl_check_top_row_comes_first(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);

	canvas.gl->Color4x(ONE, 0, 0, ONE);
	gl_canvas_draw_rectangle(canvas.gl, -1, 0.5f, 0, 1, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 0, 0, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH / 2 - 1, 5, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH / 2, 0, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 0, 6, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 0, GL_CANVAS_HEIGHT - 1, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_a_triangle_covers_its_pixels(void **state)
{
	static const float vertices[] = {-1, -1, 1, -1, -1, 1};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->Color4x(0, ONE / 2, ONE, ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, vertices);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
	gl_canvas_end_frame(&canvas);
	/* It covers the lower left half; pixels on the diagonal may be either. */
	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			float diagonal = ((float)x + 0.5f) / GL_CANVAS_WIDTH -
				((float)y + 0.5f) / GL_CANVAS_HEIGHT;

			if (diagonal < -0.05f) {
				gl_canvas_expect(&canvas, x, y, 0, 128, 255, 1);
			} else if (diagonal > 0.05f) {
				gl_canvas_expect(&canvas, x, y, 0, 0, 0, 0);
			}
		}
	}
	gl_canvas_close(&canvas);
}

void gl_check_colours_run_between_vertices(void **state)
{
	static const GLubyte colors[] = {
		255, 0, 0, 255, 0, 0, 255, 255, 255, 0, 0, 255, 0, 0, 255, 255};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
		int blue = (int)(255 * ((float)x + 0.5f) / GL_CANVAS_WIDTH);

		gl_canvas_expect(&canvas, x, 10, 255 - blue, 0, blue, 2);
	}
	gl_canvas_close(&canvas);
}

void gl_check_flat_triangles_have_their_last_corners_colour(void **state)
{
	static const GLubyte colors[] = {255, 0, 0, 255, 0, 0, 255, 255, 0, 255,
		0, 255, 255, 255, 0, 255};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->ShadeModel(GL_FLAT);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 1, 2, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH - 2, 2, 255, 255, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_the_nearer_hides_the_farther(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->Enable(GL_DEPTH_TEST);
	gl->Color4x(ONE, 0, 0, ONE);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, -0.5f);
	gl->Color4x(0, ONE, 0, ONE);
	gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, 0.5f);
	gl->Color4x(0, 0, ONE, ONE);
	gl_canvas_draw_rectangle(gl, 0.5f, -1, 1, 1, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, 20, 12, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, 28, 12, 0, 0, 255, 0);
	gl_canvas_close(&canvas);
}

static const float unit_square[] = {0, 0, 1, 0, 0, 1, 1, 1};

void gl_check_a_texture_lies_the_right_way_up(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	GLuint texture = gl_canvas_make_texture(gl);

	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->Color4x(ONE, ONE, ONE / 2, ONE);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, unit_square);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 7, 18, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, 24, 18, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, 7, 5, 0, 0, 128, 1);
	gl_canvas_expect(&canvas, 24, 5, 255, 255, 128, 1);
	gl->DeleteTextures(1, &texture);
	gl_canvas_close(&canvas);
}

void gl_check_matrices_are_fixed_point(void **state)
{
	/* Scales x by a half and moves right by a half; columns. */
	static const GLfixed half[] = {ONE / 2, 0, 0, 0, 0, ONE, 0, 0, 0, 0,
		ONE, 0, ONE / 2, 0, 0, ONE};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->Color4x(ONE, ONE, ONE, ONE);
	gl->LoadMatrixx(half);
	gl->PushMatrix();
	gl->Scalex(ONE, ONE / 2, ONE);
	gl->Translatex(0, ONE, 0);
	gl_canvas_draw_all(gl);
	gl->PopMatrix();
	gl->Color4x(ONE, 0, 0, ONE);
	gl->LoadIdentity();
	gl->Rotatex(180 * ONE, 0, 0, ONE);
	gl->MultMatrixx(half);
	gl->Scalex(ONE, ONE / 4, ONE);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 16, 0, 255, 255, 255, 0);
	gl_canvas_expect(&canvas, 31, 11, 255, 255, 255, 0);
	gl_canvas_expect(&canvas, 31, 12, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 0, 0, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 0, 12, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, 15, 9, 255, 0, 0, 0);
	gl_canvas_expect(&canvas, 15, 15, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_the_frustum_shrinks_the_far(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-ONE, ONE, -ONE, ONE, ONE, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Color4x(0, ONE, 0, ONE);
	gl_canvas_draw_rectangle(gl, -1, -1, 1, 1, -2);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 7, 12, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 8, 12, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, 23, 12, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, 24, 12, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 16, 5, 0, 0, 0, 0);
	gl_canvas_expect(&canvas, 16, 6, 0, 255, 0, 0);
	gl_canvas_close(&canvas);
}

/* The same square in every array type of ES 1.1. */
struct typed_square {
	GLbyte bytes[4][4]; /* padded to a stride of 4 bytes */
	GLshort shorts[4][2];
	GLfixed fixed[4][2];
	float floats[4][2];
	GLfixed colors[4][4];
};

static void fill_square(struct typed_square *square)
{
	for (int i = 0; i < 4; i++) {
		for (int j = 0; j < 2; j++) {
			int value = j == 0 ? i % 2 : i / 2;

			square->bytes[i][j] = (GLbyte)value;
			square->shorts[i][j] = (GLshort)value;
			square->fixed[i][j] = value * ONE;
			square->floats[i][j] = (float)value;
		}
		for (int j = 0; j < 4; j++) {
			square->colors[i][j] = j == 1 ? ONE / 2 : ONE;
		}
	}
}

/* Draws the square into a quarter of the picture; row 0 is the lower one. */
static void draw_typed(struct gl *gl, int column, int row, GLenum type,
	GLsizei stride, const void *data)
{
	gl->LoadIdentity();
	gl->Translatex((column - 1) * ONE, (row - 1) * ONE, 0);
	gl->VertexPointer(2, type, stride, data);
	gl->TexCoordPointer(2, type, stride, data);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void gl_check_arrays_of_every_type_draw_the_same(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	struct typed_square square;
	GLuint texture = gl_canvas_make_texture(gl);

	fill_square(&square);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_FIXED, 0, square.colors);
	draw_typed(gl, 0, 0, GL_BYTE, 4, square.bytes);
	draw_typed(gl, 1, 0, GL_SHORT, 0, square.shorts);
	draw_typed(gl, 0, 1, GL_FIXED, 0, square.fixed);
	draw_typed(gl, 1, 1, GL_FLOAT, 0, square.floats);
	gl_canvas_end_frame(&canvas);
	for (int y = 0; y < GL_CANVAS_HEIGHT; y += GL_CANVAS_HEIGHT / 2) {
		for (int x = 0; x < GL_CANVAS_WIDTH; x += GL_CANVAS_WIDTH / 2) {
			gl_canvas_expect(&canvas, x + 3, y + 9, 255, 0, 0, 0);
			gl_canvas_expect(&canvas, x + 12, y + 9, 0, 128, 0, 1);
			gl_canvas_expect(&canvas, x + 3, y + 2, 0, 0, 255, 0);
			gl_canvas_expect(
				&canvas, x + 12, y + 2, 255, 128, 255, 1);
		}
	}
	gl->DeleteTextures(1, &texture);
	gl_canvas_close(&canvas);
}

void gl_check_elements_of_both_index_types_draw(void **state)
{
	static const GLubyte bytes[] = {4, 5, 6};
	static const GLushort shorts[] = {5, 7, 6};
	static const GLfixed normals[8][3] = {
		[4] = {0, 0, ONE}, {0, 0, ONE}, {0, 0, ONE}, {0, 0, ONE}};
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	GLfixed vertices[8][2] = {{0}};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	for (int i = 0; i < 4; i++) {
		vertices[4 + i][0] = i % 2 ? ONE : -ONE;
		vertices[4 + i][1] = i / 2 ? ONE : -ONE;
	}
	gl_canvas_set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(2, GL_FIXED, 0, vertices);
	gl->NormalPointer(GL_FIXED, 0, normals);
	gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, bytes);
	gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, shorts);
	gl_canvas_end_frame(&canvas);
	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			gl_canvas_expect(&canvas, x, y, 255, 255, 255, 0);
		}
	}
	gl_canvas_close(&canvas);
}

void gl_check_alpha_blends_and_is_tested(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	gl->ClearColorx(0, ONE, 0, ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->Color4x(ONE, 0, 0, ONE / 4);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
	gl->Disable(GL_BLEND);
	gl->Enable(GL_ALPHA_TEST);
	gl->AlphaFuncx(GL_GREATER, ONE / 2);
	gl_canvas_draw_rectangle(gl, 0, -1, 0.5f, 1, 0);
	gl->AlphaFuncx(GL_GREATER, ONE / 8);
	gl_canvas_draw_rectangle(gl, 0.5f, -1, 1, 1, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 64, 191, 0, 1);
	gl_canvas_expect(&canvas, 20, 12, 0, 255, 0, 0);
	gl_canvas_expect(&canvas, 28, 12, 255, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_the_stencil_masks(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;
	GLint bits = 0;

	gl->GetIntegerv(GL_STENCIL_BITS, &bits);
	assert_true(bits >= 8);
	gl->GetIntegerv(GL_DEPTH_BITS, &bits);
	assert_true(bits >= 16);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, 1, 0xFF);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
	gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 1, 0);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->StencilFunc(GL_EQUAL, 1, 0xFF);
	gl->Color4x(0, 0, ONE, ONE);
	gl_canvas_draw_all(gl);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 4, 12, 0, 0, 255, 0);
	gl_canvas_expect(&canvas, 20, 12, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_565_pictures_are_drawn(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGB565);
	struct gl *gl = canvas.gl;
	uint16_t pixel;

	gl->Disable(GL_DITHER);
	gl->Color4x(ONE, 0, 0, ONE);
	gl_canvas_draw_rectangle(gl, -1, 0, 1, 1, 0);
	gl->Color4x(0, ONE / 2, ONE, ONE);
	gl_canvas_draw_rectangle(gl, -1, -1, 0, 0, 0);
	gl_canvas_end_frame(&canvas);
	memcpy(&pixel, canvas.pixels.data, 2);
	assert_int_equal(pixel, 0xF800);
	gl_canvas_expect(&canvas, 4, 20, 0, 128, 255, 4);
	gl_canvas_expect(&canvas, 28, 20, 0, 0, 0, 0);
	gl_canvas_close(&canvas);
}

void gl_check_only_the_pictures_pixels_are_written(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct pixels part = canvas.pixels;
	const struct gl_driver *driver = canvas.context->driver;

	gl_canvas_end_frame(&canvas);
	/* A window of 7 x 5 in the middle of the picture. */
	part.data += 6 * part.stride_bytes + 10 * 4;
	part.width = 7;
	part.height = 5;
	memset(canvas.pixels.data, 77,
		(size_t)(canvas.pixels.stride_bytes * GL_CANVAS_HEIGHT));
	assert_int_equal(driver->begin_frame(canvas.context, &part), 0);
	canvas.gl->ClearColorx(ONE, 0, ONE, ONE);
	canvas.gl->Clear(GL_COLOR_BUFFER_BIT);
	gl_canvas_end_frame(&canvas);
	for (int y = 0; y < GL_CANVAS_HEIGHT; y++) {
		for (int x = 0; x < GL_CANVAS_WIDTH; x++) {
			bool in = x >= 10 && x < 17 && y >= 6 && y < 11;

			gl_canvas_expect(&canvas, x, y, in ? 255 : 77,
				in ? 0 : 77, in ? 255 : 77, 0);
		}
	}
	gl_canvas_close(&canvas);
}

void gl_check_the_size_may_change_between_frames(void **state)
{
	static const int sizes[][2] = {{9, 31}, {64, 3}, {64, 3}, {1, 1},
		{GL_CANVAS_WIDTH, GL_CANVAS_HEIGHT}};
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl *gl = canvas.gl;
	GLuint texture = gl_canvas_make_texture(gl);

	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, unit_square);
	gl_canvas_end_frame(&canvas);
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		int width = sizes[i][0];
		int height = sizes[i][1];

		free(canvas.pixels.data);
		assert_int_equal(pixels_alloc(&canvas.pixels, width, height,
					 PIXELS_RGBA8888, &log),
			0);
		assert_int_equal(canvas.context->driver->begin_frame(
					 canvas.context, &canvas.pixels),
			0);
		gl->Clear(GL_COLOR_BUFFER_BIT);
		gl_canvas_draw_all(gl);
		gl_canvas_end_frame(&canvas);
		if (width > 1) {
			gl_canvas_expect(&canvas, 0, height - 1, 255, 0, 0, 0);
			gl_canvas_expect(
				&canvas, width - 1, height - 1, 0, 255, 0, 0);
			gl_canvas_expect(&canvas, 0, 0, 0, 0, 255, 0);
		}
		gl_canvas_expect(&canvas, width - 1, 0, 255, 255, 255, 0);
	}
	gl->DeleteTextures(1, &texture);
	gl_canvas_close(&canvas);
}

void gl_check_contexts_may_follow_each_other(void **state)
{
	for (int i = 0; i < 3; i++) {
		struct gl_canvas canvas =
			gl_canvas_open(*state, PIXELS_RGBA8888);

		assert_non_null(canvas.context->description);
		assert_string_equal(canvas.context->driver->name, *state);
		canvas.gl->Color4x(0, ONE, ONE, ONE);
		gl_canvas_draw_all(canvas.gl);
		gl_canvas_end_frame(&canvas);
		gl_canvas_expect(&canvas, 3, 3, 0, 255, 255, 0);
		gl_canvas_close(&canvas);
	}
}

void gl_check_another_format_is_refused(void **state)
{
	struct gl_canvas canvas = gl_canvas_open(*state, PIXELS_RGBA8888);

	gl_canvas_end_frame(&canvas);
	canvas.pixels.format = PIXELS_RGB565;
	assert_int_equal(canvas.context->driver->begin_frame(
				 canvas.context, &canvas.pixels),
		-EINVAL);
	gl_canvas_close(&canvas);
}
