#include "tests/support/gl_checks.h"

#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/fixed.h"

#define ONE FX16_ONE

/* A rectangle at depth z (in -1..1, clip space), two triangles. */
static void draw_rectangle(struct gl *gl, float left, float bottom, float right,
	float top, float z)
{
	const float vertices[] = {
		left, bottom, z, right, bottom, z, left, top, z, right, top, z};

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, vertices);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

static void draw_all(struct gl *gl)
{
	draw_rectangle(gl, -1, -1, 1, 1, 0);
}

void gl_check_top_row_comes_first(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);

	stage.gl->Color4x(ONE, 0, 0, ONE);
	draw_rectangle(stage.gl, -1, 0.5f, 0, 1, 0);
	stage_end_frame(&stage);
	stage_expect(&stage, 0, 0, 255, 0, 0, 0);
	stage_expect(&stage, STAGE_WIDTH / 2 - 1, 5, 255, 0, 0, 0);
	stage_expect(&stage, STAGE_WIDTH / 2, 0, 0, 0, 0, 0);
	stage_expect(&stage, 0, 6, 0, 0, 0, 0);
	stage_expect(&stage, 0, STAGE_HEIGHT - 1, 0, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_a_triangle_covers_its_pixels(void **state)
{
	static const float vertices[] = {-1, -1, 1, -1, -1, 1};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->Color4x(0, ONE / 2, ONE, ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, vertices);
	gl->DrawArrays(GL_TRIANGLES, 0, 3);
	stage_end_frame(&stage);
	/* The lower left half; the diagonal itself is nobody's to foretell. */
	for (int y = 0; y < STAGE_HEIGHT; y++) {
		for (int x = 0; x < STAGE_WIDTH; x++) {
			float diagonal = (x + 0.5f) / STAGE_WIDTH -
				(y + 0.5f) / STAGE_HEIGHT;

			if (diagonal < -0.05f) {
				stage_expect(&stage, x, y, 0, 128, 255, 1);
			} else if (diagonal > 0.05f) {
				stage_expect(&stage, x, y, 0, 0, 0, 0);
			}
		}
	}
	stage_close(&stage);
}

void gl_check_colours_run_between_vertices(void **state)
{
	static const GLubyte colors[] = {
		255, 0, 0, 255, 0, 0, 255, 255, 255, 0, 0, 255, 0, 0, 255, 255};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, 0, colors);
	draw_all(gl);
	stage_end_frame(&stage);
	for (int x = 0; x < STAGE_WIDTH; x++) {
		int blue = (int)(255 * (x + 0.5f) / STAGE_WIDTH);

		stage_expect(&stage, x, 10, 255 - blue, 0, blue, 2);
	}
	stage_close(&stage);
}

void gl_check_the_nearer_hides_the_farther(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->Enable(GL_DEPTH_TEST);
	gl->Color4x(ONE, 0, 0, ONE);
	draw_rectangle(gl, -1, -1, 0, 1, -0.5f);
	gl->Color4x(0, ONE, 0, ONE);
	draw_rectangle(gl, -1, -1, 1, 1, 0.5f);
	gl->Color4x(0, 0, ONE, ONE);
	draw_rectangle(gl, 0.5f, -1, 1, 1, 0);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 255, 0, 0, 0);
	stage_expect(&stage, 20, 12, 0, 255, 0, 0);
	stage_expect(&stage, 28, 12, 0, 0, 255, 0);
	stage_close(&stage);
}

/* Uploads 2x2 texels: red green / blue white, lower row first. */
static GLuint make_texture(struct gl *gl)
{
	static const GLubyte texels[] = {
		255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255};
	GLuint texture = 0;

	gl->GenTextures(1, &texture);
	assert_int_not_equal(texture, 0);
	gl->BindTexture(GL_TEXTURE_2D, texture);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 2, 2, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
	gl->Enable(GL_TEXTURE_2D);
	return texture;
}

