/* Texels: formats, wrapping, filters, levels, by GL ES 1.1 section 3.7. */
#include "platform/base/fixed.h"
#include "tests/support/gl/gl_expect.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#define ONE FX16_ONE

static void bind_new(struct gl *gl, GLenum filter, GLenum wrap_s, GLenum wrap_t)
{
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, (GLfixed)filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, (GLfixed)filter);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, (GLfixed)wrap_s);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, (GLfixed)wrap_t);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->Enable(GL_TEXTURE_2D);
}

/* The whole picture, s and t from corner to corner. */
static void draw_part(
	struct gl *gl, double left, double bottom, double right, double top)
{
	const float st[] = {(float)left, (float)bottom, (float)right,
		(float)bottom, (float)left, (float)top, (float)right,
		(float)top};

	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, 0, st);
	gl_canvas_draw_all(gl);
}

static const struct format_case {
	const char *name;
	GLenum format, type;
	uint8_t texel[4];   /* as it lies in memory */
	double expected[4]; /* MODULATE with white leaves this */
} formats[] = {
	{"RGB 565", GL_RGB, GL_UNSIGNED_SHORT_5_6_5, {0x45, 0x8A},
		{17 / 31.0, 18 / 63.0, 5 / 31.0, 1}},
	{"RGB bytes", GL_RGB, GL_UNSIGNED_BYTE, {200, 100, 50},
		{200 / 255.0, 100 / 255.0, 50 / 255.0, 1}},
	{"RGBA bytes", GL_RGBA, GL_UNSIGNED_BYTE, {200, 100, 50, 150},
		{200 / 255.0, 100 / 255.0, 50 / 255.0, 150 / 255.0}},
	{"RGBA 4444", GL_RGBA, GL_UNSIGNED_SHORT_4_4_4_4, {0x48, 0xA2},
		{10 / 15.0, 2 / 15.0, 4 / 15.0, 8 / 15.0}},
	{"RGBA 5551, opaque", GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, {0x4B, 0xA2},
		{20 / 31.0, 9 / 31.0, 5 / 31.0, 1}},
	{"RGBA 5551, clear", GL_RGBA, GL_UNSIGNED_SHORT_5_5_5_1, {0x4A, 0xA2},
		{20 / 31.0, 9 / 31.0, 5 / 31.0, 0}},
	{"LUMINANCE", GL_LUMINANCE, GL_UNSIGNED_BYTE, {77},
		{77 / 255.0, 77 / 255.0, 77 / 255.0, 1}},
	{"ALPHA", GL_ALPHA, GL_UNSIGNED_BYTE, {77}, {1, 1, 1, 77 / 255.0}},
	{"LUMINANCE_ALPHA", GL_LUMINANCE_ALPHA, GL_UNSIGNED_BYTE, {180, 77},
		{180 / 255.0, 180 / 255.0, 180 / 255.0, 77 / 255.0}},
};

