/* Array types, strides and primitives; the same as osmesa where it opens. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"
#include "tests/support/random.h"

#include <math.h>
#include <string.h>

#define ONE FX16_ONE

enum {
	ROOM = 512 /* bytes of an array with any stride */
};

/* One number in an array of any type: of 1 where a type has no fractions. */
static void put(uint8_t *at, GLenum type, double value)
{
	switch (type) {
	case GL_BYTE:
		*at = (uint8_t)(GLbyte)lrint(value);
		return;
	case GL_UNSIGNED_BYTE:
		*at = (GLubyte)lrint(value);
		return;
	case GL_SHORT:
		memcpy(at, &(GLshort){(GLshort)lrint(value)}, 2);
		return;
	case GL_FIXED:
		memcpy(at, &(GLfixed){gl_fixed(value)}, 4);
		return;
	default:
		memcpy(at, &(float){(float)value}, 4);
	}
}

static int bytes_of(GLenum type)
{
	return type == GL_BYTE || type == GL_UNSIGNED_BYTE ? 1
		: type == GL_SHORT                         ? 2
							   : 4;
}

/* count elements of size numbers; a stride of 0 packs them. */
static void fill(uint8_t *out, GLenum type, int stride, int size, int count,
	const double *values)
{
	int step = stride ? stride : size * bytes_of(type);

	memset(out, 0xEE, ROOM);
	for (int i = 0; i < size * count; i++) {
		put(out + i / size * step + i % size * bytes_of(type), type,
			values[i]);
	}
}

static const struct type_case {
	const char *name;
	GLenum type;
	int stride;
} types[] = {
	{"bytes", GL_BYTE, 0},
	{"bytes, every 4", GL_BYTE, 4},
	{"bytes, every 7", GL_BYTE, 7},
	{"shorts", GL_SHORT, 0},
	{"shorts, every 10", GL_SHORT, 10},
	{"fixed", GL_FIXED, 0},
	{"fixed, every 24", GL_FIXED, 24},
	{"floats", GL_FLOAT, 0},
	{"floats, every 20", GL_FLOAT, 20},
};

enum {
	TYPES = sizeof(types) / sizeof(types[0])
};

/* The lower right triangle, at whole numbers that a matrix makes small. */
static void test_positions_of_each_type_and_stride(void **state)
{
	static const double corner[] = {-4, -4, 2, 1, 4, -4, 2, 1, 4, 4, 2, 1};

	(void)state;
	for (int i = 0; i < 3 * TYPES; i++) {
		const struct type_case *c = &types[i / 3];
		int size = 2 + i % 3;
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		double values[12];
		uint8_t data[ROOM];

		for (int n = 0; n < 3 * size; n++) {
			values[n] = corner[n / size * 4 + n % size];
		}
		if (c->stride && c->stride < size * bytes_of(c->type)) {
			gl_canvas_close(&canvas);
			continue;
		}
		fill(data, c->type, c->stride, size, 3, values);
		gl->Scalex(ONE / 4, ONE / 4, ONE / 4);
		gl->EnableClientState(GL_VERTEX_ARRAY);
		gl->VertexPointer(size, c->type, c->stride, data);
		gl->DrawArrays(GL_TRIANGLES, 0, 3);
		gl_expect_color(&canvas, c->name, 30, 20, (double[]){1, 1, 1});
		gl_expect_color(&canvas, c->name, 18, 13, (double[]){1, 1, 1});
		gl_expect_color(&canvas, c->name, 13, 10, (double[]){0, 0, 0});
		gl_canvas_end_and_close(&canvas);
	}
}

/* Draws triangles of numbers that fixed point and floats have exactly. */
static struct gl_canvas draw_small(GLenum type, int units, uint32_t seed)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	const GLfixed scale = 65536 / units * ONE;
	uint8_t data[18 * 4];

	for (int i = 0; i < 18; i++) {
		put(data + 4 * i, type, random_within(&seed, units) / 65536.0);
	}
	canvas.gl->Scalex(scale, scale, 0);
	canvas.gl->EnableClientState(GL_VERTEX_ARRAY);
	canvas.gl->VertexPointer(3, type, 0, data);
	canvas.gl->DrawArrays(GL_TRIANGLES, 0, 6);
	gl_canvas_end_frame(&canvas);
	return canvas;
}

