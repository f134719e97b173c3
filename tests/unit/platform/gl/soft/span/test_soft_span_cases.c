/* Single triangles in which span functions and the reference once differed. */
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/random.h"
#include "tests/support/soft/span_random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

/* A state, and a triangle that is drawn in it, at depths of 1 to 200. */
struct single {
	void (*give)(const struct gl *gl);
	struct span_corner corner[3];
};

static struct span_scene *draw_single(
	const struct single *single, enum pixel_format format, bool reference)
{
	struct span_scene *scene = span_scene_begin(format, reference);
	const struct gl *gl = scene->gl;

	gl->MatrixMode(GL_PROJECTION);
	gl->Frustumx(-65536, 65536, -65536, 65536, 65536, 200 * 65536);
	gl->MatrixMode(GL_MODELVIEW);
	single->give(gl);
	span_scene_draw(gl, single->corner, 3);
	return scene;
}

static void check_single(const struct single *single)
{
	for (int i = 0; i < 2; i++) {
		enum pixel_format format = i ? PIXELS_RGBA8888 : PIXELS_RGB565;
		struct span_scene *fast = draw_single(single, format, false);
		struct span_scene *slow = draw_single(single, format, true);

		assert_ptr_equal(fast->soft->draw->fill, soft_rows_fill);
		span_scene_compare(fast, slow, 0);
		span_scene_close(fast);
		span_scene_close(slow);
	}
}

static void give_fog(const struct gl *gl)
{
	static const GLfixed color[] = {65536, 0, 30000, 65536};

	gl->Enable(GL_FOG);
	gl->Fogx(GL_FOG_MODE, GL_LINEAR);
	gl->Fogx(GL_FOG_START, 2 * 65536);
	gl->Fogx(GL_FOG_END, 10 * 65536);
	gl->Fogxv(GL_FOG_COLOR, color);
}

/* 1 / w changes so much from column to column that column 0's wraps. */
static void test_fog_on_a_steep_sliver_of_one_color(void **state)
{
	static const struct single single = {give_fog,
		{{{-0.7f, 2.08889f, -2.0f}, {52, 42, 93, 17}, {{0}}},
			{{-10.0349f, 24.8106f, -28.31f}, {52, 42, 93, 17}, {{0}}},
			{{-0.682143f, 1.80556f, -2.0f}, {52, 42, 93, 17},
				{{0}}}}};

	(void)state;
	check_single(&single);
}

static void give_levels(const struct gl *gl, GLenum format, int side)
{
	static uint8_t bytes[128 * 128];
	GLuint name;

	for (size_t i = 0; i < sizeof(bytes); i++) {
		bytes[i] = (uint8_t)(i * 29 ^ i >> 3);
	}
	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
	for (int level = 0; side >> level > 0; level++) {
		gl->TexImage2D(GL_TEXTURE_2D, level, (GLint)format,
			side >> level, side >> level, 0, format,
			GL_UNSIGNED_BYTE, bytes);
	}
	gl->Enable(GL_TEXTURE_2D);
}

static void give_dot_of_alpha(const struct gl *gl)
{
	give_levels(gl, GL_ALPHA, 32);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
}

static void test_dot3_of_mixed_levels_of_alpha(void **state)
{
	static const struct single single = {give_dot_of_alpha,
		{{{-1.5f, -1.5f, -2.0f}, {200, 180, 220, 255}, {{0.0f, 0.0f}}},
			{{1.5f, -1.5f, -2.0f}, {20, 30, 10, 255}, {{5.0f, 0.0f}}},
			{{0.0f, 1.5f, -2.0f}, {90, 70, 60, 255},
				{{0.0f, 5.0f}}}}};

	(void)state;
	check_single(&single);
}

static void give_luminance(const struct gl *gl)
{
	give_levels(gl, GL_LUMINANCE, 128);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
}

/* Coordinates beyond 2^15 of a texture's texels wrap without overflowing. */
static void test_coordinates_far_outside_of_a_clamped_texture(void **state)
{
	static const struct single single = {give_luminance,
		{{{-0.5f, -0.5f, -2.0f}, {9, 80, 20, 255}, {{-600.0f, 0.0f}}},
			{{0.0f, -0.5f, -2.0f}, {9, 80, 20, 255},
				{{-600.5f, 0.0f}}},
			{{0.0f, 0.0f, -2.0f}, {9, 80, 20, 255},
				{{-601.0f, 0.5f}}}}};

	(void)state;
	check_single(&single);
}

