#include "app/scene/batch.h"
#include "app/scene/bounds.h"
#include "app/scene/instance.h"
#include "tests/support/small_model.h"
#include "tests/support/test.h"

#include <string.h>

static struct instance *make_instance(const struct model *model)
{
	struct log nowhere = log_to_nowhere();
	struct instance *instance = NULL;

	assert_int_equal(
		instance_create(model, kernel_find(NULL), &nowhere, &instance),
		0);
	return instance;
}

static void test_keeps_metres_for_a_model_of_human_size(void **state)
{
	struct model *model = small_model_grid(2, 2, 1.75f, true);
	struct instance *instance = make_instance(model);
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
	struct instance *instance = make_instance(model);
	struct bounds bounds;
	mat4 matrix;
	float corner[3];

	(void)state;
	assert_near(instance->unit_scale, 1.0 / 8192.0, 0.0);
	bounds = bounds_of_instance(instance);
	assert_near(bounds_extent(&bounds), 5000.0 / 8192.0, 1e-6);
	/* Vertices near 1, and a matrix near 1 that carries them. */
	instance_drawable_matrix(instance, &instance->drawable[0], matrix);
	assert_near(matrix[0][0] * instance->drawable[0].position[8][0],
		5000.0 / 8192.0, 1e-6);
	assert_true(matrix[0][0] >= 0.25f && matrix[0][0] <= 4.0f);
	/* The world is as the file says. */
	instance_world_vertex(instance, &instance->drawable[0], 8, corner);
	assert_near(corner[0], 5000.0, 1e-3);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_scales_a_tiny_model_up(void **state)
{
	struct model *model = small_model_grid(1, 1, 0.001f, true);
	struct instance *instance = make_instance(model);
	struct bounds bounds = bounds_of_instance(instance);

	(void)state;
	assert_true(bounds_extent(&bounds) > 0.5f);
	assert_true(bounds_extent(&bounds) <= 1.0f);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_moves_a_rigid_mesh_with_its_node(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = make_instance(model);
	float corner[3];

	(void)state;
	instance->pose.local[0].translation[1] = 2.0f;
	instance_update(instance);
	instance_world_vertex(instance, &instance->drawable[0], 3, corner);
	assert_all_near(corner, ((float[3]){1, 3, 0}), 3, 1e-6);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_nodes_outside_the_scene_are_not_shown(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance;

	(void)state;
	model->node[0].in_scene = false;
	instance = make_instance(model);
	assert_int_equal(instance->drawable_count, 0);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_gives_flat_normals_where_the_file_has_none(void **state)
{
	struct model *model = small_model_grid(2, 1, 1.0f, false);
	struct instance *instance = make_instance(model);
	const struct batch *batch = &instance->drawable[0].batch[0];

	(void)state;
	assert_null(instance->drawable[0].normal);
	assert_null(batch->index);
	assert_int_equal(batch->vertex_count, 12);
	for (int v = 0; v < batch->vertex_count; v++) {
		assert_all_near(
			batch->normal[v], ((float[3]){0, 0, 1}), 3, 1e-6);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_cuts_a_mesh_too_large_for_16_bit_indices(void **state)
{
	/* 300 x 300 quads: 90,601 vertices, 540,000 indices. */
	struct model *model = small_model_grid(300, 300, 1.0f, true);
	struct instance *instance = make_instance(model);
	const struct drawable *drawable = &instance->drawable[0];
	const struct model_primitive *primitive = drawable->primitive;
	int done = 0;

	(void)state;
	assert_true(drawable->batch_count > 1);
	for (int b = 0; b < drawable->batch_count; b++) {
		const struct batch *batch = &drawable->batch[b];

		assert_true(batch->vertex_count <= 65536);
		assert_int_equal(batch->vertex_count % 3, 0);
		for (int v = 0; v < batch->vertex_count; v += 997) {
			uint32_t from = primitive->index[done + v];

			assert_memory_equal(batch->position[v],
				primitive->position[from], sizeof(float[3]));
		}
		done += batch->vertex_count;
	}
	assert_int_equal(done, primitive->index_count);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_multiplies_vertex_colours_by_the_material(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	struct instance *instance;
	const uint8_t *color;

	(void)state;
	primitive->color = arena_alloc(&model->arena, 4, 4);
	memset(primitive->color, 200, 16);
	model->material[0].base_color[0] = 0.0f;
	instance = make_instance(model);
	color = instance->drawable[0].batch[0].color[2];
	assert_int_equal(color[0], 0);
	assert_int_equal(color[1], 200);
	assert_int_equal(color[3], 200);
	instance_destroy(instance);
	model_destroy(model);
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keeps_metres_for_a_model_of_human_size),
		cmocka_unit_test(test_scales_a_huge_model_by_a_power_of_two),
		cmocka_unit_test(test_scales_a_tiny_model_up),
		cmocka_unit_test(test_moves_a_rigid_mesh_with_its_node),
		cmocka_unit_test(test_nodes_outside_the_scene_are_not_shown),
		cmocka_unit_test(test_gives_flat_normals_where_the_file_has_none),
		cmocka_unit_test(test_cuts_a_mesh_too_large_for_16_bit_indices),
		cmocka_unit_test(test_multiplies_vertex_colours_by_the_material),
		cmocka_unit_test(test_bounds_of_nothing_are_empty),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
