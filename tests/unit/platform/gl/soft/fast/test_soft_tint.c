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
	LEVELS = 7, /* of the textures, 64 texels wide */
};

/* Waves as high and as far apart as rounding in bands cannot show. */
static uint8_t wave(int at, int width)
{
	int down = at * 64 / width % 64;

	return (uint8_t)(40 + 5 * (down < 32 ? down : 63 - down));
}

/* Each level of another blue, so that a wrong one shows. */
static void make_texture(
	const struct gl *gl, GLint min, GLint mag, int height_part)
{
	uint8_t texels[64 * 64 * 3];
	GLuint name;

	gl->GenTextures(1, &name);
	gl->BindTexture(GL_TEXTURE_2D, name);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, min);
	gl->TexParameterx(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, mag);
	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	for (int level = 0; level < LEVELS; level++) {
		int width = 64 >> level, height = width / height_part;

		height = height > 0 ? height : 1;
		for (int i = 0; i < width * height; i++) {
			texels[3 * i] = wave(i % width, width);
			texels[3 * i + 1] = wave(i / width, height);
			texels[3 * i + 2] = (uint8_t)(255 - 40 * level);
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_RGB, width, height, 0,
			GL_RGB, GL_UNSIGNED_BYTE, texels);
	}
}

static struct soft_scene *open_scene(GLint min, GLint mag, int height_part)
{
	struct soft_scene *scene = soft_scene_open();

	scene->gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	make_texture(scene->gl, min, mag, height_part);
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
	bool long_way)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	soft_scene_use(scene, long_way);
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

static struct figures compare_ways(GLint min, GLint mag, int height_part)
{
	struct figures figures = {0};

	for (uint32_t round = 1; round <= 40; round++) {
		struct soft_scene *fast_setup =
			open_scene(min, mag, height_part);
		struct soft_scene *slow = open_scene(min, mag, height_part);
		struct soft_corner corner[CORNERS];
		uint32_t seed = round;

		make_triangles(corner, &seed, 30 + (int)round * 6);
		draw(fast_setup, corner, false);
		draw(slow, corner, true);
		add_difference(&figures, fast_setup, slow);
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
	assert_true(figures.seen > 10000);
	return figures;
}

static void test_mixed_texels_are_those_of_the_long_way(void **state)
{
	struct figures figures = compare_ways(GL_LINEAR, GL_LINEAR, 1);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_levels_are_those_of_the_long_way(void **state)
{
	struct figures figures =
		compare_ways(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 1);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_levels_that_are_no_squares_are_too(void **state)
{
	struct figures figures =
		compare_ways(GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 4);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
}

static void test_nearest_texels_are_those_of_the_long_way(void **state)
{
	struct figures figures = compare_ways(GL_NEAREST, GL_NEAREST, 1);

	(void)state;
	assert_true(figures.other * 1000 < figures.seen);
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
				GL_LINEAR_MIPMAP_NEAREST, GL_LINEAR, 2);
			for (uint32_t pass = 0; pass <= round % 3; pass++) {
				set_pass(scene[k]->gl, (int)pass);
				draw(scene[k], corner, k == 1);
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
		cmocka_unit_test(test_levels_are_those_of_the_long_way),
		cmocka_unit_test(test_levels_that_are_no_squares_are_too),
		cmocka_unit_test(test_nearest_texels_are_those_of_the_long_way),
		cmocka_unit_test(test_relief_is_that_of_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
