/* The soft driver's short cut for relief's three passes: against the long way. */
#include "platform/base/fixed.h"
#include "platform/gl/soft/draw.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

enum {
	WIDTH = 96,
	HEIGHT = 80,
	TRIANGLES = 24,
	CORNERS = TRIANGLES * 3,
	SIDE = 32, /* of the textures */
};

static uint32_t next_random(uint32_t *seed)
{
	*seed = *seed * 1664525u + 1013904223u;
	return *seed >> 8;
}

static int random_between(uint32_t *seed, int low, int high)
{
	return low + (int)(next_random(seed) % (uint32_t)(high - low + 1));
}

struct corner {
	float position[3];
	uint8_t light[4], color[4];
	float texcoord[2];
};

struct scene {
	struct gl_context *context;
	const struct gl *gl;
	struct soft *soft;
	uint16_t pixel[WIDTH * HEIGHT];
	struct pixels picture;
	GLuint texture[2]; /* normals, colours */
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

/* The alpha test that all pass sends fragments the long way. */
static struct scene *open_scene(bool long_way)
{
	const struct log log = {0};
	struct scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	scene->picture = (struct pixels){
		.width = WIDTH,
		.height = HEIGHT,
		.stride_bytes = WIDTH * 2,
		.format = PIXELS_RGB565,
		.data = (uint8_t *)scene->pixel,
	};
	assert_int_equal(
		gl_open("soft", PIXELS_RGB565, &log, &scene->context), 0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	scene->gl->PixelStorei(GL_UNPACK_ALIGNMENT, 1);
	scene->gl->GenTextures(2, scene->texture);
	for (int i = 0; i < 2; i++) {
		scene->gl->BindTexture(GL_TEXTURE_2D, scene->texture[i]);
		make_texture(scene->gl, i == 0);
	}
	if (long_way) {
		scene->gl->Enable(GL_ALPHA_TEST);
		scene->gl->AlphaFuncx(GL_ALWAYS, 0);
	}
	return scene;
}

static void close_scene(struct scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	free(scene);
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

static void draw_corners(struct scene *scene, const struct corner *corner,
	const uint8_t *color, int texture)
{
	const struct gl *gl = scene->gl;
	const GLsizei stride = sizeof(*corner);

	gl->BindTexture(GL_TEXTURE_2D, scene->texture[texture]);
	gl->VertexPointer(3, GL_FLOAT, stride, corner->position);
	gl->TexCoordPointer(2, GL_FLOAT, stride, corner->texcoord);
	gl->ColorPointer(4, GL_UNSIGNED_BYTE, stride, color);
	gl->DrawArrays(GL_TRIANGLES, 0, CORNERS);
}

/* As app/scene/bump.c has them; passes up to so many. */
static void draw(struct scene *scene, const struct corner *corner, int passes)
{
	const struct gl *gl = scene->gl;

	/* Calls of GL go to the context whose frame began last. */
	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	gl->Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
	gl->Enable(GL_DEPTH_TEST);
	gl->Enable(GL_TEXTURE_2D);
	gl->EnableClientState(GL_VERTEX_ARRAY);
	gl->EnableClientState(GL_COLOR_ARRAY);
	gl->EnableClientState(GL_TEXTURE_COORD_ARRAY);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_COMBINE);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_COMBINE_RGB, GL_DOT3_RGB);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_SRC1_RGB, GL_PRIMARY_COLOR);
	draw_corners(scene, corner, corner->light, 0);
	gl->TexEnvx(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, GL_MODULATE);
	gl->DepthFunc(GL_EQUAL);
	gl->DepthMask(GL_FALSE);
	gl->Enable(GL_BLEND);
	gl->BlendFunc(GL_DST_COLOR, GL_ZERO);
	if (passes > 1) {
		draw_corners(scene, corner, corner->color, 1);
	}
	gl->BlendFunc(GL_ONE, GL_ONE);
	if (passes > 2) {
		draw_corners(scene, corner, corner->light, 1);
	}
}

/* In steps of 32. */
static int differ_most(uint16_t a, uint16_t b)
{
	int red = abs((a >> 11) - (b >> 11));
	int green = (abs((a >> 5 & 63) - (b >> 5 & 63)) + 1) / 2;
	int blue = abs((a & 31) - (b & 31));
	int most = red > green ? red : green;

	return most > blue ? most : blue;
}

/* Depth is the same. Colours are within a step, which passes may add up. */
static void check_passes(int passes)
{
	static const int sizes[] = {60, 200, 700, 2500};
	struct corner corner[CORNERS];
	int seen = 0, other = 0;

	for (uint32_t seed = 1; seed <= 40; seed++) {
		struct scene *quick = open_scene(false);
		struct scene *slow = open_scene(true);

		make_triangles(corner, seed, sizes[seed % 4]);
		draw(quick, corner, passes);
		draw(slow, corner, passes);
		assert_ptr_not_equal(quick->soft->draw->span, soft_draw_span);
		assert_ptr_equal(slow->soft->draw->span, soft_draw_span);
		assert_memory_equal(quick->soft->buffers.depth,
			slow->soft->buffers.depth, WIDTH * HEIGHT * 2);
		for (int i = 0; i < WIDTH * HEIGHT; i++) {
			int step = differ_most(quick->pixel[i], slow->pixel[i]);

			assert_true(step <= 2);
			seen += slow->pixel[i] != 0;
			other += step > 1;
		}
		close_scene(quick);
		close_scene(slow);
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