static const float unit_square[] = {0, 0, 1, 0, 0, 1, 1, 1};

void gl_check_a_texture_lies_the_right_way_up(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;
	GLuint texture = make_texture(gl);

	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->Color4x(ONE, ONE, ONE / 2, ONE);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, unit_square);
	draw_all(gl);
	stage_end_frame(&stage);
	stage_expect(&stage, 7, 18, 255, 0, 0, 0);
	stage_expect(&stage, 24, 18, 0, 255, 0, 0);
	stage_expect(&stage, 7, 5, 0, 0, 128, 1);
	stage_expect(&stage, 24, 5, 255, 255, 128, 1);
	gl->DeleteTextures(1, &texture);
	stage_close(&stage);
}

/* Black but for the light; white light 0 from (0, 0, 1) in eye space. */
static void set_up_light(struct gl *gl)
{
	static const GLfixed black[] = {0, 0, 0, ONE};
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed towards_viewer[] = {0, 0, ONE, 0};

	gl->LightModelxv(GL_LIGHT_MODEL_AMBIENT, black);
	gl->Lightxv(GL_LIGHT0, GL_AMBIENT, black);
	gl->Lightxv(GL_LIGHT0, GL_DIFFUSE, white);
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, black);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, towards_viewer);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_AMBIENT, black);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, black);
	gl->Enable(GL_LIGHTING);
	gl->Enable(GL_LIGHT0);
}

void gl_check_light_falls_off_with_the_angle(void **state)
{
	static const GLfixed diffuse[] = {ONE, ONE / 2, ONE / 4, ONE};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, diffuse);
	/* 60 degrees off: half the light. */
	gl->Normal3x(56756, 0, ONE / 2);
	draw_rectangle(gl, -1, -1, 0, 1, 0);
	/* Too long by 2; normalised. */
	gl->Enable(GL_NORMALIZE);
	gl->Normal3x(0, 0, 2 * ONE);
	draw_rectangle(gl, 0, -1, 1, 1, 0);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 128, 64, 32, 1);
	stage_expect(&stage, 28, 12, 255, 128, 64, 1);
	stage_close(&stage);
}

void gl_check_shininess_and_position_light_count(void **state)
{
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed black[] = {0, 0, 0, ONE};
	static const GLfixed at[] = {0, 0, 4 * ONE, ONE};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	set_up_light(gl);
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, white);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, black);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_SPECULAR, white);
	gl->Materialx(GL_FRONT_AND_BACK, GL_SHININESS, 4 * ONE);
	/* Halfway is (0, 0, 1): 0.8^4 = 0.4096. */
	gl->Normal3x(39322, 0, 52429);
	draw_rectangle(gl, -1, -1, 0, 1, 0);
	/* d = sqrt 17 from the ends: 4/d / (1 + d/4) = 0.478. */
	gl->Lightxv(GL_LIGHT0, GL_SPECULAR, black);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, at);
	gl->Lightx(GL_LIGHT0, GL_LINEAR_ATTENUATION, ONE / 4);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Normal3x(0, 0, ONE);
	draw_rectangle(gl, 0, -1, 0.1f, 1, 0);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 104, 104, 104, 2);
	stage_expect(&stage, 16, 12, 122, 122, 122, 2);
	stage_close(&stage);
}

