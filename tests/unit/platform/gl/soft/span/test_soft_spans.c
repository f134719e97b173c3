/*
 * Every span function against the reference, which draws any state: random
 * states, textures, sizes and places. Coverage, depth and stencil are equal,
 * colours within a step of RGB565.
 */
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/random.h"
#include "tests/support/soft/span_random.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static void give_combiner(const struct gl *gl, uint32_t *seed)
{
	static const GLenum functions[] = {GL_REPLACE, GL_MODULATE, GL_ADD,
		0x8574 /* ADD_SIGNED */, 0x8575 /* INTERPOLATE */,
		0x84E7 /* SUBTRACT */, GL_DOT3_RGB, GL_DOT3_RGBA};
	static const GLenum sources[] = {
		GL_TEXTURE, GL_CONSTANT, GL_PRIMARY_COLOR, GL_PREVIOUS};
	static const GLenum operands[] = {GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA,
		GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR};

	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB,
		(GLfixed)span_one_of(seed, functions, 8));
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_ALPHA,
		(GLfixed)span_one_of(seed, functions, 6));
	for (GLenum i = 0; i < 3; i++) {
		gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB + i,
			(GLfixed)span_one_of(seed, sources, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_ALPHA + i,
			(GLfixed)span_one_of(seed, sources, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, GL_OPERAND0_RGB + i,
			(GLfixed)span_one_of(seed, operands, 4));
		gl->TexEnvx(GL_TEXTURE_ENV, 0x8598 /* GL_OPERAND0_ALPHA */ + i,
			(GLfixed)span_one_of(seed, operands, 2));
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_RGB_SCALE,
		65536 << random_between(seed, 0, 2));
	gl->TexEnvx(GL_TEXTURE_ENV, 0x0D1C /* GL_ALPHA_SCALE */,
		65536 << random_between(seed, 0, 2));
}

static void give_environment(const struct gl *gl, uint32_t *seed)
{
	static const GLenum modes[] = {GL_MODULATE, GL_MODULATE, GL_REPLACE,
		GL_DECAL, GL_ADD, GL_BLEND, GL_COMBINE};
	GLfixed color[4];

	for (int i = 0; i < 4; i++) {
		color[i] = random_between(seed, 0, 65536);
	}
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
		(GLfixed)span_one_of(seed, modes, 7));
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
	give_combiner(gl, seed);
}

/* None, the first, the second, or both, with coordinates of their own. */
static void give_textures(const struct gl *gl, uint32_t *seed)
{
	int which = random_between(seed, 0, 7);

	which = which > 3 ? 1 : which;
	for (int unit = 0; unit < 2; unit++) {
		if (which >> unit & 1) {
			gl->ActiveTexture(GL_TEXTURE0 + (GLenum)unit);
			gl->ClientActiveTexture(GL_TEXTURE0 + (GLenum)unit);
			span_give_texture(gl, seed);
			give_environment(gl, seed);
			gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
		}
	}
}

static void give_fragments(const struct gl *gl, uint32_t *seed)
{
	static const GLenum functions[] = {GL_LESS, GL_LEQUAL, GL_GREATER,
		GL_ALWAYS, GL_NOTEQUAL, GL_GEQUAL, GL_EQUAL};
	static const GLenum source[] = {GL_SRC_ALPHA, GL_SRC_ALPHA,
		GL_SRC_ALPHA, GL_ONE, GL_DST_COLOR, GL_ZERO,
		GL_ONE_MINUS_DST_COLOR, GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA,
		0x0308 /* GL_SRC_ALPHA_SATURATE */};
	static const GLenum destination[] = {GL_ONE_MINUS_SRC_ALPHA,
		GL_ONE_MINUS_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ZERO,
		GL_SRC_COLOR, GL_ONE_MINUS_SRC_COLOR, GL_SRC_ALPHA,
		GL_DST_ALPHA, GL_ONE_MINUS_DST_ALPHA};

	if (random_one_in(seed, 3)) {
		GLenum from = span_one_of(seed, source, 10);

		gl->Enable(GL_BLEND);
		gl->BlendFunc(from, span_one_of(seed, destination, 10));
	}
	if (random_one_in(seed, 3)) {
		GLenum function = span_one_of(seed, functions, 7);

		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(function, random_between(seed, 0, 65536));
	}
	if (random_one_in(seed, 4)) {
		span_scene_fog(gl);
	}
	if (!random_one_in(seed, 6)) {
		gl->Enable(GL_DEPTH_TEST);
		gl->DepthFunc(random_one_in(seed, 2)
				? GL_LESS
				: span_one_of(seed, functions, 7));
		gl->DepthMask(!random_one_in(seed, 4));
	}
	if (random_one_in(seed, 8)) {
		int mask = random_one_in(seed, 3) ? 0
						  : random_between(seed, 0, 15);

		gl->ColorMask(
			mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1);
	}
	if (random_one_in(seed, 8)) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(GL_EQUAL, 0, 255);
		gl->StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
	}
}

