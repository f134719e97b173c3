/*
 * The soft driver's short cuts for coloured textures against the long way.
 */
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	TRIANGLES = 40,
	CORNERS = TRIANGLES * 3,
	WIDTH = 64, /* of the textures, unless a test says otherwise */
	WIDTH_MOST = 1024,
};

/* A texture: how high it is, of its width; see GL for the others. */
struct given {
	GLint min, mag;
	int width, height_part;
	GLint wrap;
};

/* Waves as high and as far apart as rounding in bands cannot show. */
static uint8_t wave(int at, int width)
{
	int down = at * 64 / width % 64;

	return (uint8_t)(40 + 5 * (down < 32 ? down : 63 - down));
}

/* Each level of another blue, so that a wrong one shows. */
static void make_level(
	const struct gl *gl, int level, int width, int height, bool fine)
{
	static uint8_t texels[WIDTH_MOST * WIDTH_MOST * 3];

	for (int i = 0; i < width * height; i++) {
		int x = i % width, y = i / width;

		texels[3 * i] = wave(x, fine ? 80 : width);
		texels[3 * i + 1] = wave(y, fine ? 80 : height);
		texels[3 * i + 2] = (uint8_t)(255 - 25 * level);
	}
	gl->TexImage2D(GL_TEXTURE_2D, level, GL_RGB, width, height, 0, GL_RGB,
		GL_UNSIGNED_BYTE, texels);
}

static void make_texture(const struct gl *gl, const struct given *given)
{
	const bool fine = given->width > WIDTH;
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, given->min);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, given->mag);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, given->wrap);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, given->wrap);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	for (int level = 0; given->width >> level > 0; level++) {
		int width = given->width >> level;
		int height = width / given->height_part;

		make_level(gl, level, width, height > 0 ? height : 1, fine);
	}
}

/* The colour of the second unit on top: a texture as it is, and more. */
static void add_color(const struct gl *gl)
{
	static const GLfixed color[4] = {30000, 4000, 15000, 0};

	gl->ActiveTexture(GL_TEXTURE1);
	make_texture(
		gl, &(struct given){GL_NEAREST, GL_NEAREST, 1, 1, GL_REPEAT});
	gl->Enable(GL_TEXTURE_2D);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_ADD);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_RGB, GL_PREVIOUS);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_CONSTANT);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_ALPHA, GL_REPLACE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC0_ALPHA, GL_PREVIOUS);
	gl->TexEnvxv(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, color);
	gl->ActiveTexture(GL_TEXTURE0);
}

static struct soft_scene *open_scene(const struct given *given)
{
	struct soft_scene *scene = soft_scene_open();

	scene->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	make_texture(scene->gl, given);
	return scene;
}

static void make_triangles(struct soft_corner *corner, uint32_t *seed, int size)
{
	soft_scene_scatter(corner, TRIANGLES, seed, 900, size, 1.0f);
	for (int i = 0; i < CORNERS; i++) {
		for (int k = 0; k < 2; k++) {
			corner[i].texcoord[k] =
				(float)random_between(seed, -600, 600) / 500.0f;
		}
	}
}

static void draw(struct soft_scene *scene, const struct soft_corner *corner,
	bool long_way, bool added)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	soft_scene_use(scene, long_way);
	if (added) {
		add_color(gl);
	}
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_TEXTURE_2D);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, corner->color);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

struct figures {
	int seen, other;
};

static void add_difference(struct figures *figures,
	const struct soft_scene *fast_setup, const struct soft_scene *slow)
{
	const size_t size = sizeof(fast_setup->pixel);

	assert_memory_equal(fast_setup->soft->buffers.depth,
		slow->soft->buffers.depth, size);
	for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
		figures->seen += slow->pixel[i] != 0;
		figures->other += soft_scene_steps(fast_setup->pixel[i],
					  slow->pixel[i]) > 1;
	}
}

/* Triangles of up to 160 texels, anywhere in a texture and beyond its edges. */
static void use_few_texels(struct soft_corner *corner, uint32_t *seed, int width)
{
	for (int i = 0; i < CORNERS; i++) {
		for (int k = 0; k < 2; k++) {
			float *at = &corner[i].texcoord[k];

			*at = i % 3 == 0
				? (float)random_between(seed, -100, 1100) /
					1000.0f
				: corner[i - i % 3].texcoord[k] +
					(float)random_between(seed, -80, 80) /
						(float)width;
		}
	}
}

static void use_gray(struct soft_corner *corner)
{
	for (int i = 0; i < CORNERS; i++) {
		memset(corner[i].color, corner[i].color[0], 3);
	}
}

static struct figures compare_ways_of(
	struct given given, uint32_t rounds, bool added)
{
	struct figures figures = {0};