/* Alone into RGBA8888, and over blue by alpha into both. */
static void test_each_format_is_read(void **state)
{
	(void)state;
	for (size_t i = 0; i < 8 * sizeof(formats) / sizeof(formats[0]); i++) {
		const struct format_case *c = &formats[i / 8];
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		double wanted[4];
		bool blended = i & 2;
		double a = c->expected[3];

		bind_new(gl, i & 4 ? GL_LINEAR : GL_NEAREST, GL_REPEAT,
			GL_REPEAT);
		gl->TexImage2D(GL_TEXTURE_2D, 0, (GLint)c->format, 1, 1, 0,
			c->format, c->type, c->texel);
		gl_clear_to(gl, (double[]){0, 0, 1, 1});
		(blended ? gl->Enable : gl->Disable)(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		draw_part(gl, 0, 0, 1, 1);
		memcpy(wanted, c->expected, sizeof(wanted));
		for (int j = 0; j < 4 && blended; j++) {
			wanted[j] = wanted[j] * a + (j >= 2 ? 1 - a : 0);
		}
		gl_expect_color_alpha(&canvas, c->name, 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

enum {
	SIDE_S = 8,
	SIDE_T = 4
};

/* Colours that no two texels share. */
static void make_texels(uint8_t texels[SIDE_T][SIDE_S][3])
{
	for (int t = 0; t < SIDE_T; t++) {
		for (int s = 0; s < SIDE_S; s++) {
			texels[t][s][0] = (uint8_t)(s * 255 / 7);
			texels[t][s][1] = (uint8_t)(t * 255 / 3);
			texels[t][s][2] = (uint8_t)((s * 5 + t * 3) % 8 * 36);
		}
	}
}

static int wrap(GLenum mode, int at, int side)
{
	if (mode == GL_REPEAT) {
		return (at % side + side) % side;
	}
	return at < 0 ? 0 : at >= side ? side - 1 : at;
}

static void sample(uint8_t texels[SIDE_T][SIDE_S][3], GLenum wrap_s,
	GLenum wrap_t, bool linear, double s, double t, double out[3])
{
	double u = s * SIDE_S - (linear ? 0.5 : 0);
	double v = t * SIDE_T - (linear ? 0.5 : 0);
	int x = (int)floor(u), y = (int)floor(v);
	double across = linear ? u - x : 0, down = linear ? v - y : 0;

	for (int i = 0; i < 3; i++) {
		double value = 0;

		for (int corner = 0; corner < 4; corner++) {
			int right = corner & 1, up = corner >> 1;

			value += (right ? across : 1 - across) *
				(up ? down : 1 - down) *
				texels[wrap(wrap_t, y + up, SIDE_T)]
				      [wrap(wrap_s, x + right, SIDE_S)][i];
		}
		out[i] = value / 255;
	}
}

static const struct wrap_case {
	const char *name;
	double left, bottom, right, top;
} parts[] = {
	{"once", 0, 0, 1, 1},
	{"twice", 0, 0, 2, 2},
	{"turned round", 1, 1, 0, 0},
	{"negative", -2, -1, 0, 0},
	{"around 0", -0.5, -0.75, 0.5, 0.25},
	{"a part", 0.3, 0.2, 0.6, 0.55},
	{"large", 100, 200, 101, 201},
	{"large and negative", -301, -101, -300, -100},
};

/* A pixel's centre may fall on two texels' border: those are passed over. */
static bool is_on_border(double s, double t)
{
	double u = s * SIDE_S, v = t * SIDE_T;

	return fabs(u - round(u)) < 0.02 || fabs(v - round(v)) < 0.02;
}

static void check_part(struct gl_canvas *canvas, const struct wrap_case *c,
	GLenum wrap_s, GLenum wrap_t, bool linear)
{
	uint8_t texels[SIDE_T][SIDE_S][3];

	make_texels(texels);
	bind_new(canvas->gl, linear ? GL_LINEAR : GL_NEAREST, wrap_s, wrap_t);
	canvas->gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIDE_S, SIDE_T, 0,
		GL_RGB, GL_UNSIGNED_BYTE, texels);
	draw_part(canvas->gl, c->left, c->bottom, c->right, c->top);
	for (int i = 0; i < GL_CANVAS_WIDTH * GL_CANVAS_HEIGHT; i++) {
		int x = i % GL_CANVAS_WIDTH, y = i / GL_CANVAS_WIDTH;
		double s = c->left +
			(c->right - c->left) * (x + 0.5) / GL_CANVAS_WIDTH;
		double t = c->top +
			(c->bottom - c->top) * (y + 0.5) / GL_CANVAS_HEIGHT;
		double wanted[3];

		if (!linear && is_on_border(s, t)) {
			continue;
		}
		sample(texels, wrap_s, wrap_t, linear, s, t, wanted);
		gl_expect_color(canvas, c->name, x, y, wanted);
	}
}

/* Every part, each way of wrapping in s and t, in both formats. */
static void check_parts(bool linear)
{
	for (size_t i = 0; i < 8 * sizeof(parts) / sizeof(parts[0]); i++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);

		check_part(&canvas, &parts[i / 8],
			i & 2 ? GL_REPEAT : GL_CLAMP_TO_EDGE,
			i & 4 ? GL_REPEAT : GL_CLAMP_TO_EDGE, linear);
		gl_canvas_end_and_close(&canvas);
	}
}

static void test_nearest_texels_repeat_and_clamp(void **state)
{
	(void)state;
	check_parts(false);
}

static void test_linear_texels_repeat_and_clamp(void **state)
{
	(void)state;
	check_parts(true);
}

static void test_a_part_of_a_texture_is_replaced(void **state)
{
	static const uint8_t blue[2][2][3] = {
		{{0, 0, 255}, {0, 0, 255}}, {{0, 0, 255}, {0, 0, 255}}};
	uint8_t texels[SIDE_T][SIDE_S][3];

	(void)state;
	for (int n = 0; n < 2; n++) {
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[n]);
		struct gl *gl = canvas.gl;

		make_texels(texels);
		bind_new(gl, GL_NEAREST, GL_REPEAT, GL_REPEAT);
		gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, SIDE_S, SIDE_T, 0,
			GL_RGB, GL_UNSIGNED_BYTE, texels);
		gl->TexSubImage2D(GL_TEXTURE_2D, 0, 5, 1, 2, 2, GL_RGB,
			GL_UNSIGNED_BYTE, blue);
		for (int i = 0; i < 4; i++) {
			memcpy(texels[1 + i / 2][5 + i % 2], blue[0][0], 3);
		}
		draw_part(gl, 0, 0, 1, 1);
		for (int i = 0; i < SIDE_S * SIDE_T; i++) {
			int s = i % SIDE_S, t = i / SIDE_S;
			double wanted[3];

			for (int j = 0; j < 3; j++) {
				wanted[j] = texels[t][s][j] / 255.0;
			}
			gl_expect_color(&canvas, "texel", 4 * s + 2,
				GL_CANVAS_HEIGHT - 3 - 6 * t, wanted);
		}
		gl_canvas_end_and_close(&canvas);
	}
}