static void test_small_fixed_positions_are_as_exact_as_floats(void **state)
{
	(void)state;
	for (uint32_t i = 0; i < 100; i++) {
		const int units = 8 << i % 12;
		struct gl_canvas own = draw_small(GL_FIXED, units, i);
		struct gl_canvas other = draw_small(GL_FLOAT, units, i);

		assert_memory_equal(own.pixels.data, other.pixels.data,
			(size_t)own.pixels.stride_bytes * GL_CANVAS_HEIGHT);
		gl_canvas_close(&other);
		gl_canvas_close(&own);
	}
}

/* GL ES 1.1 table 2.7: bytes and shorts are shares of their largest. */
static void test_normals_of_each_type_and_stride(void **state)
{
	(void)state;
	for (int i = 0; i < 2 * TYPES; i++) {
		const struct type_case *c = &types[i / 2];
		double unit = c->type == GL_BYTE ? 127
			: c->type == GL_SHORT    ? 32767
						 : 1;
		double values[12];
		uint8_t data[ROOM];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);

		for (int n = 0; n < 12; n++) {
			values[n] = unit * (double[]){0, 0.8, 0.6}[n % 3];
		}
		fill(data, c->type, c->stride, 3, 4, values);
		gl_canvas_set_up_light(canvas.gl);
		canvas.gl->Materialxv(GL_FRONT_AND_BACK, GL_DIFFUSE,
			(GLfixed[]){ONE, ONE, ONE, ONE});
		canvas.gl->EnableClientState(GL_NORMAL_ARRAY);
		canvas.gl->NormalPointer(c->type, c->stride, data);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color(
			&canvas, c->name, 9, 9, (double[]){0.6, 0.6, 0.6});
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_colours_of_each_type_and_stride(void **state)
{
	static const struct type_case kinds[] = {
		{"unsigned bytes", GL_UNSIGNED_BYTE, 0},
		{"unsigned bytes, every 12", GL_UNSIGNED_BYTE, 12},
		{"unsigned bytes, every 7", GL_UNSIGNED_BYTE, 7},
		{"fixed", GL_FIXED, 0}, {"fixed, every 28", GL_FIXED, 28},
		{"floats", GL_FLOAT, 0}, {"floats, every 32", GL_FLOAT, 32}};
	static const double own[4] = {0.2, 0.6, 1, 0.4};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(kinds) / sizeof(kinds[0]); i++) {
		const struct type_case *c = &kinds[i / 2];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		double values[16];
		uint8_t data[ROOM];

		for (int n = 0; n < 16; n++) {
			values[n] = own[n % 4] *
				(c->type == GL_UNSIGNED_BYTE ? 255 : 1);
		}
		fill(data, c->type, c->stride, 4, 4, values);
		canvas.gl->EnableClientState(GL_COLOR_ARRAY);
		canvas.gl->ColorPointer(4, c->type, c->stride, data);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color_alpha(&canvas, c->name, 9, 9, own);
		gl_canvas_end_and_close(&canvas);
	}
}

