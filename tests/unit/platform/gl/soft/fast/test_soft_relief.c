/* The soft driver's short cut for relief's three passes: against the long way. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/raster/raster.h"
#include "tests/support/gl/soft_scene.h"
#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	TRIANGLES = 24,
	CORNERS = TRIANGLES * 3,
	SIDE = 32, /* of the textures */
};

struct corner {
	float position[3];
	uint8_t light[4], color[4];
	float texcoord[2];
};

/* Texels near the middle, as normals are, or of any colour; all levels. */
static void make_texture(const struct gl *gl, bool normals)
{
	static uint8_t texel[SIDE * SIDE][3];
	uint32_t seed = 5 + normals;

	for (int level = 0, side = SIDE; side; level++, side /= 2) {
		for (int i = 0; i < side * side; i++) {
			for (int k = 0; k < 3; k++) {
				texel[i][k] = (uint8_t)(normals && k < 2
						? random_between(&seed, 90, 160)
						: random_between(
							  &seed, 150, 255));
			}
		}
		gl->TexImage2D(GL_TEXTURE_2D, level, GL_RGB, side, side, 0,
			GL_RGB, GL_UNSIGNED_BYTE, texel);
	}
	gl->TexParameterx(
		GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
}

/* A scene with both textures. */
static struct soft_scene *open_scene(GLuint texture[2])
{
	struct soft_scene *scene = soft_scene_open();
	const struct gl *gl = scene->gl;

	gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	gl->GenTextures(2, texture);
	for (int i = 0; i < 2; i++) {
		gl->BindTexture(GL_TEXTURE_2D, texture[i]);
		make_texture(gl, i == 0);
	}
	return scene;
}

/* Apart from one another, so that each pass adds to the same ones. */
static void make_triangles(struct corner *corner, uint32_t seed, int size)
{
	for (int i = 0; i < CORNERS; i++) {
		struct corner *c = &corner[i];
		int range = i % 3 ? size : 1000;

		for (int axis = 0; axis < 2; axis++) {
			c->position[axis] =
				(i % 3 ? corner[i / 3 * 3].position[axis]
				       : 0.0f) +
				(float)random_between(&seed, -range, range) /
					1000.0f;
			c->texcoord[axis] =
				(float)random_between(&seed, -100, 100) / 200.0f;
		}
		c->position[2] =
			(float)random_between(&seed, -900, 900) / 1000.0f;
		for (int k = 0; k < 4; k++) {
			c->light[k] = (uint8_t)random_between(&seed, 40, 255);
			c->color[k] = (uint8_t)random_between(&seed, 0, 255);
		}
	}
}

static void draw_corners(struct soft_scene *scene, const struct corner *corner,
	const uint8_t *color, GLuint texture)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	gl->BindTexture(GL_TEXTURE_2D, texture);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, color);
	gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

/* As app/scene/draw/bump.c has them; passes up to so many. */
static void draw(struct soft_scene *scene, const GLuint texture[2],
	const struct corner *corner, int passes, bool long_way)
{
	const struct gl *gl = scene->gl;

	soft_scene_use(scene, long_way);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_TEXTURE_2D);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
	draw_corners(scene, corner, corner->light, texture[0]);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->DepthFunc(GL_EQUAL);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_DST_COLOR, GL_ZERO);
	if (passes > 1) {
		draw_corners(scene, corner, corner->color, texture[1]);
	}
	gl->BlendFunc(GL_ONE, GL_ONE);
	if (passes > 2) {
		draw_corners(scene, corner, corner->light, texture[1]);
	}
}

/* Depth is the same. Colours are within a step, which passes may add up. */
static void check_passes(int passes)
{
	static const int sizes[] = {60, 200, 700, 2500};
	struct corner corner[CORNERS];
	int seen = 0, other = 0;

	for (uint32_t seed = 1; seed <= 40; seed++) {
		GLuint name[2][2];
		struct soft_scene *fast_setup = open_scene(name[0]);
		struct soft_scene *slow = open_scene(name[1]);

		make_triangles(corner, seed, sizes[seed % 4]);
		draw(fast_setup, name[0], corner, passes, false);
		draw(slow, name[1], corner, passes, true);
		assert_ptr_equal(fast_setup->soft->draw->fill, soft_rows_fill);
		assert_ptr_equal(slow->soft->draw->fill, reference_fill);
		assert_memory_equal(fast_setup->soft->buffers.depth,
			slow->soft->buffers.depth, SOFT_SCENE_PIXELS * 2);
		for (int i = 0; i < SOFT_SCENE_PIXELS; i++) {
			int step = soft_scene_steps(
				fast_setup->pixel[i], slow->pixel[i]);

			assert_true(step <= 2);
			seen += slow->pixel[i] != 0;
			other += step > 1;
		}
		soft_scene_close(fast_setup);
		soft_scene_close(slow);
	}
	assert_true(seen > 20000);
	assert_true(other * 100 < seen);
}

static void test_light_falls_as_on_the_long_way(void **state)
{
	(void)state;
	check_passes(1);
}

static void test_tints_are_those_of_the_long_way(void **state)
{
	(void)state;
	check_passes(2);
}

static void test_the_rest_is_added_as_on_the_long_way(void **state)
{
	(void)state;
	check_passes(3);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_light_falls_as_on_the_long_way),
		cmocka_unit_test(test_tints_are_those_of_the_long_way),
		cmocka_unit_test(test_the_rest_is_added_as_on_the_long_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
