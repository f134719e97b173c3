/* Which pixels the soft driver's triangles cover, and that no others change. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_checks.h"
#include "tests/support/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define ONE FX16_ONE

enum {
	GRID = 9,
	BORDER = 8,
};

static float random_float(uint32_t *seed, float low, float high)
{
	return low + (high - low) * (float)next_random(seed) / 16777216.0f;
}

/* A net over the whole picture, its inner knots moved about. */
static void make_net(float (*net)[2], uint32_t seed)
{
	for (int i = 0; i < GRID * GRID; i++) {
		int x = i % GRID, y = i / GRID;
		bool inner = x > 0 && y > 0 && x < GRID - 1 && y < GRID - 1;
		float step = 2.0f / (GRID - 1);

		net[i][0] = -1.0f + (float)x * step;
		net[i][1] = -1.0f + (float)y * step;
		if (inner) {
			net[i][0] += random_float(&seed, -0.2f, 0.2f) * step;
			net[i][1] += random_float(&seed, -0.2f, 0.2f) * step;
		}
	}
}

static int list_net(uint16_t *index)
{
	int count = 0;

	for (int y = 0; y + 1 < GRID; y++) {
		for (int x = 0; x + 1 < GRID; x++) {
			uint16_t a = (uint16_t)(y * GRID + x);
			uint16_t b = (uint16_t)(a + GRID);
			const uint16_t corner[6] = {a, (uint16_t)(a + 1), b, b,
				(uint16_t)(a + 1), (uint16_t)(b + 1)};

			memcpy(index + count, corner, sizeof(corner));
			count += 6;
		}
	}
	return count;
}

static void test_each_pixel_is_covered_once(void **state)
{
	float net[GRID * GRID][2];
	uint16_t index[GRID * GRID * 6];
	int count = list_net(index);

	(void)state;
	for (uint32_t seed = 1; seed < 60; seed++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		struct gl *gl = canvas.gl;

		make_net(net, seed);
		gl->Color4x(ONE * 40 / 255, 0, 0, ONE);
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_ONE, GL_ONE);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(2, GL_FLOAT, 0, net);
		gl->DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_SHORT, index);
		gl_canvas_end_frame(&canvas);
		for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
			gl_canvas_expect(&canvas, i % GL_CANVAS_WIDTH,
				i / GL_CANVAS_WIDTH, 40, 0, 0, 0);
		}
		gl_canvas_close(&canvas);
	}
}

/* A line is a quad, half of which may lie beside the picture. */
static void test_a_line_along_the_edge_covers_the_first_column(void **state)
{
	const float width = GL_CANVAS_WIDTH / 2.0f,
		    height = GL_CANVAS_HEIGHT / 2.0f;

	(void)state;
	for (int part = 1; part < 16; part++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		struct gl *gl = canvas.gl;
		float x = (float)part / 16.0f / width - 1.0f;
		const float end[2][2] = {
			{x, 1.0f - 2.0f / height}, {x, 1.0f - 10.0f / height}};

		gl->Color4x(ONE, 0, 0, ONE);
		gl->Enable(GL_DEPTH_TEST);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(2, GL_FLOAT, 0, end);
		gl->DrawArrays(GL_LINES, 0, 2);
		gl_canvas_end_frame(&canvas);
		for (int y = 3; y < 9; y++) {
			gl_canvas_expect(&canvas, 0, y, 255, 0, 0, 0);
			gl_canvas_expect(&canvas, 1, y, 0, 0, 0, 0);
		}
		gl_canvas_close(&canvas);
	}
}

/* A picture in the middle of a larger one that must not change. */
struct framed {
	struct gl_context *context;
	struct pixels all, part;
};

static struct framed open_framed(enum pixel_format format)
{
	struct log log = log_to_stderr(LOG_WARNING);
	struct framed framed;

	assert_int_equal(
		gl_open("soft",
			&(struct gl_request){.format = format, .log = &log},
			&framed.context),
		0);
	assert_int_equal(pixels_alloc(&framed.all, 64 + 2 * BORDER,
				 48 + 2 * BORDER, format, &log),
		0);
	memset(framed.all.data, 0xA5,
		(size_t)framed.all.stride_bytes * (size_t)framed.all.height);
	framed.part = framed.all;
	framed.part.width = 64;
	framed.part.height = 48;
	framed.part.data +=
		BORDER * framed.all.stride_bytes + BORDER * pixel_bytes(format);
	assert_int_equal(framed.context->driver->begin_frame(
				 framed.context, &framed.part),
		0);
	framed.context->gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	return framed;
}

