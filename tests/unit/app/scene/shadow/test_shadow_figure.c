/* Shadows of a figure that stands anywhere in the scene, on its own ground. */
#include "app/anim/math/vec.h"
#include "app/scene/instance/lod.h"
#include "app/scene/shadow/shadow_figure.h"
#include "app/scene/stage/light.h"
#include "tests/support/gl/gl_recorder.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <math.h>

enum {
	LAWN
};

struct scene {
	struct model *model;
	struct instance *instance;
	struct shadow_ground ground;
	struct shadow_figure *figure;
	struct stage stage;
	mat4 place;
};

static void begin(struct scene *scene, bool uneven)
{
	struct log nowhere = log_to_nowhere();
	float(*lawn)[3];

	*scene = (struct scene){
		.stage = {.has_stencil = true, .camera = camera_default()}};
	scene->model = model_fixture("gltf/scene/ground.gltf", NULL);
	lawn = scene->model->mesh[LAWN].primitive->position;
	if (uneven) {
		lawn[0][1] = 0.1f;
		lawn[3][1] = 0.15f;
	}
	scene->instance = small_model_instance(scene->model);
	assert_int_equal(shadow_ground_find(&scene->ground, scene->instance), 0);
	assert_int_equal(shadow_figure_create(scene->instance, &scene->ground,
				 &nowhere, &scene->figure),
		0);
	assert_non_null(scene->figure);
	/* Turned about the vertical, and away from the middle. */
	glm_mat4_identity(scene->place);
	scene->place[0][0] = scene->place[2][2] = 0.6f;
	scene->place[0][2] = -0.8f;
	scene->place[2][0] = 0.8f;
	scene->place[3][0] = 0.5f;
	scene->place[3][1] = 0.25f;
	scene->place[3][2] = -1;
	instance_update(scene->instance);
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

/* In the scene, a direction of the figure's own or a point (w = 1). */
static void to_scene(
	const struct scene *scene, const float from[3], float w, float out[3])
{
	for (int axis = 0; axis < 3; axis++) {
		out[axis] = scene->place[0][axis] * from[0] +
			scene->place[1][axis] * from[1] +
			scene->place[2][axis] * from[2] +
			scene->place[3][axis] * w;
	}
}

/* How near two lines come to each other. */
static float distance_of(const float a[3], const float a_way[3],
	const float b[3], const float b_way[3])
{
	float across[3], between[3];

	vec_cross(a_way, b_way, across);
	vec_subtract(b, a, between);
	return fabsf(vec_dot(between, across)) / vec_length(across);
}

/*
 * A point of the shadow is seen where the light through the figure's point
 * meets the ground: the line from the eye through it meets the light's.
 */
static void test_a_shadow_falls_along_the_scenes_light(void **state)
{
	struct scene scene;
	float light[3], eye[3];
	int points = 0;

	(void)state;
	begin(&scene, true);
	shadow_figure_lay(
		scene.figure, &scene.stage, 640, scene.instance, scene.place);
	light_direction(light);
	camera_eye(&scene.stage.camera, eye);
	for (int i = 0; i < scene.figure->drape.sheet_count; i++) {
		const struct shadow_sheet *sheet = &scene.figure->drape.sheet[i];

		for (int v = 0; v < sheet->vertex_count; v++) {
			float posed[3], laid[3], from_eye[3], fall[3];

			to_scene(&scene, sheet->posed[v], 1, posed);
			to_scene(&scene, sheet->position[v], 1, laid);
			vec_subtract(laid, eye, from_eye);
			assert_near(distance_of(posed, light, eye, from_eye), 0,
				2e-3);
			vec_subtract(posed, laid, fall);
			assert_true(vec_dot(fall, light) > 0);
			points++;
		}
	}
	assert_true(points > 6);
	/* The ground casts none, and is shown again. */
	assert_int_equal(scene.figure->drape.sheet[LAWN].index_count, 0);
	assert_false(scene.instance->drawable[LAWN].hidden);
	end(&scene);
}

/* Edges of up to 8 pixels, at the eye's distance from the figure's middle. */
static void test_edges_of_few_pixels_are_not_divided(void **state)
{
	static const int heights[] = {0, 60, 640, 6400};
	struct scene scene;
	float eye[3], away[3], least;

	(void)state;
	begin(&scene, true);
	least = scene.figure->longest;
	camera_eye(&scene.stage.camera, eye);
	vec_subtract(eye, scene.place[3], away);
	for (int i = 0; i < 4; i++) {
		float wanted = least;

		if (heights[i] > 0) {
			wanted = fmaxf(least,
				8 /
					lod_px_per_unit_at(&scene.stage.camera,
						vec_length(away), heights[i]));
		}
		assert_true(i != 1 || wanted > least);
		shadow_figure_lay(scene.figure, &scene.stage, heights[i],
			scene.instance, scene.place);
		assert_near(scene.figure->drape.longest, wanted,
			1e-3 * (double)wanted);
	}
	end(&scene);
}

static int count_draws(struct scene *scene, const struct shadow_figure *figure)
{
	const struct texture_set textures = {0};
	struct gl gl = gl_recorder_begin();

	shadow_figure_draw(figure, &scene->stage, &gl, scene->instance,
		&textures, scene->place);
	shadow_figure_end(figure, scene->instance);
	for (int i = 0; i < scene->instance->drawable_count; i++) {
		assert_false(scene->instance->drawable[i].hidden);
	}
	assert_int_equal(gl_recorder_result()->depth, 0);
	return gl_recorder_result()->draw_count;
}

/* The lawn has two sides, the plate and the lamp above them one. */
static void test_ground_is_drawn_before_what_falls_on_it(void **state)
{
	struct scene scene;

	(void)state;
	for (int uneven = 0; uneven < 2; uneven++) {
		begin(&scene, uneven);
		shadow_figure_lay(scene.figure, &scene.stage, 640,
			scene.instance, scene.place);
		assert_int_equal(count_draws(&scene, scene.figure), 4);
		assert_int_equal(count_draws(&scene, NULL), 0);
		scene.stage.has_stencil = false;
		assert_int_equal(count_draws(&scene, scene.figure), 0);
		end(&scene);
	}
}

static void test_a_model_without_ground_has_no_such_shadow(void **state)
{
	const struct shadow_ground none = {.count = 0};
	struct model *model = small_model_grid(1, 1, 1, true);
	struct instance *instance = small_model_instance(model);
	struct log nowhere = log_to_nowhere();
	struct shadow_figure some, *figure = &some;

	(void)state;
	assert_int_equal(
		shadow_figure_create(instance, &none, &nowhere, &figure), 0);
	assert_null(figure);
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_shadow_falls_along_the_scenes_light),
		cmocka_unit_test(test_edges_of_few_pixels_are_not_divided),
		cmocka_unit_test(test_ground_is_drawn_before_what_falls_on_it),
		cmocka_unit_test(test_a_model_without_ground_has_no_such_shadow),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