static void give_triangle(const struct gl *gl, uint32_t *seed)
{
	span_scene_draw(gl, span_make_triangle(seed), 3);
}

static struct span_scene *draw(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	give_textures(gl, &seed);
	give_fragments(gl, &seed);
	give_triangle(gl, &seed);
	return scene;
}

static void check(enum pixel_format format)
{
	/* other scenes than everyone's, to look for differences */
	const char *from = getenv("SPANS_FROM"), *count = getenv("SPANS_COUNT");
	uint32_t first = from ? (uint32_t)strtoul(from, NULL, 10) : 0;
	int seeds = count ? atoi(count) : RANDOM_CASES(3000);
	int used = 0, drawn = 0;

	for (uint32_t i = 1; i <= (uint32_t)seeds; i++) {
		uint32_t seed = first + i;
		struct span_scene *fast = draw(format, seed * 7919, false);
		struct span_scene *slow = draw(format, seed * 7919, true);

		used += fast->soft->draw->fill == soft_rows_fill;
		drawn += span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	/* others have an alpha test that nothing passes */
	assert_true(used > seeds / 10 * 9);
	assert_true(drawn > seeds * 33);
}

static void test_spans_of_565_are_those_of_fragments(void **state)
{
	(void)state;
	check(PIXELS_RGB565);
}

static void test_spans_of_8888_are_those_of_fragments(void **state)
{
	(void)state;
	check(PIXELS_RGBA8888);
}

/*
 * A clipped triangle, whose first part is small and reads a part of its level:
 * the second part, in perspective, reads the whole level.
 */
static void test_a_small_triangle_leaves_the_next_its_level(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		const enum pixel_format format =
			i ? PIXELS_RGBA8888 : PIXELS_RGB565;
		const uint32_t seed = 152906;
		struct span_scene *fast = draw(format, seed * 7919, false);
		struct span_scene *slow = draw(format, seed * 7919, true);

		assert_true(span_scene_compare(fast, slow, seed) > 0);
		span_scene_close(fast);
		span_scene_close(slow);
	}
}

/* The second unit's texture is any; its environment does not read it. */
static void add_color(const struct gl *gl, uint32_t *seed)
{
	const bool swapped = random_one_in(seed, 2);
	GLfixed color[4];

	for (int i = 0; i < 4; i++) {
		color[i] = random_between(seed, 0, 65536);
	}
	gl->ActiveTexture(GL_TEXTURE1);
	span_give_texture(gl, seed);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
	gl->TexEnvx(GL_TEXTURE_ENV, swapped ? GL_SRC1_RGB : GL_SRC0_RGB,
		GL_PREVIOUS);
	gl->TexEnvx(GL_TEXTURE_ENV, swapped ? GL_SRC0_RGB : GL_SRC1_RGB,
		GL_CONSTANT);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
}

static struct span_scene *draw_sum(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	span_give_texture(gl, &seed);
	if (random_one_in(&seed, 4)) {
		give_environment(gl, &seed);
	}
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	add_color(gl, &seed);
	give_fragments(gl, &seed);
	give_triangle(gl, &seed);
	return scene;
}

/* A colour that is added to a texture's, as surfaces that emit light have it. */
static void test_added_colours_are_those_of_fragments(void **state)
{
	int added = 0, drawn = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= RANDOM_CASES(900); seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast = draw_sum(format, seed * 7919, false);
		struct span_scene *slow = draw_sum(format, seed * 7919, true);

		added += fast->soft->draw->added != NULL;
		drawn += span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	assert_true(added > RANDOM_CASES(500));
	assert_true(drawn > RANDOM_CASES(30000));
}

static struct span_scene *draw_heap(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(seed % 2 ? GL_LESS : GL_LEQUAL);
	span_give_texture(gl, &seed);
	for (int i = 0; i < 60; i++) {
		give_triangle(gl, &seed);
	}
	return scene;
}

/* Triangles behind others, which the driver does not set up, and before them. */
static void test_heaps_of_triangles_are_those_of_fragments(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= RANDOM_CASES(120); seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast = draw_heap(format, seed * 7919, false);
		struct span_scene *slow = draw_heap(format, seed * 7919, true);

		assert_true(span_scene_compare(fast, slow, seed) > 1000);
		span_scene_close(fast);
		span_scene_close(slow);
	}
}