static void close_framed(struct framed *framed)
{
	const struct pixels *all = &framed->all;
	int bytes = pixel_bytes(all->format);

	framed->context->driver->end_frame(framed->context);
	for (int y = 0; y < all->height; y++) {
		for (int x = 0; x < all->stride_bytes; x++) {
			bool in = y >= BORDER && y < BORDER + 48 &&
				x >= BORDER * bytes && x < (BORDER + 64) * bytes;

			if (!in && all->data[y * all->stride_bytes + x] != 0xA5) {
				fail_msg("byte %d of row %d was written", x, y);
			}
		}
	}
	framed->context->driver->destroy(framed->context);
	free(framed->all.data);
}

static float wild_number(uint32_t *seed)
{
	static const float wild[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-40f, 1e30f,
		-1e30f, 32768.0f, -40000.0f, 3e38f, INFINITY, -INFINITY, NAN};
	uint32_t kind = next_random(seed) % 40;

	return kind < sizeof(wild) / sizeof(wild[0])
		? wild[kind]
		: random_float(seed, -3.0f, 3.0f);
}

/* Any mixture of states, by the bits of a number. */
static void set_wild_state(struct gl *gl, uint32_t bits)
{
	static const GLenum name[] = {GL_DEPTH_TEST, GL_BLEND, GL_CULL_FACE,
		GL_TEXTURE_2D, GL_FOG, GL_ALPHA_TEST, GL_STENCIL_TEST,
		GL_POINT_SMOOTH, GL_LINE_SMOOTH, GL_LIGHTING,
		GL_POLYGON_OFFSET_FILL, GL_SCISSOR_TEST};

	for (size_t i = 0; i < sizeof(name) / sizeof(name[0]); i++) {
		(bits >> i & 1 ? gl->Enable : gl->Disable)(name[i]);
	}
	gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	gl->AlphaFuncx(GL_GREATER, ONE / 3);
	gl->PolygonOffsetx((GLfixed)bits * 7, (GLfixed)bits * -9);
	gl->Scissor((int)(bits % 80) - 10, (int)(bits % 60) - 10, 40, 70);
	gl->ShadeModel(bits >> 10 & 1 ? GL_FLAT : GL_SMOOTH);
	gl->MatrixMode(GL_PROJECTION);
	gl->LoadIdentity();
	if (bits >> 11 & 1) {
		gl->Frustumx(-ONE, ONE, -ONE, ONE, ONE / 64, 100 * ONE);
	}
	gl->MatrixMode(GL_MODELVIEW);
	gl->LineWidthx((GLfixed)(bits % 9 + 1) * ONE);
	gl->PointSizex((GLfixed)(bits % 70 + 1) * ONE);
}

static void make_texture(struct gl *gl)
{
	uint8_t texels[8 * 8 * 3];
	GLuint name;

	memset(texels, 200, sizeof(texels));
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 8, 8, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
}

static void draw_wildly(struct gl *gl, uint32_t seed)
{
	float vertex[12][8];

	make_texture(gl);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_NORMAL_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->Enable(GL_LIGHT0);
	for (int i = 0; i < 600; i++) {
		for (int j = 0; j < 12 * 8; j++) {
			vertex[j / 8][j % 8] = wild_number(&seed);
		}
		set_wild_state(gl, next_random(&seed));
		gl->VertexPointer(3, GL_FLOAT, sizeof(vertex[0]), vertex[0]);
		gl->NormalPointer(GL_FLOAT, sizeof(vertex[0]), vertex[0] + 3);
		gl->ColorPointer(4, GL_FLOAT, sizeof(vertex[0]), vertex[0] + 2);
		gl->TexCoordPointer(
			2, GL_FLOAT, sizeof(vertex[0]), vertex[0] + 6);
		gl->DrawArrays(next_random(&seed) % 7, 0, 12);
	}
	assert_int_equal(gl->GetError(), GL_NO_ERROR);
}

static void test_nothing_is_written_outside_the_picture(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= 6; seed++) {
		struct framed framed =
			open_framed(seed % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888);

		draw_wildly(&framed.context->gl, seed);
		close_framed(&framed);
	}
}

/* A triangle that reaches far beyond one side still covers what it should. */
static void test_every_plane_cuts(void **state)
{
	static const float far[6][3] = {{-90, 0, 0}, {90, 0, 0}, {0, -90, 0},
		{0, 90, 0}, {0, 0, -90}, {0, 0, 90}};

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", PIXELS_RGBA8888);
		struct gl *gl = canvas.gl;
		int axis = i / 2;
		float a = axis == 0 ? 0.0f : -0.5f, b = axis == 1 ? 0.0f : -0.5f;
		float vertex[3][3] = {{a, b, 0}, {-a, -b, 0}};
		int covered = 0;

		memcpy(vertex[2], far[i], sizeof(vertex[2]));
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(3, GL_FLOAT, 0, vertex);
		gl->DrawArrays(GL_TRIANGLES, 0, 3);
		gl_canvas_end_frame(&canvas);
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			covered += canvas.pixels.data[4 * p] == 255;
		}
		/* Half of a band of half the picture, or a sliver in depth. */
		assert_in_range(covered, axis == 2 ? 0 : 150, 210);
		gl_canvas_close(&canvas);
	}
}

