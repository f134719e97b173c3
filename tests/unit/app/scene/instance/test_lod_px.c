/*
 * How many pixels a unit has where a figure is nearest to the eye, against the
 * depths of all corners, and which lists a limit of pixels chooses.
 */
#include "app/scene/instance/lod.h"
#include "tests/support/model/small_model.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <math.h>

enum {
	HEIGHT = 640
};

static float between(uint32_t *seed, float low, float high)
{
	return low +
		(high - low) * (float)random_between(seed, 0, 1000) / 1000.0f;
}

static struct camera random_camera(uint32_t *seed)
{
	struct camera camera = camera_default();

	camera.distance = between(seed, 3, 9);
	camera.yaw_rad = between(seed, -3, 3);
	camera.pitch_rad = between(seed, 0.05f, 1.4f);
	for (int i = 0; i < 3; i++) {
		camera.target[i] = between(seed, -1, 1);
	}
	return camera;
}

/* Ahead of the eye, as the view's matrix has it. */
static double depth_of(const struct camera *camera, const float point[3])
{
	mat4 view;

	camera_view(camera, view);
	return -((double)view[0][2] * (double)point[0] +
		(double)view[1][2] * (double)point[1] +
		(double)view[2][2] * (double)point[2] + (double)view[3][2]);
}

/* Half the picture's height is the tangent of half the angle at depth 1. */
static double px_at(const struct camera *camera, double depth)
{
	return 0.5 * HEIGHT / (tan(0.5 * (double)camera->yfov_rad) * depth);
}

static void expect_px(float px, const struct camera *camera, double depth)
{
	double expected =
		px_at(camera, fmax(depth, 0.05 * (double)camera->distance));

	assert_near(px, expected, 1e-3 * expected);
}

static void test_pixels_go_with_the_depth_down_to_a_twentieth(void **state)
{
	struct camera camera = camera_default();

	(void)state;
	camera.distance = 4;
	expect_px(lod_px_per_unit_at(&camera, 3, HEIGHT), &camera, 3);
	expect_px(lod_px_per_unit_at(&camera, 0.21f, HEIGHT), &camera, 0.21);
	expect_px(lod_px_per_unit_at(&camera, 0.1f, HEIGHT), &camera, 0.2);
	expect_px(lod_px_per_unit_at(&camera, -5, HEIGHT), &camera, 0.2);
}

static void test_a_box_has_the_pixels_of_its_nearest_corner(void **state)
{
	uint32_t seed = 1;

	(void)state;
	for (int i = 0; i < 100; i++) {
		struct camera camera = random_camera(&seed);
		double nearest = 1e9;
		struct bounds box;

		for (int axis = 0; axis < 3; axis++) {
			box.low[axis] = between(&seed, -1, 0.5f);
			box.high[axis] = box.low[axis] + between(&seed, 0, 1);
		}
		for (int k = 0; k < 8; k++) {
			const float corner[3] = {
				k & 1 ? box.high[0] : box.low[0],
				k & 2 ? box.high[1] : box.low[1],
				k & 4 ? box.high[2] : box.low[2]};

			nearest = fmin(nearest, depth_of(&camera, corner));
		}
		expect_px(lod_px_per_unit_of_box(&box, &camera, HEIGHT),
			&camera, nearest);
	}
}

