/* Which level of detail is chosen. */
#include "app/scene/instance/lod.h"
#include "platform/base/compiler.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static void test_reads_words_pixels_and_levels(void **state)
{
	struct lod lod;

	(void)state;
	assert_true(lod_parse("auto", &lod));
	assert_int_equal(lod.kind, LOD_AUTO);
	assert_true(lod_parse("off", &lod));
	assert_int_equal(lod.kind, LOD_ALL);
	assert_true(lod_parse("1.5", &lod));
	assert_int_equal(lod.kind, LOD_ERROR);
	assert_near(lod.error_px, 1.5, 0.0);
	assert_true(lod_parse("level:2", &lod));
	assert_int_equal(lod.kind, LOD_LEVEL);
	assert_int_equal(lod.level, 2);
}

static void test_refuses_other_words(void **state)
{
	static const char *const bad[] = {"", "0", "-1", "101", "1.5px", "nan",
		"on", "level:", "level:-1", "level:x", "level:100"};
	struct lod lod;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(bad); i++) {
		assert_false(lod_parse(bad[i], &lod));
	}
}

/* Eight triangles, a level of two and one of one, for errors of 1 and 4 cm. */
struct scene {
	struct model *model;
	struct instance *instance;
	struct drawable *drawable;
};

static struct scene begin(void)
{
	static uint32_t two[6] = {0, 2, 8, 0, 8, 6}, one[3] = {0, 2, 8};
	static struct model_lod lod[3] = {
		{.error_m = 0.01f, .index_count = 6, .index = two},
		{.error_m = 0.04f, .index_count = 3, .index = one},
		{.error_m = 0.02f,
			.shadow_only = true,
			.index_count = 3,
			.index = one},
	};
	struct scene scene = {.model = small_model_grid(2, 2, 1.0f, true)};
	struct model_primitive *primitive = &scene.model->mesh[0].primitive[0];

	primitive->lod_count = 3;
	primitive->lod = lod;
	scene.instance = small_model_instance(scene.model);
	scene.drawable = &scene.instance->drawable[0];
	return scene;
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

static const struct lod by_itself = {.kind = LOD_AUTO};

static void test_takes_the_coarsest_level_within_a_pixel(void **state)
{
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &by_itself, 1000.0f);
	assert_int_equal(scene.drawable->lod, 0);
	assert_int_equal(lod_triangles(scene.instance), 8);
	lod_choose(scene.instance, &by_itself, 99.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 1);
	assert_int_equal(lod_triangles(scene.instance), 2);
	lod_choose(scene.instance, &by_itself, 24.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 2);
	assert_int_equal(lod_triangles(scene.instance), 1);
	end(&scene);
}

/* Even the finest list for shadows may be too coarse for a near one. */
static void test_a_near_shadow_needs_all_triangles(void **state)
{
	struct scene scene = begin();
	const struct batch *batch = &scene.drawable->batch[0];

	(void)state;
	lod_choose(scene.instance, &by_itself, 1000.0f);
	assert_null(drawable_shadow(scene.drawable, batch));
	lod_choose(scene.instance, &by_itself, 99.0f * LOD_ERROR_PX);
	assert_non_null(drawable_shadow(scene.drawable, batch));
	assert_int_equal(drawable_shadow(scene.drawable, batch)->index_count, 3);
	end(&scene);
}

static void test_obeys_a_chosen_error_or_level(void **state)
{
	static const struct lod all = {.kind = LOD_ALL};
	static const struct lod last = {.kind = LOD_LEVEL, .level = 9};
	static const struct lod coarse = {.kind = LOD_ERROR, .error_px = 5.0f};
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &coarse, 120.0f);
	assert_int_equal(scene.drawable->lod, 2);
	lod_choose(scene.instance, &all, 120.0f);
	assert_int_equal(scene.drawable->lod, 0);
	lod_choose(scene.instance, &last, 120.0f);
	assert_int_equal(scene.drawable->lod, 2);
	end(&scene);
}

/* An instance at the border between two levels keeps its level. */
static void test_small_changes_change_nothing(void **state)
{
	float border = 100.0f * LOD_ERROR_PX;
	struct scene scene = begin();

	(void)state;
	lod_choose(scene.instance, &by_itself, border * 0.98f);
	assert_int_equal(scene.drawable->lod, 1);
	for (int i = 0; i < 100; i++) {
		lod_choose(scene.instance, &by_itself,
			border * (i % 2 ? 0.96f : 1.05f));
		assert_int_equal(scene.drawable->lod, 1);
	}
	lod_choose(scene.instance, &by_itself, border * 1.2f);
	assert_int_equal(scene.drawable->lod, 0);
	end(&scene);
}