/* Of one column, one row or one pixel, too. */
static void test_small_rectangles_cover_their_pixels(void **state)
{
	static const int sizes[][2] = {
		{1, 1}, {1, 2}, {2, 1}, {1, 9}, {9, 1}, {2, 2}, {3, 7}};
	const float left = 5, below = 3;

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(sizes) / sizeof(sizes[0]); i++) {
		const int *size = sizes[i / 2];
		struct gl_canvas canvas = gl_canvas_open(
			"soft", i % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888);

		gl_canvas_draw_rectangle(canvas.gl,
			left * 2 / GL_CANVAS_WIDTH - 1,
			below * 2 / GL_CANVAS_HEIGHT - 1,
			(left + (float)size[0]) * 2 / GL_CANVAS_WIDTH - 1,
			(below + (float)size[1]) * 2 / GL_CANVAS_HEIGHT - 1, 0);
		gl_canvas_end_frame(&canvas);
		for (int p = 0; p < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; p++) {
			int x = p % GL_CANVAS_WIDTH, y = p / GL_CANVAS_WIDTH;
			int up = GL_CANVAS_HEIGHT - 1 - y;
			int white = x >= 5 && x < 5 + size[0] && up >= 3 &&
				up < 3 + size[1];

			gl_canvas_expect(&canvas, x, y, 255 * white,
				255 * white, 255 * white, 0);
		}
		gl_canvas_close(&canvas);
	}
}

static void test_the_same_depth_loses_to_less(void **state)
{
	static const float square[] = {-1, -1, 1, -1, -1, 1, 1, 1};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl *gl = canvas.gl;

	(void)state;
	gl->Enable(GL_DEPTH_TEST);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, square);
	gl->Color4x(ONE, 0, 0, ONE);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->Color4x(0, ONE, 0, ONE);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl->Enable(GL_POLYGON_OFFSET_FILL);
	gl->PolygonOffsetx(0, -2 * ONE);
	gl->Color4x(0, 0, ONE, ONE);
	gl->Scissor(0, 0, GL_CANVAS_WIDTH / 2, GL_CANVAS_HEIGHT);
	gl->Enable(GL_SCISSOR_TEST);
	gl->DrawArrays(GL_TRIANGLE_STRIP, 0, 4);
	gl_canvas_end_frame(&canvas);
	gl_canvas_expect(&canvas, 3, 3, 0, 0, 255, 0);
	gl_canvas_expect(&canvas, GL_CANVAS_WIDTH - 3, 3, 255, 0, 0, 0);
	gl_canvas_close(&canvas);
}

static int count_red(const struct gl_canvas *canvas)
{
	int count = 0;

	for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
		count += canvas->pixels.data[4 * i] == 255;
	}
	return count;
}

static void test_lines_and_points_have_their_size(void **state)
{
	static const float ends[] = {-1, 0.04f, 0.99f, 0.04f};
	static const float point[] = {0.5f, -0.5f};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	gl->Color4x(ONE, 0, 0, ONE);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, ends);
	gl->DrawArrays(GL_LINES, 0, 2);
	assert_in_range(
		count_red(&canvas), GL_CANVAS_WIDTH - 1, GL_CANVAS_WIDTH);
	gl_canvas_expect(&canvas, 5, GL_CANVAS_HEIGHT / 2 - 1, 255, 0, 0, 0);
	gl->Clear(GL_COLOR_BUFFER_BIT);
	gl->PointSizex(3 * ONE);
	gl->VertexPointer(2, GL_FLOAT, 0, point);
	gl->DrawArrays(GL_POINTS, 0, 1);
	assert_int_equal(count_red(&canvas), 9);
	gl_canvas_expect(&canvas, 24, 18, 255, 0, 0, 0);
	gl_canvas_end_frame(&canvas);
	gl_canvas_close(&canvas);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_pixel_is_covered_once),
		cmocka_unit_test(
			test_a_line_along_the_edge_covers_the_first_column),
		cmocka_unit_test(test_nothing_is_written_outside_the_picture),
		cmocka_unit_test(test_every_plane_cuts),
		cmocka_unit_test(test_small_rectangles_cover_their_pixels),
		cmocka_unit_test(test_the_same_depth_loses_to_less),
		cmocka_unit_test(test_lines_and_points_have_their_size),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