static struct span_scene *draw_one_color(
	enum pixel_format format, uint32_t seed, GLenum model)
{
	static const uint8_t color[4] = {200, 180, 220, 255};
	struct span_scene *scene = span_begin_in_perspective(format, false);
	struct span_corner corner[3];

	span_give_texels(scene->gl, &seed, 0, 0);
	scene->gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	scene->gl->ShadeModel(model);
	for (int i = 0; i < 10; i++) {
		memcpy(corner, span_make_triangle(&seed), sizeof(corner));
		for (int k = 0; k < 3; k++) {
			memcpy(corner[k].color, color, sizeof(color));
		}
		span_scene_draw(scene->gl, corner, 3);
	}
	return scene;
}

/* Where all corners have one colour, GL_FLAT is GL_SMOOTH. */
static void test_flat_triangles_have_textures_in_perspective(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= 40; seed++) {
		enum pixel_format format =
			seed % 2 ? PIXELS_RGBA8888 : PIXELS_RGB565;
		struct span_scene *flat = draw_one_color(format, seed, GL_FLAT);
		struct span_scene *smooth =
			draw_one_color(format, seed, GL_SMOOTH);

		assert_memory_equal(
			flat->bytes, smooth->bytes, sizeof(flat->bytes));
		span_scene_close(flat);
		span_scene_close(smooth);
	}
}

static void fill_each(struct draw *draw, struct setup *setup)
{
	soft_rows_fill(draw, setup);
}

/* apart: each line is two triangles, as it is for any function but that one. */
static struct span_scene *draw_lines(
	enum pixel_format format, uint32_t seed, bool apart)
{
	struct span_scene *scene = span_begin_in_perspective(format, false);
	const struct gl *gl = scene->gl;

	scene->soft->fill = apart ? fill_each : NULL;
	scene->soft->changed = GROUP_ALL;
	gl->Enable(GL_DEPTH_TEST);
	if (random_one_in(&seed, 2)) {
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
	}
	if (random_one_in(&seed, 2)) {
		gl->Enable(GL_LINE_SMOOTH);
	}
	gl->ShadeModel(random_one_in(&seed, 4) ? GL_FLAT : GL_SMOOTH);
	for (int i = 0; i < 8; i++) {
		gl->LineWidthx(random_between(&seed, 2 << 16, 9 << 16));
		span_scene_draw(gl, span_make_triangle(&seed), 0);
		gl->DrawArrays(GL_LINES, 0, 2);
	}
	return scene;
}

/*
 * Returns how many pixels differ by more than rounding: in lines on which w
 * varies much, rows are divided at other pixels.
 */
static int compare_lines(
	const struct span_scene *one, const struct span_scene *two, int *drawn)
{
	const struct buffers *a = &one->soft->buffers, *b = &two->soft->buffers;
	int apart = 0;

	for (int i = 0; i < SPAN_PIXELS; i++) {
		apart += abs(a->depth[i] - b->depth[i]) > 1 ||
			!span_scene_is_near(one, i, two, i);
		*drawn += a->depth[i] != a->depth[0];
	}
	return apart;
}

static void test_lines_are_those_of_two_triangles(void **state)
{
	int drawn = 0, apart = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= RANDOM_CASES(400); seed++) {
		enum pixel_format format =
			seed % 2 ? PIXELS_RGBA8888 : PIXELS_RGB565;
		struct span_scene *one = draw_lines(format, seed * 7919, false);
		struct span_scene *two = draw_lines(format, seed * 7919, true);

		apart += compare_lines(one, two, &drawn);
		span_scene_close(one);
		span_scene_close(two);
	}
	assert_true(drawn > RANDOM_CASES(200000));
	assert_true(apart < drawn / 10000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lines_are_those_of_two_triangles),
		cmocka_unit_test(
			test_flat_triangles_have_textures_in_perspective),
		cmocka_unit_test(test_fog_on_a_steep_sliver_of_one_color),
		cmocka_unit_test(test_dot3_of_mixed_levels_of_alpha),
		cmocka_unit_test(
			test_coordinates_far_outside_of_a_clamped_texture),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