void gl_check_a_spot_lights_what_it_points_at(void **state)
{
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	static const GLfixed at[] = {0, 0, ONE, ONE};
	static const GLfixed direction[] = {0, 0, -ONE};
	static const float strip[] = {-0.1f, -1, 0.1f, -1, -0.1f, 1, 0.1f, 1};
	static const float beside[] = {0.9f, -1, 1, -1, 0.9f, 1, 1, 1};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->Lightxv(GL_LIGHT0, GL_POSITION, at);
	gl->Lightxv(GL_LIGHT0, GL_SPOT_DIRECTION, direction);
	gl->Lightx(GL_LIGHT0, GL_SPOT_CUTOFF, 10 * ONE);
	gl->Normal3x(0, 0, ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->Scalex(ONE, ONE / 16, ONE);
	gl->VertexPointer(2, GL_FLOAT, 0, strip);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->VertexPointer(2, GL_FLOAT, 0, beside);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	stage_end_frame(&stage);
	stage_expect(&stage, 16, 12, 254, 254, 254, 2);
	stage_expect(&stage, 31, 12, 0, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_fog_is_linear_between_start_and_end(void **state)
{
	static const GLfixed blue[] = {0, 0, ONE, ONE};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Orthox(-ONE, ONE, -ONE, ONE, 0, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * ONE);
	gl->Fogx(GL_FOG_END, 6 * ONE);
	gl->Fogxv(GL_FOG_COLOR, blue);
	gl->Enable(GL_FOG);
	gl->Color4x(ONE, 0, 0, ONE);
	draw_rectangle(gl, -1, -1, 0, 1, -3);
	draw_rectangle(gl, 0, -1, 0.5f, 1, -1);
	draw_rectangle(gl, 0.5f, -1, 1, 1, -8);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 191, 0, 64, 2);
	stage_expect(&stage, 20, 12, 255, 0, 0, 0);
	stage_expect(&stage, 28, 12, 0, 0, 255, 0);
	stage_close(&stage);
}

void gl_check_matrices_are_fixed_point(void **state)
{
	/* Half as wide and moved right by a half, column-major. */
	static const GLfixed half[] = {ONE / 2, 0, 0, 0, 0, ONE, 0, 0, 0, 0,
		ONE, 0, ONE / 2, 0, 0, ONE};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->Color4x(ONE, ONE, ONE, ONE);
	gl->LoadMatrixx(half);
	gl->PushMatrix();
	gl->Scalex(ONE, ONE / 2, ONE);
	gl->Translatex(0, ONE, 0);
	draw_all(gl);
	gl->PopMatrix();
	gl->Color4x(ONE, 0, 0, ONE);
	gl->LoadIdentity();
	gl->Rotatex(180 * ONE, 0, 0, ONE);
	gl->MultMatrixx(half);
	gl->Scalex(ONE, ONE / 4, ONE);
	draw_all(gl);
	stage_end_frame(&stage);
	stage_expect(&stage, 16, 0, 255, 255, 255, 0);
	stage_expect(&stage, 31, 11, 255, 255, 255, 0);
	stage_expect(&stage, 31, 12, 0, 0, 0, 0);
	stage_expect(&stage, 0, 0, 0, 0, 0, 0);
	stage_expect(&stage, 0, 12, 255, 0, 0, 0);
	stage_expect(&stage, 15, 9, 255, 0, 0, 0);
	stage_expect(&stage, 15, 15, 0, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_the_frustum_shrinks_the_far(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	gl->Frustumx(-ONE, ONE, -ONE, ONE, ONE, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Color4x(0, ONE, 0, ONE);
	draw_rectangle(gl, -1, -1, 1, 1, -2);
	stage_end_frame(&stage);
	stage_expect(&stage, 7, 12, 0, 0, 0, 0);
	stage_expect(&stage, 8, 12, 0, 255, 0, 0);
	stage_expect(&stage, 23, 12, 0, 255, 0, 0);
	stage_expect(&stage, 24, 12, 0, 0, 0, 0);
	stage_expect(&stage, 16, 5, 0, 0, 0, 0);
	stage_expect(&stage, 16, 6, 0, 255, 0, 0);
	stage_close(&stage);
}

/* One square in every type of array that ES 1.1 has. */
struct typed_square {
	GLbyte bytes[4][4]; /* padded to a stride of 4 */
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

/* The square into the quarter (column, row) of the picture, from below. */
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
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;
	struct typed_square square;
	GLuint texture = make_texture(gl);

	fill_square(&square);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_FIXED, 0, square.colors);
	draw_typed(gl, 0, 0, GL_BYTE, 4, square.bytes);
	draw_typed(gl, 1, 0, GL_SHORT, 0, square.shorts);
	draw_typed(gl, 0, 1, GL_FIXED, 0, square.fixed);
	draw_typed(gl, 1, 1, GL_FLOAT, 0, square.floats);
	stage_end_frame(&stage);
	for (int y = 0; y < STAGE_HEIGHT; y += STAGE_HEIGHT / 2) {
		for (int x = 0; x < STAGE_WIDTH; x += STAGE_WIDTH / 2) {
			stage_expect(&stage, x + 3, y + 9, 255, 0, 0, 0);
			stage_expect(&stage, x + 12, y + 9, 0, 128, 0, 1);
			stage_expect(&stage, x + 3, y + 2, 0, 0, 255, 0);
			stage_expect(&stage, x + 12, y + 2, 255, 128, 255, 1);
		}
	}
	gl->DeleteTextures(1, &texture);
	stage_close(&stage);
}

void gl_check_elements_of_both_index_types_draw(void **state)
{
	static const GLubyte bytes[] = {4, 5, 6};
	static const GLushort shorts[] = {5, 7, 6};
	static const GLfixed normals[8][3] = {
		[4] = {0, 0, ONE}, {0, 0, ONE}, {0, 0, ONE}, {0, 0, ONE}};
	static const GLfixed white[] = {ONE, ONE, ONE, ONE};
	GLfixed vertices[8][2] = {{0}};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	for (int i = 0; i < 4; i++) {
		vertices[4 + i][0] = i % 2 ? ONE : -ONE;
		vertices[4 + i][1] = i / 2 ? ONE : -ONE;
	}
	set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE, white);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->VertexPointer(2, GL_FIXED, 0, vertices);
	gl->NormalPointer(GL_FIXED, 0, normals);
	gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, bytes);
	gl->DrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, shorts);
	stage_end_frame(&stage);
	for (int y = 0; y < STAGE_HEIGHT; y++) {
		for (int x = 0; x < STAGE_WIDTH; x++) {
			stage_expect(&stage, x, y, 255, 255, 255, 0);
		}
	}
	stage_close(&stage);
}

void gl_check_alpha_blends_and_is_tested(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;

	gl->ClearColorx(0, ONE, 0, ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->Color4x(ONE, 0, 0, ONE / 4);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	draw_rectangle(gl, -1, -1, 0, 1, 0);
	gl->Disable(GL_BLEND);
	gl->Enable(GL_ALPHA_TEST);
	gl->AlphaFuncx(GL_GREATER, ONE / 2);
	draw_rectangle(gl, 0, -1, 0.5f, 1, 0);
	gl->AlphaFuncx(GL_GREATER, ONE / 8);
	draw_rectangle(gl, 0.5f, -1, 1, 1, 0);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 64, 191, 0, 1);
	stage_expect(&stage, 20, 12, 0, 255, 0, 0);
	stage_expect(&stage, 28, 12, 255, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_the_combiner_scales(void **state)
{
	static const GLfixed constant[] = {ONE / 4, ONE / 8, ONE, ONE};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;
	GLuint texture = make_texture(gl);

	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_REPLACE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_CONSTANT);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE, 2 * ONE);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, constant);
	draw_all(gl);
	stage_end_frame(&stage);
	stage_expect(&stage, 16, 12, 128, 64, 255, 1);
	gl->DeleteTextures(1, &texture);
	stage_close(&stage);
}

