#include "tests/support/gl/soft_scene.h"

#include "tests/support/random.h"
#include "tests/support/soft/reference.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

struct soft_scene *soft_scene_open(void)
{
	const struct log log = {0};
	struct soft_scene *scene = calloc(1, sizeof(*scene));

	assert_non_null(scene);
	memset(scene->above, 0xA5, sizeof(scene->above));
	memset(scene->below, 0xA5, sizeof(scene->below));
	scene->picture = (struct pixels){
		.width = SOFT_SCENE_WIDTH,
		.height = SOFT_SCENE_HEIGHT,
		.stride_bytes = SOFT_SCENE_WIDTH * 2,
		.format = PIXELS_RGB565,
		.data = (uint8_t *)scene->pixel,
	};
	assert_int_equal(gl_open("soft",
				 &(struct gl_request){
					 .format = PIXELS_RGB565, .log = &log},
				 &scene->context),
		0);
	scene->gl = &scene->context->gl;
	scene->soft = (struct soft *)scene->context;
	soft_scene_use(scene, false);
	return scene;
}

void soft_scene_use(struct soft_scene *scene, bool long_way)
{
	assert_int_equal(scene->context->driver->begin_frame(
				 scene->context, &scene->picture),
		0);
	reference_use(scene->soft, long_way);
}

void soft_scene_close(struct soft_scene *scene)
{
	scene->context->driver->end_frame(scene->context);
	scene->context->driver->destroy(scene->context);
	for (int i = 0; i < SOFT_SCENE_GUARD; i++) {
		assert_int_equal(scene->above[i], 0xA5A5);
		assert_int_equal(scene->below[i], 0xA5A5);
	}
	free(scene);
}

static float around(float middle, uint32_t *seed, int range, float per_unit)
{
	return middle + (float)random_between(seed, -range, range) / per_unit;
}

void soft_scene_scatter(struct soft_corner *corner, int triangles,
	uint32_t *seed, int reach, int size, float flatten)
{
	for (int i = 0; i < 3 * triangles; i++) {
		const float *first = corner[i / 3 * 3].position;
		struct soft_corner *c = &corner[i];
		bool begins = i % 3 == 0;

		for (int k = 0; k < 3; k++) {
			c->position[k] =
				around(begins || k == 2 ? 0.0f : first[k], seed,
					begins ? reach : size,
					k == 2 ? 1000.0f * flatten : 1000.0f);
			c->color[k] = (uint8_t)random_between(seed, 0, 255);
		}
		c->color[3] = 255;
	}
}

int soft_scene_steps(uint16_t a, uint16_t b)
{
	int red = abs((a >> 11) - (b >> 11));
	int green = (abs((a >> 5 & 63) - (b >> 5 & 63)) + 1) / 2;
	int blue = abs((a & 31) - (b & 31));
	int most = red > green ? red : green;

	return most > blue ? most : blue;
}
