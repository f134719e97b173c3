/* How large an instance is, and the unit that its vertices have. */
#include "app/scene/instance/bounds.h"
#include "app/scene/instance/instance.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

static void test_keeps_metres_for_a_model_of_human_size(void **state)
{
	struct model *model = small_model_grid(2, 2, 1.75f, true);
	struct instance *instance = small_model_instance(model);
	struct bounds bounds;

	(void)state;
	assert_near(instance->unit_scale, 1.0, 0.0);
	bounds = bounds_of_instance(instance);
	assert_near(bounds_extent(&bounds), 1.75, 1e-6);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_scales_a_huge_model_by_a_power_of_two(void **state)
{
	struct model *model = small_model_grid(2, 2, 5000.0f, true);
	struct instance *instance = small_model_instance(model);
	struct bounds bounds;
	mat4 matrix;
	float corner[3];

	(void)state;
	assert_near(instance->unit_scale, 1.0 / 8192.0, 0.0);
	bounds = bounds_of_instance(instance);
	assert_near(bounds_extent(&bounds), 5000.0 / 8192.0, 1e-6);
	/* Vertices and their matrix are near 1. */
	instance_drawable_matrix(instance, &instance->drawable[0], matrix);
	assert_near(matrix[0][0] * instance->drawable[0].position[8][0],
		5000.0 / 8192.0, 1e-6);
	assert_true(matrix[0][0] >= 0.25f && matrix[0][0] <= 4.0f);
	/* World positions are the file's. */
	instance_world_vertex(instance, &instance->drawable[0], 8, corner);
	assert_near(corner[0], 5000.0, 1e-3);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_scales_a_tiny_model_up(void **state)
{
	struct model *model = small_model_grid(1, 1, 0.001f, true);
	struct instance *instance = small_model_instance(model);
	struct bounds bounds = bounds_of_instance(instance);

	(void)state;
	assert_true(bounds_extent(&bounds) > 0.5f);
	assert_true(bounds_extent(&bounds) <= 1.0f);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_techniques_are_named_by_what_moves_vertices(void **state)
{
	static const char *const names[] = {
		"Hierarchical", "Skeletal", "Morphing", "Skeletal + morph"};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct drawable drawable[2] = {{.skin = -1}, {.skin = -1}};
		struct instance instance = {
			.drawable_count = 2, .drawable = drawable};

		drawable[0].skin = i & 1 ? 0 : -1;
		drawable[1].morphed = i & 2;
		assert_string_equal(instance_technique(&instance), names[i]);
	}
}

/* A skin's winding is that of its joints, not of its node. */
static void test_a_skin_is_mirrored_by_its_joints(void **state)
{
	mat4 world = {{1}, {0, 1}, {0, 0, 1}, {0, 0, 0, 1}};
	struct drawable drawable = {.vertex_scale = 1.0f};
	struct instance instance = {.drawable_count = 1,
		.drawable = &drawable,
		.unit_scale = 1.0f,
		.world = &world};

	(void)state;
	for (int i = 0; i < 8; i++) {
		bool joints = i & 2, node = i & 4;

		drawable.skin = i & 1 ? 0 : -1;
		drawable.mirrored = joints;
		world[0][0] = node ? -1.0f : 1.0f;
		assert_int_equal(instance_is_mirrored(&instance, &drawable),
			i & 1 ? joints : node);
	}
}

static void test_bounds_of_nothing_are_empty(void **state)
{
	struct bounds bounds = bounds_empty();
	float center[3];

	(void)state;
	assert_true(bounds_is_empty(&bounds));
	assert_near(bounds_extent(&bounds), 0.0, 0.0);
	bounds_center(&bounds, center);
	assert_all_near(center, ((float[3]){0, 0, 0}), 3, 0.0);
}

/* A model may grow out of a point that is far from the origin. */
static void test_a_model_without_size_at_rest_has_that_of_its_clip(void **state)
{
	static const float time_s[] = {0, 1};
	static const float size[] = {1e-8f, 1e-8f, 1e-8f, 1, 1, 1};
	struct model_channel channel = {.path = MODEL_SCALE,
		.interpolation = MODEL_LINEAR,
		.width = 3,
		.key_count = 2,
		.time_s = time_s,
		.value = size};
	struct model_clip grow = {.name = "grow",
		.duration_s = 1,
		.channel_count = 1,
		.channel = &channel};

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		struct model *model = small_model_grid(2, 2, 1.0f, true);
		struct transform *rest = &model->node[0].rest;
		struct instance *instance;

		model->clip = &grow;
		model->clip_count = 1;
		rest->translation[axis] = 3.0f;
		rest->scale[0] = rest->scale[1] = rest->scale[2] = 1e-8f;
		instance = small_model_instance(model);
		assert_near(instance->unit_scale, 1.0, 0.0);
		assert_near(bounds_extent_of_model(instance), 1.0, 1e-6);
		assert_near(instance->world[0][0][0], 1e-8, 1e-12);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* A millionth of its distance is what rounding may make of a point. */
static void test_a_size_is_more_than_rounding(void **state)
{
	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		for (int large = 0; large < 2; large++) {
			struct model *model = small_model_grid(2, 2, 1.0f, true);
			struct instance *instance = small_model_instance(model);
			struct model_node *node = &model->node[0];
			float scale = large ? 4e-6f : 2e-6f;

			node->rest.translation[axis] = -3.0f;
			for (int i = 0; i < 3; i++) {
				node->rest.scale[i] = scale;
			}
			assert_near(bounds_extent_of_model(instance),
				large ? 4e-6 : 0, 2.5e-7);
			instance_destroy(instance);
			model_destroy(model);
		}
	}
}

/* GL's matrices have few bits for the scale of arrays far from that size. */
static void test_a_rigid_parts_coordinates_are_scaled_to_near_one(void **state)
{
	/* the largest coordinate, and the power of two that scales it */
	static const float rows[][2] = {{0.001f, 512}, {-0.001f, 512},
		{0.24f, 4}, {0.25f, 1}, {1, 1}, {16, 1}, {-16.1f, 1.0f / 32},
		{-100, 1.0f / 128}, {0, 1}, {1e-13f, 1}, {1e13f, 1}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct model *model = small_model_grid(1, 1, 0.0f, true);
		struct instance *instance;
		const struct drawable *drawable;

		model->mesh[0].primitive->position[2][i % 3] = rows[i][0];
		instance = small_model_instance(model);
		drawable = &instance->drawable[0];
		assert_near(drawable->vertex_scale, rows[i][1], 0);
		assert_near(drawable->base_position[2][i % 3],
			rows[i][0] * rows[i][1], 0);
		instance_destroy(instance);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keeps_metres_for_a_model_of_human_size),
		cmocka_unit_test(test_scales_a_huge_model_by_a_power_of_two),
		cmocka_unit_test(test_scales_a_tiny_model_up),
		cmocka_unit_test(
			test_techniques_are_named_by_what_moves_vertices),
		cmocka_unit_test(test_a_skin_is_mirrored_by_its_joints),
		cmocka_unit_test(test_bounds_of_nothing_are_empty),
		cmocka_unit_test(
			test_a_model_without_size_at_rest_has_that_of_its_clip),
		cmocka_unit_test(test_a_size_is_more_than_rounding),
		cmocka_unit_test(
			test_a_rigid_parts_coordinates_are_scaled_to_near_one),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