void gl_check_the_stencil_masks(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct gl *gl = stage.gl;
	GLint bits = 0;

	gl->GetIntegerv(GL_STENCIL_BITS, &bits);
	assert_true(bits >= 8);
	gl->GetIntegerv(GL_DEPTH_BITS, &bits);
	assert_true(bits >= 16);
	gl->Enable(GL_STENCIL_TEST);
	gl->StencilFunc(GL_ALWAYS, 1, 0xFF);
	gl->StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
	gl->ColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
	draw_rectangle(gl, -1, -1, 0, 1, 0);
	gl->ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
	gl->StencilFunc(GL_EQUAL, 1, 0xFF);
	gl->Color4x(0, 0, ONE, ONE);
	draw_all(gl);
	stage_end_frame(&stage);
	stage_expect(&stage, 4, 12, 0, 0, 255, 0);
	stage_expect(&stage, 20, 12, 0, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_565_pictures_are_drawn(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGB565);
	struct gl *gl = stage.gl;
	uint16_t pixel;

	gl->Disable(GL_DITHER);
	gl->Color4x(ONE, 0, 0, ONE);
	draw_rectangle(gl, -1, 0, 1, 1, 0);
	gl->Color4x(0, ONE / 2, ONE, ONE);
	draw_rectangle(gl, -1, -1, 0, 0, 0);
	stage_end_frame(&stage);
	memcpy(&pixel, stage.pixels.data, 2);
	assert_int_equal(pixel, 0xF800);
	stage_expect(&stage, 4, 20, 0, 128, 255, 4);
	stage_expect(&stage, 28, 20, 0, 0, 0, 0);
	stage_close(&stage);
}

void gl_check_only_the_pictures_pixels_are_written(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct pixels part = stage.pixels;
	const struct gl_driver *driver = stage.context->driver;

	stage_end_frame(&stage);
	/* A window of 7 x 5 in the middle of the picture. */
	part.data += 6 * part.stride_bytes + 10 * 4;
	part.width = 7;
	part.height = 5;
	memset(stage.pixels.data, 77,
		(size_t)(stage.pixels.stride_bytes * STAGE_HEIGHT));
	assert_int_equal(driver->begin_frame(stage.context, &part), 0);
	stage.gl->ClearColorx(ONE, 0, ONE, ONE);
	stage.gl->Clear(GL_COLOR_BUFFER_BIT);
	stage_end_frame(&stage);
	for (int y = 0; y < STAGE_HEIGHT; y++) {
		for (int x = 0; x < STAGE_WIDTH; x++) {
			bool in = x >= 10 && x < 17 && y >= 6 && y < 11;

			stage_expect(&stage, x, y, in ? 255 : 77, in ? 0 : 77,
				in ? 255 : 77, 0);
		}
	}
	stage_close(&stage);
}

void gl_check_the_size_may_change_between_frames(void **state)
{
	static const int sizes[][2] = {
		{9, 31}, {64, 3}, {64, 3}, {1, 1}, {STAGE_WIDTH, STAGE_HEIGHT}};
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);
	struct log log = log_to_stderr(LOG_WARNING);
	struct gl *gl = stage.gl;
	GLuint texture = make_texture(gl);

	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, unit_square);
	stage_end_frame(&stage);
	for (size_t i = 0; i < sizeof(sizes) / sizeof(sizes[0]); i++) {
		int width = sizes[i][0];
		int height = sizes[i][1];

		free(stage.pixels.data);
		assert_int_equal(pixels_alloc(&stage.pixels, width, height,
					 PIXELS_RGBA8888, &log),
			0);
		assert_int_equal(stage.context->driver->begin_frame(
					 stage.context, &stage.pixels),
			0);
		gl->Clear(GL_COLOR_BUFFER_BIT);
		draw_all(gl);
		stage_end_frame(&stage);
		if (width > 1) {
			stage_expect(&stage, 0, height - 1, 255, 0, 0, 0);
			stage_expect(
				&stage, width - 1, height - 1, 0, 255, 0, 0);
			stage_expect(&stage, 0, 0, 0, 0, 255, 0);
		}
		stage_expect(&stage, width - 1, 0, 255, 255, 255, 0);
	}
	gl->DeleteTextures(1, &texture);
	stage_close(&stage);
}