/* Of a texture 2 wide and high, by whole coordinates and a matrix. */
static void test_texture_coordinates_of_each_type_and_stride(void **state)
{
	static const double corner[] = {0, 0, 2, 0, 0, 2, 2, 2};

	(void)state;
	for (int i = 0; i < 2 * TYPES; i++) {
		const struct type_case *c = &types[i / 2];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		GLuint texture = gl_canvas_make_texture(canvas.gl);
		uint8_t data[ROOM];

		fill(data, c->type, c->stride, 2, 4, corner);
		canvas.gl->MatrixMode(GL_TEXTURE);
		canvas.gl->Scalex(ONE / 2, ONE / 2, ONE);
		canvas.gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		canvas.gl->TexCoordPointer(2, c->type, c->stride, data);
		gl_canvas_draw_all(canvas.gl);
		gl_expect_color(&canvas, c->name, 7, 18, (double[]){1, 0, 0});
		gl_expect_color(&canvas, c->name, 24, 18, (double[]){0, 1, 0});
		gl_expect_color(&canvas, c->name, 7, 5, (double[]){0, 0, 1});
		gl_expect_color(&canvas, c->name, 24, 5, (double[]){1, 1, 1});
		canvas.gl->DeleteTextures(1, &texture);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_nothing_is_drawn_without_positions(void **state)
{
	static const float corner[] = {-1, -1, 1, -1, 0, 1};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);

	(void)state;
	canvas.gl->VertexPointer(2, GL_FLOAT, 0, corner);
	canvas.gl->DrawArrays(GL_TRIANGLES, 0, 3);
	gl_expect_color(&canvas, "nothing", 16, 18, (double[]){0, 0, 0});
	gl_canvas_end_and_close(&canvas);
}

/*
 * GL lets lines be off by a pixel (GL ES 1.1 section 3.4.1). Triangles whose
 * vertices are rounded to 16ths may differ along their edges, by off pixels.
 */
static const struct mode_case {
	const char *name;
	GLenum mode;
	int count, reach, off;
} modes[] = {
	{"points", GL_POINTS, 9, 0, 0},
	{"lines", GL_LINES, 8, 1, 0},
	{"lines, one end too many", GL_LINES, 7, 1, 0},
	{"a line strip", GL_LINE_STRIP, 9, 1, 0},
	{"a line loop", GL_LINE_LOOP, 9, 1, 0},
	{"triangles", GL_TRIANGLES, 9, 0, 4},
	{"triangles, two too many", GL_TRIANGLES, 8, 0, 4},
	{"a strip", GL_TRIANGLE_STRIP, 9, 0, 4},
	{"a fan", GL_TRIANGLE_FAN, 9, 0, 4},
	{"too few for a triangle", GL_TRIANGLES, 2, 0, 0},
	{"too few for a line", GL_LINE_STRIP, 1, 0, 0},
};

/* How: 0 arrays, 1 bytes as indices, 2 shorts, 3 arrays from the second on. */
static void draw_mode(struct gl *gl, const struct mode_case *c, int how)
{
	static const float net[10][2] = {{9, 9}, {-0.93f, -0.81f},
		{-0.88f, 0.62f}, {-0.41f, -0.77f}, {-0.33f, 0.84f},
		{0.12f, -0.9f}, {0.21f, 0.58f}, {0.57f, -0.66f}, {0.64f, 0.9f},
		{0.94f, -0.38f}};
	static const GLubyte bytes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};
	static const GLushort shorts[] = {1, 2, 3, 4, 5, 6, 7, 8, 9};

	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(2, GL_FLOAT, 0, how == 3 ? net : net + 1);
	gl->Color4x(ONE, ONE / 2, ONE / 4, ONE);
	if (how == 1 || how == 2) {
		gl->VertexPointer(2, GL_FLOAT, 0, net);
		gl->DrawElements(c->mode, c->count,
			how == 1 ? GL_UNSIGNED_BYTE : GL_UNSIGNED_SHORT,
			how == 1 ? (const void *)bytes : shorts);
		return;
	}
	gl->DrawArrays(c->mode, how == 3 ? 1 : 0, c->count);
}

static void test_elements_draw_as_arrays_do(void **state)
{
	(void)state;
	for (size_t i = 0; i < 6 * sizeof(modes) / sizeof(modes[0]); i++) {
		struct gl_canvas own =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		size_t size = (size_t)own.pixels.stride_bytes * GL_CANVAS_HEIGHT;
		struct gl_canvas other;

		draw_mode(own.gl, &modes[i / 6], 0);
		gl_canvas_end_frame(&own);
		other = gl_canvas_open("soft", gl_expect_formats[i % 2]);
		draw_mode(other.gl, &modes[i / 6], 1 + (int)i / 2 % 3);
		gl_canvas_end_frame(&other);
		assert_memory_equal(own.pixels.data, other.pixels.data, size);
		gl_canvas_close(&other);
		gl_canvas_close(&own);
	}
}

static void draw_arrays_of(struct gl *gl, const void *context)
{
	draw_mode(gl, context, 0);
}

static void test_primitives_cover_what_osmesas_do(void **state)
{
	(void)state;
	for (size_t i = 0; i < sizeof(modes) / sizeof(modes[0]); i++) {
		int count = gl_count_differences(
			draw_arrays_of, &modes[i], modes[i].reach, 3);

		if (count > modes[i].off) {
			fail_msg("%s: %d pixels differ", modes[i].name, count);
		}
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_positions_of_each_type_and_stride),
		cmocka_unit_test(
			test_small_fixed_positions_are_as_exact_as_floats),
		cmocka_unit_test(test_normals_of_each_type_and_stride),
		cmocka_unit_test(test_colours_of_each_type_and_stride),
		cmocka_unit_test(
			test_texture_coordinates_of_each_type_and_stride),
		cmocka_unit_test(test_nothing_is_drawn_without_positions),
		cmocka_unit_test(test_elements_draw_as_arrays_do),
		cmocka_unit_test(test_primitives_cover_what_osmesas_do),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