/* Depths and stencil values that change along rows, in places at each pixel. */
static void give_buffers(struct span_scene *scene, uint32_t *seed)
{
	const struct buffers *buffers = &scene->soft->buffers;
	int next = 0;

	for (int i = 0; i < SPAN_PIXELS; i++) {
		if (i == next) {
			next += random_between(seed, 1, 20);
			buffers->depth[i] =
				(uint16_t)random_between(seed, 30000, 64000);
			buffers->stencil[i] =
				(uint8_t)random_between(seed, 0, 3);
		} else {
			buffers->depth[i] = buffers->depth[i - 1];
			buffers->stencil[i] = buffers->stencil[i - 1];
		}
	}
}

static void give_tests(const struct gl *gl, uint32_t *seed)
{
	static const GLenum operations[] = {GL_KEEP, GL_KEEP, GL_ZERO,
		GL_REPLACE, GL_INCR, GL_DECR, GL_INVERT};
	GLenum fail = span_one_of(seed, operations, 7);
	GLenum far = span_one_of(seed, operations, 7);
	GLenum near = span_one_of(seed, operations, 7);
	GLenum by = GL_NEVER + (GLenum)random_between(seed, 0, 7);
	int mask = random_one_in(seed, 4) ? 0 : random_between(seed, 0, 15);

	gl->DepthFunc(GL_NEVER + (GLenum)random_between(seed, 0, 7));
	if (!random_one_in(seed, 3)) {
		gl->Enable(GL_STENCIL_TEST);
		gl->StencilFunc(by, random_between(seed, 0, 3),
			random_one_in(seed, 4) ? 1 : 255);
		gl->StencilOp(fail, far, near);
		gl->StencilMask(random_one_in(seed, 4) ? 1 : 255);
	}
	if (random_one_in(seed, 3)) {
		gl->ColorMask(
			mask & 1, mask >> 1 & 1, mask >> 2 & 1, mask >> 3 & 1);
	}
}

static struct span_scene *draw_tested(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	give_buffers(scene, &seed);
	if (random_one_in(&seed, 2)) {
		give_textures(gl, &seed);
	}
	give_fragments(gl, &seed);
	give_tests(gl, &seed);
	for (int i = 0; i < 3; i++) {
		give_triangle(gl, &seed);
	}
	return scene;
}

/* Depth and stencil tests whose results change along rows. */
static void test_tests_are_those_of_fragments(void **state)
{
	int drawn = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= RANDOM_CASES(1500); seed++) {
		enum pixel_format format =
			seed % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast =
			draw_tested(format, seed * 7919, false);
		struct span_scene *slow = draw_tested(format, seed * 7919, true);

		drawn += span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	assert_true(drawn > RANDOM_CASES(100000));
}

/* A random triangle without a texture, most of them up to 40 pixels wide. */
static void draw_shrunk(const struct gl *gl, uint32_t *seed)
{
	struct span_corner corner[3];

	memcpy(corner, span_make_triangle(seed), sizeof(corner));
	for (int i = 0; i < 6; i++) {
		float *at = &corner[1 + i / 3].position[i % 3];
		const float first = corner[0].position[i % 3];

		*at = first + (*at - first) / 8;
	}
	span_scene_draw(gl, corner, 3);
}

static struct span_scene *draw_small(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	give_buffers(scene, &seed);
	give_fragments(gl, &seed);
	if (random_one_in(&seed, 3)) {
		const GLfixed factor = random_between(&seed, -200000, 200000);

		gl->Enable(GL_POLYGON_OFFSET_FILL);
		gl->PolygonOffsetx(
			factor, random_between(&seed, -99, 99) * 1000000);
	}
	for (int i = 0; i < 20; i++) {
		draw_shrunk(gl, &seed);
	}
	return scene;
}

/* Small triangles, which have a set-up of their own, in any state. */
static void test_small_triangles_are_those_of_fragments(void **state)
{
	int drawn = 0, small = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= RANDOM_CASES(900); seed++) {
		enum pixel_format format =
			seed % 2 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast = draw_small(format, seed * 7919, false);
		struct span_scene *slow = draw_small(format, seed * 7919, true);

		small += fast->soft->draw->spans.small_size > 0;
		drawn += span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	assert_true(small > RANDOM_CASES(700));
	assert_true(drawn > RANDOM_CASES(200000));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_spans_of_565_are_those_of_fragments),
		cmocka_unit_test(test_spans_of_8888_are_those_of_fragments),
		cmocka_unit_test(test_a_small_triangle_leaves_the_next_its_level),
		cmocka_unit_test(test_added_colours_are_those_of_fragments),
		cmocka_unit_test(test_heaps_of_triangles_are_those_of_fragments),
		cmocka_unit_test(test_tests_are_those_of_fragments),
		cmocka_unit_test(test_small_triangles_are_those_of_fragments),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