void gl_check_contexts_may_follow_each_other(void **state)
{
	for (int i = 0; i < 3; i++) {
		struct stage stage = stage_open(*state, PIXELS_RGBA8888);

		assert_non_null(stage.context->description);
		assert_string_equal(stage.context->driver->name, *state);
		stage.gl->Color4x(0, ONE, ONE, ONE);
		draw_all(stage.gl);
		stage_end_frame(&stage);
		stage_expect(&stage, 3, 3, 0, 255, 255, 0);
		stage_close(&stage);
	}
}

void gl_check_another_format_is_refused(void **state)
{
	struct stage stage = stage_open(*state, PIXELS_RGBA8888);

	stage_end_frame(&stage);
	stage.pixels.format = PIXELS_RGB565;
	assert_int_equal(
		stage.context->driver->begin_frame(stage.context, &stage.pixels),
		-EINVAL);
	stage_close(&stage);
}

/* Around a cylinder, lit and textured, before a blended pane and in fog. */
static void draw_cylinder(struct gl *gl)
{
	enum {
		SIDES = 12
	};
	float vertices[SIDES + 1][2][3];
	float normals[SIDES + 1][2][3];
	float coordinates[SIDES + 1][2][2];

	for (int i = 0; i <= SIDES; i++) {
		float angle = (float)i * 6.2831853f / SIDES;

		for (int j = 0; j < 2; j++) {
			float across = sinf(angle), near = cosf(angle);

			memcpy(normals[i][j], (float[]){across, 0, near},
				sizeof(normals[i][j]));
			memcpy(vertices[i][j],
				(float[]){across, j ? 1 : -1, near},
				sizeof(vertices[i][j]));
			memcpy(coordinates[i][j],
				(float[]){(float)i / SIDES, (float)j},
				sizeof(coordinates[i][j]));
		}
	}
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, 0, vertices);
	gl->NormalPointer(GL_FLOAT, 0, normals);
	gl->TexCoordPointer(2, GL_FLOAT, 0, coordinates);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 2 * (SIDES + 1));
	gl->DisableClientState(GL_NORMAL_ARRAY);
	gl->DisableClientState(GL_TEXTURE_COORD_ARRAY);
}