	rounds = RANDOM_CASES(rounds);
	for (uint32_t round = 1; round <= rounds; round++) {
		struct soft_scene *fast_setup = open_scene(&given);
		struct soft_scene *slow = open_scene(&given);
		struct soft_corner corner[CORNERS];
		uint32_t seed = round;

		make_triangles(corner, &seed, 30 + (int)(round * 240 / rounds));
		if (given.width > WIDTH || given.wrap != GL_REPEAT) {
			use_few_texels(corner, &seed, given.width);
		}
		if (given.mag == GL_NEAREST && round % 2 == 0) {
			use_gray(corner);
		}
		draw(fast_setup, corner, false, added);
		draw(slow, corner, true, added);
		add_difference(&figures, fast_setup, slow);
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
	assert_true(figures.seen > (int)rounds * 250);
	return figures;
}

static struct figures compare_ways(struct given given, uint32_t rounds)
{
	return compare_ways_of(given, rounds, false);
}

static void test_mixed_texels_are_those_of_the_long_way(void **state)
{
	struct figures figures = compare_ways(
		(struct given){GL_LINEAR, GL_LINEAR, WIDTH, 1, GL_REPEAT}, 40);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_colours_are_added_as_on_the_long_way(void **state)
{
	struct figures figures = compare_ways_of(
		(struct given){GL_LINEAR, GL_LINEAR, WIDTH, 1, GL_REPEAT}, 40,
		true);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_levels_are_those_of_the_long_way(void **state)
{
	struct figures figures =
		compare_ways((struct given){GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR,
				     WIDTH, 1, GL_REPEAT},
			40);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_levels_that_are_no_squares_are_too(void **state)
{
	struct figures figures =
		compare_ways((struct given){GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR,
				     WIDTH, 4, GL_REPEAT},
			40);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_nearest_texels_are_those_of_the_long_way(void **state)
{
	struct figures figures = compare_ways(
		(struct given){GL_NEAREST, GL_NEAREST, WIDTH, 1, GL_REPEAT}, 40);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

/* Bands reach 256 texels and never the last one of a clamped texture. */
static void test_parts_of_textures_are_those_of_the_long_way(void **state)
{
	static const struct given given[] = {
		{GL_LINEAR, GL_LINEAR, 1024, 1, GL_REPEAT},
		{GL_LINEAR, GL_LINEAR, 512, 2, GL_CLAMP_TO_EDGE},
		{GL_LINEAR, GL_LINEAR, 64, 1, GL_CLAMP_TO_EDGE},
		{GL_LINEAR, GL_LINEAR, 256, 4, GL_CLAMP_TO_EDGE},
		{GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 1024, 2, GL_REPEAT},
		{GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 128, 1, GL_CLAMP_TO_EDGE},
		{GL_NEAREST, GL_NEAREST, 512, 1, GL_REPEAT},
		{GL_NEAREST, GL_NEAREST, 64, 1, GL_CLAMP_TO_EDGE},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(given) / sizeof(given[0]); i++) {
		struct figures figures = compare_ways(given[i], 10);

		assert_true(figures.other * 1000 < figures.seen);
	}
}

/* What bump.c draws relief with, one pass over the other. */
static void set_pass(const struct gl *gl, int pass)
{
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE,
		pass == 0 ? GL_COMBINE : GL_MODULATE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
	gl->DepthFunc(pass == 0 ? GL_LESS : GL_EQUAL);
	gl->DepthMask(pass == 0);
	(pass == 0 ? gl->Disable : gl->Enable)(GL_BLEND);
	if (pass == 1) {
		gl->BlendFunc(GL_DST_COLOR, GL_ZERO);
	} else {
		gl->BlendFunc(GL_ONE, GL_ONE);
	}
}

static void test_relief_is_that_of_the_long_way(void **state)
{
	struct figures figures = {0};

	(void)state;
	for (uint32_t round = 1; round <= 60; round++) {
		struct soft_scene *scene[2];
		struct soft_corner corner[CORNERS];
		uint32_t seed = round;

		make_triangles(corner, &seed, 30 + (int)round * 4);
		for (int k = 0; k < 2; k++) {
			scene[k] = open_scene(
				&(struct given){GL_LINEAR_MIPMAP_NEAREST,
					GL_LINEAR, WIDTH, 2, GL_REPEAT});
			for (uint32_t pass = 0; pass <= round % 3; pass++) {
				set_pass(scene[k]->gl, (int)pass);
				draw(scene[k], corner, k == 1, false);
			}
		}
		add_difference(&figures, scene[0], scene[1]);
		soft_scene_close(scene[0]);
		soft_scene_close(scene[1]);
	}
	assert_true(figures.seen > 5000);
	assert_true(figures.other * 200 < figures.seen);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_mixed_texels_are_those_of_the_long_way),
		cmocka_unit_test(test_colours_are_added_as_on_the_long_way),
		cmocka_unit_test(test_levels_are_those_of_the_long_way),
		cmocka_unit_test(test_levels_that_are_no_squares_are_too),
		cmocka_unit_test(test_nearest_texels_are_those_of_the_long_way),
		cmocka_unit_test(
			test_parts_of_textures_are_those_of_the_long_way),
		cmocka_unit_test(test_relief_is_that_of_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