/* A part without a skin: its box turns with its node, in the scene's unit. */
static void test_a_part_has_the_pixels_of_its_turned_box(void **state)
{
	uint32_t seed = 2;

	(void)state;
	for (int i = 0; i < 40; i++) {
		struct model *model = small_model_grid(1, 2, 200.0f, true);
		struct instance *instance = small_model_instance(model);
		struct camera camera = random_camera(&seed);
		struct transform *local = &instance->pose.local[0];
		double nearest = 1e9;
		float px;

		local->rotation[i % 3] = 0.6f;
		local->rotation[3] = 0.8f;
		for (int axis = 0; axis < 3; axis++) {
			local->translation[axis] = between(&seed, -100, 100);
			local->scale[axis] = between(&seed, 0.5f, 1.5f);
		}
		instance_update(instance);
		for (int v = 0; v < model->mesh[0].primitive->vertex_count; v++) {
			float at[3];

			instance_world_vertex(
				instance, &instance->drawable[0], v, at);
			glm_vec3_scale(at, instance->unit_scale, at);
			nearest = fmin(nearest, depth_of(&camera, at));
		}
		px = lod_px_per_unit(instance, &camera, 1, HEIGHT);
		expect_px(px, &camera, nearest);
		/* Without a part in sight, nothing is near. */
		instance->drawable[0].hidden = true;
		assert_true(
			lod_px_per_unit(instance, &camera, 1, HEIGHT) < 1e-3f);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* A surface reaches beyond its joints by 6% of the model's extent. */
static void test_a_skin_has_the_pixels_of_its_nearest_joint(void **state)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance;
	struct model *model;
	uint32_t seed = 3;

	(void)state;
	assert_int_equal(model_load("assets/walker.glb", &nowhere, &model), 0);
	instance = small_model_instance(model);
	for (int i = 0; i < 40; i++) {
		struct camera camera = random_camera(&seed);
		double nearest = (double)camera.distance;

		for (int j = 0; j < model->skin[0].joint_count; j++) {
			float at[3];

			glm_vec3_scale(
				instance->world[model->skin[0].joint[j]][3],
				instance->unit_scale, at);
			nearest = fmin(nearest, depth_of(&camera, at));
		}
		for (int d = 0; d < instance->drawable_count; d++) {
			assert_true(instance->drawable[d].skin >= 0);
		}
		expect_px(lod_px_per_unit(instance, &camera, 1.7f, HEIGHT),
			&camera, nearest - 0.06 * 1.7);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_hidden_parts_have_no_triangles(void **state)
{
	struct model *model = small_model_grid(3, 2, 1.0f, true);
	struct instance *instance = small_model_instance(model);

	(void)state;
	assert_int_equal(lod_triangles(instance), 12);
	instance->drawable[0].hidden = true;
	assert_int_equal(lod_triangles(instance), 0);
	instance_destroy(instance);
	model_destroy(model);
}

/* Levels for 1, 2 and 4 cm, and lists for shadows of 1.5 and 6 cm. */
static void test_lists_within_the_limit_are_chosen(void **state)
{
	static struct batch_lod level[3] = {
		{.error = 0.01f}, {.error = 0.02f}, {.error = 0.04f}};
	static struct batch_lod shadow[2] = {
		{.error = 0.015f}, {.error = 0.06f}};
	/* in thousandths: the limit, then what it chooses; 2: no list */
	static const int rows[][4] = {{2, 0, 0, 2}, {4, 0, 1, 2}, {6, 0, 1, 0},
		{9, 0, 2, 0}, {11, 1, 2, 0}, {13, 1, 2, 0}, {15, 1, 3, 0},
		{19, 1, 3, 0}, {21, 2, 3, 1}, {39, 2, 3, 1}, {41, 3, 3, 1}};
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
	struct drawable *drawable = &instance->drawable[0];
	struct batch kept = drawable->batch[0];

	(void)state;
	drawable->batch[0].lod = level;
	drawable->batch[0].lod_count = 3;
	drawable->batch[0].shadow = shadow;
	drawable->batch[0].shadow_count = 2;
	drawable->bump_texels = 500;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		float limit = 0.001f * (float)rows[i][0];
		const struct lod lod = {.kind = LOD_ERROR, .error_px = 2};

		instance->lod_px_per_unit = 0;
		lod_choose(instance, &lod, 2 / limit);
		assert_int_equal(drawable->lod, rows[i][1]);
		assert_int_equal(drawable->shadow_lod, rows[i][2]);
		assert_int_equal(drawable->shadow_list, rows[i][3]);
		/* 2.5 texels a pixel, of which the limit has two. */
		assert_int_equal(drawable->bumps_hidden, limit > 0.01f);
	}
	drawable->batch[0] = kept;
	instance_destroy(instance);
	model_destroy(model);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_pixels_go_with_the_depth_down_to_a_twentieth),
		cmocka_unit_test(test_a_box_has_the_pixels_of_its_nearest_corner),
		cmocka_unit_test(test_a_part_has_the_pixels_of_its_turned_box),
		cmocka_unit_test(test_a_skin_has_the_pixels_of_its_nearest_joint),
		cmocka_unit_test(test_hidden_parts_have_no_triangles),
		cmocka_unit_test(test_lists_within_the_limit_are_chosen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