void stage_draw_scene(struct stage *stage)
{
	static const GLfixed material[] = {ONE, 3 * ONE / 4, ONE / 2, ONE};
	static const GLfixed sky[] = {ONE / 8, ONE / 4, ONE / 2, ONE};
	struct gl *gl = stage->gl;
	GLuint texture = make_texture(gl);

	gl->ClearColorx(ONE / 8, ONE / 4, ONE / 2, ONE);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	set_up_light(gl);
	gl->Materialxv(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, material);
	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-ONE, ONE, -ONE, ONE, 2 * ONE, 10 * ONE);
	gl->MatrixMode(GL_MODELVIEW);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * ONE);
	gl->Fogx(GL_FOG_END, 8 * ONE);
	gl->Fogxv(GL_FOG_COLOR, sky);
	gl->Enable(GL_FOG);
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_CULL_FACE);
	gl->CullFace(GL_FRONT);
	gl->Translatex(0, 0, -4 * ONE);
	gl->PushMatrix();
	gl->Rotatex(30 * ONE, ONE, ONE, 0);
	draw_cylinder(gl);
	gl->PopMatrix();
	gl->Disable(GL_CULL_FACE);
	gl->Disable(GL_TEXTURE_2D);
	gl->Disable(GL_LIGHTING);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->Color4x(ONE, ONE, 0, ONE / 2);
	draw_rectangle(gl, -1, -1, 2, 0, 0.5f);
	stage_end_frame(stage);
	gl->DeleteTextures(1, &texture);
}