static void test_a_larger_instance_needs_finer_levels(void **state)
{
	struct scene scene = begin();

	(void)state;
	scene.instance->pose.local[0].scale[0] = 3.0f;
	instance_update(scene.instance);
	lod_choose(scene.instance, &by_itself, 40.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 0);
	lod_choose(scene.instance, &by_itself, 30.0f * LOD_ERROR_PX);
	assert_int_equal(scene.drawable->lod, 1);
	end(&scene);
}

static void test_a_budget_asks_for_less_but_never_for_more(void **state)
{
	static const struct lod all = {.kind = LOD_ALL};
	static const struct lod five = {.kind = LOD_ERROR, .error_px = 5.0f};

	(void)state;
	assert_int_equal(lod_relax(&by_itself, 0.0f).kind, LOD_AUTO);
	assert_near(lod_relax(&by_itself, 2.0f).error_px, 2.0, 0.0);
	assert_near(lod_relax(&five, 2.0f).error_px, 5.0, 0.0);
	assert_int_equal(lod_relax(&all, 2.0f).kind, LOD_ALL);
}

static void test_half_as_far_has_twice_the_pixels(void **state)
{
	struct scene scene = begin();
	struct camera camera = camera_default();
	float far;

	(void)state;
	/* It looks at the middle of the plane, from the front. */
	camera.target[0] = camera.target[1] = 0.5f;
	camera.yaw_rad = camera.pitch_rad = 0.0f;
	camera.distance = 100.0f;
	far = lod_px_per_unit(scene.instance, &camera, 1.0f, 640);
	camera.distance = 50.0f;
	assert_near(lod_px_per_unit(scene.instance, &camera, 1.0f, 640),
		2.0f * far, 1e-3f * far);
	assert_near(lod_px_per_unit(scene.instance, &camera, 1.0f, 1280),
		4.0f * far, 1e-3f * far);
	assert_near(far, 320.0 / (100.0 * tan(0.5 * (double)camera.yfov_rad)),
		1e-3 * far);
	camera.distance = 100.0f;
	scene.instance->pose.local[0].translation[2] = 50.0f;
	instance_update(scene.instance);
	assert_near(lod_px_per_unit(scene.instance, &camera, 1.0f, 640),
		2.0f * far, 1e-3f * far);
	end(&scene);
}

/* Scales along x, y and z; the place does not count. */
static void set_matrix(mat4 out, float x, float y, float z)
{
	const mat4 matrix = {
		{x, 0, 0, 0}, {0, 0, y, 0}, {0, -z, 0, 0}, {9, 9, 9, 1}};

	memcpy(out, matrix, sizeof(matrix));
}

static void test_a_skin_is_as_large_as_its_first_joint_or_half_the_largest(
	void **state)
{
	static const float rows[][4] = {{1, 0.1f, 4, 2}, {3, 1, 4, 3},
		{0, 1, 2, 1}, {2, 1, 0, 2}, {1, 6, 0, 3}};
	struct model_skin skin = {.joint_count = 3};
	struct model model = {.skin = &skin};
	mat4 joint[4], *palette[1] = {joint};
	struct instance instance = {
		.model = &model, .palette = palette, .unit_scale = 0.25f};
	const struct drawable drawable = {.skin = 0};

	(void)state;
	set_matrix(joint[3], 99, 99, 99); /* of another skin */
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		for (int axis = 0; axis < 3; axis++) {
			for (int j = 0; j < 3; j++) {
				float along = rows[i][j];

				set_matrix(joint[j], axis == 0 ? along : 0,
					axis == 1 ? along : 0.5f * along,
					axis == 2 ? along : 0);
			}
			assert_near(lod_error_units(&instance, &drawable),
				rows[i][3], 1e-6);
		}
	}
}

static void test_a_rigid_part_is_as_large_as_its_node(void **state)
{
	mat4 world[2];
	const struct instance instance = {.world = world, .unit_scale = 0.25f};
	const struct drawable drawable = {.skin = -1, .node = 1};

	(void)state;
	set_matrix(world[0], 99, 99, 99);
	set_matrix(world[1], 1, 3, 2);
	assert_near(lod_error_units(&instance, &drawable), 0.75, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_words_pixels_and_levels),
		cmocka_unit_test(test_refuses_other_words),
		cmocka_unit_test(test_takes_the_coarsest_level_within_a_pixel),
		cmocka_unit_test(test_obeys_a_chosen_error_or_level),
		cmocka_unit_test(test_small_changes_change_nothing),
		cmocka_unit_test(test_a_larger_instance_needs_finer_levels),
		cmocka_unit_test(test_a_budget_asks_for_less_but_never_for_more),
		cmocka_unit_test(test_half_as_far_has_twice_the_pixels),
		cmocka_unit_test(test_a_near_shadow_needs_all_triangles),
		cmocka_unit_test(
			test_a_skin_is_as_large_as_its_first_joint_or_half_the_largest),
		cmocka_unit_test(test_a_rigid_part_is_as_large_as_its_node),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
