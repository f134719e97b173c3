#include "app/model/model_deltas.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/instance.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <string.h>

static void test_moves_a_rigid_mesh_with_its_node(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance = small_model_instance(model);
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
	instance = small_model_instance(model);
	assert_int_equal(instance->drawable_count, 0);
	instance_destroy(instance);
	model_destroy(model);
}

/* Lets two nodes more show the mesh of the first one. */
static void show_three_times(struct model *model)
{
	struct model_node *node =
		ARENA_ARRAY(&model->arena, struct model_node, 3);

	node[0] = node[1] = node[2] = model->node[0];
	model->node = node;
	model->node_count = 3;
}

static const struct fixed_vector *batch_vertices(
	const struct instance *instance, int drawable)
{
	return instance->drawable[drawable].batch[0].fixed_position;
}

static void test_nodes_with_one_rigid_mesh_share_its_vertices(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	const float half[3] = {0.5f, 0.5f, 0.5f};
	const struct log log = {0};
	struct instance *instance, *floats;
	float corner[3];

	(void)state;
	show_three_times(model);
	assert_int_equal(
		instance_create(model, kernel_find("fixed"), &log, &instance),
		0);
	floats = small_model_instance(model);
	assert_int_equal(instance->drawable_count, 3);
	for (int i = 1; i < 3; i++) {
		assert_ptr_equal(batch_vertices(instance, 0),
			batch_vertices(instance, i));
		assert_ptr_equal(instance->drawable[0].batch[0].index,
			instance->drawable[i].batch[0].index);
		assert_ptr_equal(floats->drawable[0].position,
			floats->drawable[i].position);
	}
	/* but each has a place and colours of its own */
	instance->pose.local[1].translation[1] = 2.0f;
	instance_update(instance);
	instance_world_vertex(instance, &instance->drawable[1], 3, corner);
	assert_all_near(corner, ((float[3]){1, 3, 0}), 3, 1e-4);
	instance_world_vertex(instance, &instance->drawable[2], 3, corner);
	assert_all_near(corner, ((float[3]){1, 1, 0}), 3, 1e-4);
	assert_int_equal(
		batch_tint(&instance->drawable[1], half, &instance->arena), 0);
	assert_int_equal(instance->drawable[2].color[0],
		2 * instance->drawable[1].color[0]);
	instance_destroy(floats);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_gives_flat_normals_where_the_file_has_none(void **state)
{
	struct model *model = small_model_grid(2, 1, 1.0f, false);
	struct instance *instance = small_model_instance(model);
	const struct batch *batch = &instance->drawable[0].batch[0];

	(void)state;
	assert_null(instance->drawable[0].normal);
	assert_int_equal(batch->index_count, 12);
	for (int i = 2; i < batch->index_count; i += 3) {
		assert_all_near(batch->normal[batch->index[i]],
			((float[3]){0, 0, 1}), 3, 1e-6);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_keeps_vertex_colours_apart_where_there_are_no_normals(
	void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, false);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	struct instance *instance;
	const struct batch *batch;

	(void)state;
	primitive->color = arena_alloc(&model->arena, 4, 4);
	assert_non_null(primitive->color);
	for (int i = 0; i < 16; i++) {
		primitive->color[i / 4][i % 4] = (uint8_t)(170 + 5 * i);
	}
	instance = small_model_instance(model);
	batch = instance->drawable[0].batch;
	assert_null(batch->index);
	assert_int_equal(batch->vertex_count, 6);
	for (int v = 0; v < batch->vertex_count; v++) {
		assert_memory_equal(batch->color[v],
			primitive->color[primitive->index[v]], 4);
		assert_all_near(
			batch->normal[v], ((float[3]){0, 0, 1}), 3, 1e-6);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_triangles_of_one_colour_each_share_vertices_without_normals(
	void **state)
{
	struct model *model = small_model_grid(2, 1, 1.0f, false);
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	struct instance *instance;
	const struct batch *batch;

	(void)state;
	primitive->color =
		arena_alloc(&model->arena, (size_t)primitive->vertex_count, 4);
	assert_non_null(primitive->color);
	memset(primitive->color, 190, (size_t)primitive->vertex_count * 4);
	instance = small_model_instance(model);
	batch = instance->drawable[0].batch;
	assert_non_null(batch->index);
	assert_int_equal(batch->index_count, 12);
	assert_true(batch->vertex_count < 12);
	for (int v = 0; v < batch->vertex_count; v++) {
		assert_memory_equal(batch->color[v], primitive->color[0], 4);
	}
	instance_destroy(instance);
	model_destroy(model);
}

static void test_cuts_a_mesh_too_large_for_16_bit_indices(void **state)
{
	/* 300 x 300 quads: 90,601 vertices, 540,000 indices. */
	struct model *model = small_model_grid(300, 300, 1.0f, true);
	struct instance *instance = small_model_instance(model);
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
	instance = small_model_instance(model);
	color = instance->drawable[0].batch[0].color[2];
	assert_int_equal(color[0], 0);
	assert_int_equal(color[1], 200);
	assert_int_equal(color[3], 200);
	instance_destroy(instance);
	model_destroy(model);
}

/* A gray of 40 mirrors 33 (see test_color), but of a material that is unlit. */
static void test_dark_vertex_colours_of_lit_surfaces_mirror(void **state)
{
	(void)state;
	for (int unlit = 0; unlit <= 1; unlit++) {
		struct model *model = small_model_grid(1, 1, 1.0f, true);
		struct model_primitive *primitive = &model->mesh[0].primitive[0];
		struct instance *instance;
		const uint8_t(*color)[4];

		primitive->color = arena_alloc(&model->arena, 4, 4);
		memset(primitive->color, 200, 16);
		memset(primitive->color[2], 40, 4);
		model->material[0].unlit = unlit;
		instance = small_model_instance(model);
		color = instance->drawable[0].batch[0].color;
		assert_int_equal(color[1][0], 200);
		assert_int_equal(color[2][0], unlit ? 40 : 73);
		assert_int_equal(color[2][2], unlit ? 40 : 73);
		assert_int_equal(color[2][3], 40);
		assert_int_equal(primitive->color[2][0], 40);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* A white material leaves them as they are, any other makes a copy. */
static void test_colours_of_a_white_material_take_no_memory(void **state)
{
	(void)state;
	for (int channel = 0; channel <= 4; channel++) {
		struct model *model = small_model_grid(1, 1, 1.0f, true);
		uint8_t(*color)[4] = arena_alloc(&model->arena, 4, 4);
		struct instance *instance;

		memset(color, 200, 16);
		model->mesh[0].primitive[0].color = color;
		if (channel < 4) {
			model->material[0].base_color[channel] = 0.5f;
		}
		instance = small_model_instance(model);
		assert_int_equal(
			(const void *)instance->drawable[0].batch[0].color ==
				color,
			channel == 4);
		instance_destroy(instance);
		model_destroy(model);
	}
}

/* Skins the grid to one joint, which is a node of its own. */
static void add_skin(struct model *model)
{
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	size_t count = (size_t)primitive->vertex_count;
	struct arena *arena = &model->arena;
	struct model_node *node = ARENA_ARRAY(arena, struct model_node, 2);

	node[0] = node[1] = model->node[0];
	node[0].mesh = -1;
	node[1].skin = 0;
	model->node = node;
	model->node_count = 2;
	model->skin = ARENA_NEW(arena, struct model_skin);
	model->skin_count = 1;
	model->skin->joint_count = 1;
	model->skin->joint = ARENA_ARRAY(arena, int, 1);
	model->skin->inverse_bind = ARENA_ARRAY(arena, mat4, 1);
	for (int i = 0; i < 4; i++) {
		model->skin->inverse_bind[0][i][i] = 1.0f;
	}
	primitive->influences = 4;
	primitive->joint = ARENA_ARRAY(arena, uint16_t, count * 4);
	primitive->weight = ARENA_ARRAY(arena, float, count * 4);
	for (size_t v = 0; v < count; v++) {
		primitive->weight[v * 4] = 1.0f;
	}
}

/* The same displacement along an axis for all vertices. */
static struct model_deltas same_deltas(
	struct arena *arena, size_t count, int axis, float distance)
{
	float(*value)[3] = arena_alloc(arena, count, sizeof(*value));

	assert_non_null(value);
	for (size_t v = 0; v < count; v++) {
		value[v][axis] = distance;
	}
	return model_deltas_view((const float(*)[3])value, (int)count);
}

/* One target: +0.5 Z, normals towards +X, tangents towards -Z. */
static void add_target(struct model *model)
{
	struct model_primitive *primitive = &model->mesh[0].primitive[0];
	size_t count = (size_t)primitive->vertex_count;
	struct arena *arena = &model->arena;

	primitive->target = ARENA_NEW(arena, struct model_target);
	primitive->target->position = same_deltas(arena, count, 2, 0.5f);
	primitive->target->normal = same_deltas(arena, count, 0, 1.0f);
	primitive->target->tangent = same_deltas(arena, count, 2, -1.0f);
	model->mesh[0].target_count = 1;
	model->weight_count = 1;
	model->rest_weights = ARENA_ARRAY(arena, float, 1);
}

/* A quarter turn about +Y: +X to -Z, +Z to +X. */
static const float quarter_turn[4] = {0, 0.70710678f, 0, 0.70710678f};

/* A square with tangents and something that moves it. */
struct mapped {
	struct model *model;
	struct instance *instance;
};

static struct mapped mapped_begin(float size, void (*add)(struct model *model))
{
	struct mapped mapped = {small_model_grid(1, 1, size, true), NULL};

	small_model_add_normal_map(mapped.model, 1, small_model_flat_map);
	add(mapped.model);
	mapped.instance = small_model_instance(mapped.model);
	return mapped;
}

static void mapped_end(struct mapped *mapped)
{
	instance_destroy(mapped->instance);
	model_destroy(mapped->model);
}

static void test_morphs_before_it_skins(void **state)
{
	struct model *model = small_model_grid(1, 1, 1.0f, true);
	struct instance *instance;
	const struct drawable *drawable;
	const float half = 0.70710678f;

	(void)state;
	small_model_add_normal_map(model, 1, small_model_flat_map);
	add_skin(model);
	add_target(model);
	instance = small_model_instance(model);
	drawable = &instance->drawable[0];
	instance->pose.weight[0] = 1.0f;
	memcpy(instance->pose.local[0].rotation, quarter_turn,
		sizeof(quarter_turn));
	instance_update(instance);
	/* (1, 1, 0) goes to (1, 1, 0.5), then to (0.5, 1, -1). */
	assert_all_near(
		drawable->position[3], ((float[3]){0.5f, 1, -1}), 3, 1e-6);
	/* (1, 0, 1) unit turns to (1, 0, -1); (1, 0, -1) to (-1, 0, -1). */
	assert_all_near(
		drawable->normal[3], ((float[3]){half, 0, -half}), 3, 1e-6);
	assert_all_near(
		drawable->tangent[3], ((float[3]){-half, 0, -half}), 3, 1e-6);
	assert_all_near(drawable->bitangent[3], ((float[3]){0, 1, 0}), 3, 1e-6);
	instance_destroy(instance);
	model_destroy(model);
}

static void test_skins_tangents_with_the_joints(void **state)
{
	struct mapped mapped = mapped_begin(1.0f, add_skin);
	struct instance *instance = mapped.instance;
	const struct drawable *drawable = &instance->drawable[0];

	(void)state;
	memcpy(instance->pose.local[0].rotation, quarter_turn,
		sizeof(quarter_turn));
	instance_update(instance);
	assert_all_near(drawable->tangent[2], ((float[3]){0, 0, -1}), 3, 1e-6);
	assert_all_near(drawable->bitangent[2], ((float[3]){0, 1, 0}), 3, 1e-6);
	mapped_end(&mapped);
}

static void test_morphs_the_tangents_of_a_rigid_mesh(void **state)
{
	struct mapped mapped = mapped_begin(100.0f, add_target);
	struct instance *instance = mapped.instance;
	const struct drawable *drawable = &instance->drawable[0];

	(void)state;
	assert_all_near(drawable->tangent[0], ((float[3]){1, 0, 0}), 3, 1e-6);
	instance->pose.weight[0] = 0.75f;
	instance_update(instance);
	assert_all_near(
		drawable->tangent[0], ((float[3]){0.8f, 0, -0.6f}), 3, 1e-6);
	assert_all_near(
		drawable->normal[0], ((float[3]){0.6f, 0, 0.8f}), 3, 1e-6);
	assert_near(drawable->position[0][2],
		0.375 * (double)drawable->vertex_scale, 1e-6);
	/* The next update starts from the base again. */
	instance->pose.weight[0] = 0.0f;
	instance_update(instance);
	assert_all_near(drawable->tangent[0], ((float[3]){1, 0, 0}), 3, 1e-6);
	mapped_end(&mapped);
}

static void test_leaves_tangents_alone_without_normal_maps(void **state)
{
	struct mapped mapped = mapped_begin(1.0f, add_skin);
	struct instance *instance = mapped.instance;
	const struct drawable *drawable = &instance->drawable[0];

	(void)state;
	instance->normal_mapping = false;
	memcpy(instance->pose.local[0].rotation, quarter_turn,
		sizeof(quarter_turn));
	instance_update(instance);
	assert_all_near(drawable->tangent[2], ((float[3]){1, 0, 0}), 3, 1e-6);
	assert_all_near(drawable->normal[2], ((float[3]){1, 0, 0}), 3, 1e-6);
	mapped_end(&mapped);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_moves_a_rigid_mesh_with_its_node),
		cmocka_unit_test(test_nodes_outside_the_scene_are_not_shown),
		cmocka_unit_test(
			test_nodes_with_one_rigid_mesh_share_its_vertices),
		cmocka_unit_test(test_gives_flat_normals_where_the_file_has_none),
		cmocka_unit_test(
			test_keeps_vertex_colours_apart_where_there_are_no_normals),
		cmocka_unit_test(
			test_triangles_of_one_colour_each_share_vertices_without_normals),
		cmocka_unit_test(test_cuts_a_mesh_too_large_for_16_bit_indices),
		cmocka_unit_test(test_multiplies_vertex_colours_by_the_material),
		cmocka_unit_test(test_dark_vertex_colours_of_lit_surfaces_mirror),
		cmocka_unit_test(test_colours_of_a_white_material_take_no_memory),
		cmocka_unit_test(test_morphs_before_it_skins),
		cmocka_unit_test(test_skins_tangents_with_the_joints),
		cmocka_unit_test(test_morphs_the_tangents_of_a_rigid_mesh),
		cmocka_unit_test(test_leaves_tangents_alone_without_normal_maps),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