/* Rows of three bytes a texel lie as the alignment says. */
static void test_rows_begin_where_the_alignment_says(void **state)
{
	static const int alignments[] = {1, 2, 4, 8};

	(void)state;
	for (int i = 0; i < 8; i++) {
		int align = alignments[i / 2];
		int row = (3 + align - 1) / align * align;
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		uint8_t texels[16] = {0};

		memcpy(texels, (uint8_t[]){255, 0, 0}, 3);
		memcpy(texels + row, (uint8_t[]){0, 255, 0}, 3);
		bind_new(canvas.gl, GL_NEAREST, GL_REPEAT, GL_REPEAT);
		canvas.gl->PixelStorei(GL_UNPACK_ALIGNMENT, align);
		canvas.gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 1, 2, 0, GL_RGB,
			GL_UNSIGNED_BYTE, texels);
		draw_part(canvas.gl, 0, 0, 1, 1);
		gl_expect_color(&canvas, "lower", 9, 20, (double[]){1, 0, 0});
		gl_expect_color(&canvas, "upper", 9, 3, (double[]){0, 1, 0});
		gl_canvas_end_and_close(&canvas);
	}
}

/* Levels of one colour each: 1 0 0, 0 1 0, 0 0 1, white. */
static const double level_color[4][3] = {
	{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}};

static void make_levels(struct gl *gl)
{
	uint8_t texels[8 * 8][3];

	for (int level = 0; level < 4; level++) {
		for (int i = 0; i < 64; i++) {
			for (int j = 0; j < 3; j++) {
				texels[i][j] =
					(uint8_t)(255 * level_color[level][j]);
			}
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_RGB, 8 >> level,
			8 >> level, 0, GL_RGB, GL_UNSIGNED_BYTE, texels);
	}
}

static void test_a_level_is_chosen_by_size(void **state)
{
	static const struct {
		const char *name;
		GLenum filter;
		double lod; /* log2 of texels a pixel */
		int level;
		double next; /* share of the level after */
	} cases[] = {
		{"nearest has one level", GL_NEAREST, 2, 0, 0},
		{"linear has one level", GL_LINEAR, 2, 0, 0},
		{"magnified", GL_LINEAR_MIPMAP_LINEAR, -2, 0, 0},
		{"nearest level, lod 0.3", GL_NEAREST_MIPMAP_NEAREST, 0.3, 0, 0},
		{"nearest level, lod 0.7", GL_NEAREST_MIPMAP_NEAREST, 0.7, 1, 0},
		{"nearest level, lod 1", GL_NEAREST_MIPMAP_NEAREST, 1, 1, 0},
		{"nearest level, lod 1.4", GL_LINEAR_MIPMAP_NEAREST, 1.4, 1, 0},
		{"nearest level, lod 2", GL_LINEAR_MIPMAP_NEAREST, 2, 2, 0},
		{"nearest level, lod 9", GL_LINEAR_MIPMAP_NEAREST, 9, 3, 0},
		{"between, lod 1", GL_LINEAR_MIPMAP_LINEAR, 1, 1, 0},
		{"between, lod 1.585", GL_NEAREST_MIPMAP_LINEAR, 1.5849625, 1,
			0.585},
		{"between, lod 2.3219", GL_LINEAR_MIPMAP_LINEAR, 2.3219281, 2,
			0.3219},
		{"between, lod 9", GL_LINEAR_MIPMAP_LINEAR, 9, 3, 0},
	};

	(void)state;
	for (size_t i = 0; i < 2 * sizeof(cases) / sizeof(cases[0]); i++) {
		size_t n = i / 2;
		struct gl_canvas canvas =
			gl_canvas_open("soft", gl_expect_formats[i % 2]);
		struct gl *gl = canvas.gl;
		double size = exp2(cases[n].lod) / 8;
		double wanted[3];

		bind_new(gl, GL_NEAREST, GL_REPEAT, GL_REPEAT);
		make_levels(gl);
		gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
			(GLfixed)cases[n].filter);
		draw_part(gl, 0, 0, GL_CANVAS_WIDTH * size,
			GL_CANVAS_HEIGHT * size);
		for (int j = 0; j < 3; j++) {
			int level = cases[n].level;
			int next = level < 3 ? level + 1 : 3;

			wanted[j] = level_color[level][j] * (1 - cases[n].next) +
				level_color[next][j] * cases[n].next;
		}
		gl_expect_color(&canvas, cases[n].name, 9, 9, wanted);
		gl_canvas_end_and_close(&canvas);
	}
}

