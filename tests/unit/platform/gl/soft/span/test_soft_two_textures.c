/*
 * Span functions that read two textures against the reference: random textures,
 * sizes and places. Coverage and depth are equal, colours within a step of RGB565.
 */
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/random.h"
#include "tests/support/soft/span_random.h"
#include "tests/support/test.h"

/* The second texture's to the first one's, whose alpha stays. */
static void add_texture(const struct gl *gl, uint32_t *seed)
{
	const bool swapped = random_one_in(seed, 2);

	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
		random_one_in(seed, 3) ? GL_ADD : GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
	gl->TexEnvx(GL_TEXTURE_ENV, swapped ? GL_SRC1_RGB : GL_SRC0_RGB,
		GL_PREVIOUS);
	gl->TexEnvx(GL_TEXTURE_ENV, swapped ? GL_SRC0_RGB : GL_SRC1_RGB,
		GL_TEXTURE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
}

/* Opaque, alpha-tested or blended by alpha. */
static void give_alpha(const struct gl *gl, uint32_t *seed)
{
	switch (random_between(seed, 0, 2)) {
	case 1:
		gl->Enable(GL_ALPHA_TEST);
		gl->AlphaFuncx(GL_GEQUAL, random_between(seed, 0, 65536));
		break;
	case 2:
		gl->Enable(GL_BLEND);
		gl->BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
		break;
	default:
		break;
	}
}

static struct span_scene *draw_pair(
	enum pixel_format format, uint32_t seed, bool reference)
{
	static const GLenum modes[] = {GL_MODULATE, GL_MODULATE, GL_REPLACE};
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;

	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(seed % 2 ? GL_LESS : GL_LEQUAL);
	gl->DepthMask(!random_one_in(&seed, 4));
	for (GLenum unit = 0; unit < 2; unit++) {
		gl->ActiveTexture(GL_TEXTURE0 + unit);
		span_give_texture(gl, &seed);
		gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
			unit == 0 ? (GLfixed)span_one_of(&seed, modes, 3)
				  : GL_MODULATE);
	}
	if (random_one_in(&seed, 2)) {
		add_texture(gl, &seed);
	}
	give_alpha(gl, &seed);
	span_scene_draw(gl, span_make_triangle(&seed), 3);
	return scene;
}

/* Two textures of the same size and sampling, with the same coordinates. */
static struct span_scene *draw_joined(
	enum pixel_format format, uint32_t seed, bool reference)
{
	struct span_scene *scene = span_begin_in_perspective(format, reference);
	const struct gl *gl = scene->gl;
	uint32_t first = seed, second = seed;
	GLenum mode = random_one_in(&seed, 3) ? GL_REPLACE : GL_MODULATE;
	const bool wide = format == PIXELS_RGBA8888;
	const int kind = random_between(&seed, 0, 1);

	gl->Enable(GL_DEPTH_TEST);
	gl->DepthFunc(seed % 2 ? GL_LESS : GL_LEQUAL);
	gl->DepthMask(!random_one_in(&seed, 4));
	span_give_texels(gl, &first, wide ? 3 : kind, 0);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, (GLfixed)mode);
	gl->ActiveTexture(GL_TEXTURE1);
	span_give_texels(gl, &second, wide ? 3 : 0, 0x5A);
	if (random_one_in(&seed, 2)) {
		add_texture(gl, &seed);
		give_alpha(gl, &seed);
	}
	span_scene_draw_joined(gl, span_make_triangle(&seed), 3);
	return scene;
}

/* Checks that each finish with a second texture was drawn often. */
static void check_finishes(const int read[SOFT_FINISHES])
{
	assert_true(read[SOFT_SCALED] > 20);
	for (int finish = SOFT_OPAQUE; finish <= SOFT_BLENDED; finish++) {
		assert_true(read[SOFT_SUMMED + finish] > 20);
	}
}

/* Two textures that multiply each other and the colours, or whose sum is drawn. */
static void test_two_textures_are_those_of_fragments(void **state)
{
	int read[SOFT_FINISHES] = {0}, multiplied = 0, listed = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= 600; seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast = draw_pair(format, seed * 7919, false);
		struct span_scene *slow = draw_pair(format, seed * 7919, true);

		multiplied += fast->soft->draw->spans.multiplied;
		read[fast->soft->draw->spans.finish]++;
		listed += fast->soft->draw->raster.top == RASTER_LISTED;
		span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	check_finishes(read);
	assert_true(multiplied > 40);
	assert_true(listed > 100);
}

static void test_joined_textures_are_those_of_fragments(void **state)
{
	int read[SOFT_FINISHES] = {0}, joined[2] = {0}, drawn = 0;

	(void)state;
	for (uint32_t seed = 1; seed <= 600; seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *fast =
			draw_joined(format, seed * 7919, false);
		struct span_scene *slow = draw_joined(format, seed * 7919, true);

		joined[seed % 3 == 0] += fast->soft->draw->spans.joined;
		assert_int_equal(
			(fast->soft->draw->attributes >> (TEX_S + 2) & 3) != 0,
			!fast->soft->draw->spans.joined);
		read[fast->soft->draw->spans.finish]++;
		drawn += span_scene_compare(fast, slow, seed);
		span_scene_close(fast);
		span_scene_close(slow);
	}
	check_finishes(read);
	assert_true(joined[0] > 160 && joined[1] > 40);
	assert_true(drawn > 15000);
}

/* A texture, and on the second unit none, or one that is white everywhere. */
static struct span_scene *draw_white(
	enum pixel_format format, uint32_t seed, bool white)
{
	static const uint8_t texels[4 * 4] = {255, 255, 255, 255, 255, 255, 255,
		255, 255, 255, 255, 255, 255, 255, 255, 255};
	struct span_scene *scene = span_begin_in_perspective(format, false);
	const struct gl *gl = scene->gl;
	GLuint name;

	span_give_texture(gl, &seed);
	gl->ActiveTexture(GL_TEXTURE1);
	if (white) {
		gl->GenTextures(1, &name);
		gl->BindTexture(GL_TEXTURE_2D, name);
		gl->TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA, 2, 2, 0, GL_RGBA,
			GL_UNSIGNED_BYTE, texels);
		gl->TexParameterx(
			GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
		gl->Enable(GL_TEXTURE_2D);
	}
	span_scene_draw(gl, span_make_triangle(&seed), 3);
	return scene;
}

/* The coordinates of the first unit stay what they are beside the second's. */
static void test_a_white_second_texture_changes_nothing(void **state)
{
	(void)state;
	for (uint32_t seed = 1; seed <= 60; seed++) {
		enum pixel_format format =
			seed % 3 ? PIXELS_RGB565 : PIXELS_RGBA8888;
		struct span_scene *one = draw_white(format, seed * 7919, false);
		struct span_scene *two = draw_white(format, seed * 7919, true);

		span_scene_compare(one, two, seed);
		span_scene_close(one);
		span_scene_close(two);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_two_textures_are_those_of_fragments),
		cmocka_unit_test(test_joined_textures_are_those_of_fragments),
		cmocka_unit_test(test_a_white_second_texture_changes_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