/* GL ES 1.1 section 3.7.10: as if texturing were off. */
static void test_an_incomplete_texture_is_none(void **state)
{
	static const uint8_t black[3 * 16] = {0};
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGBA8888);
	struct gl *gl = canvas.gl;

	(void)state;
	bind_new(gl, GL_LINEAR, GL_REPEAT, GL_REPEAT);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
	gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGB, 4, 4, 0, GL_RGB,
		GL_UNSIGNED_BYTE, black);
	draw_part(gl, 0, 0, 1, 1);
	gl_expect_color(&canvas, "no levels", 9, 9, (double[]){1, 1, 1});
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
	draw_part(gl, 0, 0, 1, 1);
	gl_expect_color(&canvas, "one level", 9, 9, (double[]){0, 0, 0});
	gl_canvas_end_and_close(&canvas);
}

/* Draws a small luminance texture: of before, then with a part of after. */
static struct gl_canvas draw_gray(const uint8_t *before, const uint8_t *after)
{
	struct gl_canvas canvas = gl_canvas_open("soft", PIXELS_RGB565);
	struct gl *gl = canvas.gl;

	bind_new(gl, GL_LINEAR, GL_REPEAT, GL_REPEAT);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
	for (int level = 0; level < 4; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_LUMINANCE, 8 >> level,
			8 >> level, 0, GL_LUMINANCE, GL_UNSIGNED_BYTE, before);
	}
	draw_part(gl, 0, 0, 1, 1);
	for (int row = 0; row < 2; row++) {
		gl->TexSubImage2D(GL_TEXTURE_2D, 0, 3, 2 + row, 5, 1,
			GL_LUMINANCE, GL_UNSIGNED_BYTE,
			after + 8 * (2 + row) + 3);
	}
	draw_part(gl, 0, 0, 1, 1);
	gl_canvas_end_frame(&canvas);
	return canvas;
}

static void test_a_part_of_a_small_gray_texture_is_replaced(void **state)
{
	uint8_t before[64], after[64];
	struct gl_canvas own, wanted;

	(void)state;
	for (int i = 0; i < 64; i++) {
		before[i] = (uint8_t)(i * 37);
		after[i] = before[i] ^ (i / 16 == 1 && i % 8 >= 3 ? 128 : 0);
	}
	own = draw_gray(before, after);
	wanted = draw_gray(after, after);
	assert_memory_equal(own.pixels.data, wanted.pixels.data,
		(size_t)own.pixels.stride_bytes * GL_CANVAS_HEIGHT);
	gl_canvas_close(&own);
	gl_canvas_close(&wanted);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_each_format_is_read),
		cmocka_unit_test(test_nearest_texels_repeat_and_clamp),
		cmocka_unit_test(test_linear_texels_repeat_and_clamp),
		cmocka_unit_test(test_a_part_of_a_texture_is_replaced),
		cmocka_unit_test(test_a_part_of_a_small_gray_texture_is_replaced),
		cmocka_unit_test(test_rows_begin_where_the_alignment_says),
		cmocka_unit_test(test_a_level_is_chosen_by_size),
		cmocka_unit_test(test_an_incomplete_texture_is_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
