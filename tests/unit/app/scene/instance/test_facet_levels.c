/*
 * Levels of a primitive without normals: which vertices they have, and how
 * these are lit, against normals of the posed triangles in plain arithmetic.
 */
#include "app/model/levels/levels.h"
#include "app/model/model_deltas.h"
#include "app/scene/instance/batch/batch.h"
#include "app/scene/instance/lod.h"
#include "tests/support/model/small_model.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	SIDE = 30,
	TARGET_MOVES = 2
};

/* A dome of SIDE x SIDE quads, which a morph target raises. */
struct scene {
	struct model *model;
	struct model_primitive *primitive;
	struct instance *instance;
	struct drawable *drawable;
};

static void bend(struct model_primitive *primitive)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		float *at = primitive->position[v];

		at[2] = 0.25f - (at[0] - 0.5f) * (at[0] - 0.5f) -
			(at[1] - 0.5f) * (at[1] - 0.5f);
	}
}

static void add_target(struct model *model, struct model_primitive *primitive)
{
	static float delta[(SIDE + 1) * (SIDE + 1)][3];
	static struct model_target target;
	static const char *name = "up";

	for (int v = 0; v < primitive->vertex_count; v++) {
		delta[v][2] = primitive->position[v][2] * TARGET_MOVES;
	}
	target.position = model_deltas_view(
		(const float(*)[3])delta, primitive->vertex_count);
	primitive->target = &target;
	model->mesh[0].target_count = 1;
	model->mesh[0].target_name = &name;
	model->weight_count = 1;
	model->rest_weights = ARENA_ARRAY(&model->arena, float, 1);
	assert_non_null(model->rest_weights);
}

static struct scene begin(const char *kernel, bool morphed)
{
	struct log nowhere = log_to_nowhere();
	struct scene scene = {
		.model = small_model_grid(SIDE, SIDE, 1.0f, false)};

	scene.primitive = &scene.model->mesh[0].primitive[0];
	bend(scene.primitive);
	if (morphed) {
		add_target(scene.model, scene.primitive);
	}
	assert_int_equal(levels_make(scene.model), 0);
	assert_int_equal(instance_create(scene.model, kernel_find(kernel),
				 &nowhere, &scene.instance),
		0);
	scene.drawable = &scene.instance->drawable[0];
	return scene;
}

static void end(struct scene *scene)
{
	instance_destroy(scene->instance);
	model_destroy(scene->model);
}

static void choose_level(struct scene *scene, int level)
{
	struct lod lod = {.kind = LOD_LEVEL, .level = level};

	lod_choose(scene->instance, &lod, 100.0f);
}

static void find_plane(const struct scene *scene, uint32_t corner, float out[3])
{
	const uint32_t *at = scene->primitive->index + corner / 3 * 3;
	float p[3][3], length = 0.0f;

	for (int i = 0; i < 3; i++) {
		drawable_position(scene->drawable, (int)at[i], p[i]);
	}
	for (int i = 0; i < 3; i++) {
		int j = (i + 1) % 3, k = (i + 2) % 3;

		out[i] = (p[1][j] - p[0][j]) * (p[2][k] - p[0][k]) -
			(p[1][k] - p[0][k]) * (p[2][j] - p[0][j]);
		length += out[i] * out[i];
	}
	for (int i = 0; i < 3; i++) {
		out[i] /= sqrtf(length);
	}
}

static void normal_at(const struct batch *batch, int vertex, float out[3])
{
	float length = 0.0f;

	if (batch->normal) {
		memcpy(out, batch->normal[vertex], sizeof(float[3]));
	} else {
		out[0] = batch->fixed_normal[vertex].x;
		out[1] = batch->fixed_normal[vertex].y;
		out[2] = batch->fixed_normal[vertex].z;
	}
	for (int i = 0; i < 3; i++) {
		length += out[i] * out[i];
	}
	for (int i = 0; i < 3; i++) {
		out[i] /= sqrtf(length);
	}
}

/* Each corner is at its vertex's posed place and has its triangle's normal. */
static void assert_level(const struct scene *scene, int level)
{
	const struct model_lod *from = &scene->primitive->lod[level - 1];
	const struct batch *batch = scene->drawable->batch;
	const struct batch_lod *list = &batch->lod[level - 1];

	assert_int_equal(list->index_count, from->index_count);
	assert_false(list->flat);
	for (int i = 0; i < list->index_count; i++) {
		int vertex = list->first_vertex + list->index[i];
		float at[3], wanted[3], normal[3];

		assert_in_range(list->index[i], 0, list->vertex_count - 1);
		drawable_batch_position(scene->drawable, batch, vertex, at);
		drawable_position(scene->drawable, (int)from->index[i], wanted);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(at[axis], wanted[axis], 0.0);
		}
		find_plane(scene, from->corner[i], wanted);
		normal_at(batch, vertex, normal);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(normal[axis], wanted[axis], 4e-3);
		}
	}
}

static void expect_levels(const char *kernel, bool morphed)
{
	struct scene scene = begin(kernel, morphed);
	int count = scene.drawable->batch->lod_count;

	assert_true(count >= 3);
	for (int level = 1; level <= count; level++) {
		if (morphed) {
			scene.instance->pose.weight[0] = 0.2f * (float)level;
		}
		choose_level(&scene, level);
		instance_update(scene.instance);
		assert_level(&scene, level);
	}
	end(&scene);
}

static void test_levels_have_the_normals_of_posed_triangles(void **state)
{
	(void)state;
	expect_levels("fixed", true);
	expect_levels("float", true);
}

static void test_levels_of_what_never_moves_are_ready(void **state)
{
	(void)state;
	expect_levels("fixed", false);
	expect_levels("float", false);
}

static void test_another_level_is_gathered_when_it_is_chosen(void **state)
{
	struct scene scene = begin("fixed", true);

	(void)state;
	choose_level(&scene, 1);
	scene.instance->pose.weight[0] = 0.7f;
	instance_update(scene.instance);
	choose_level(&scene, 2);
	assert_level(&scene, 2);
	end(&scene);
}

/* The shadow's list has vertices of its own, coarsest first. */
static void test_shadows_have_posed_vertices(void **state)
{
	struct scene scene = begin("fixed", true);
	const struct batch *batch = scene.drawable->batch;

	(void)state;
	assert_true(batch->shadow_count >= 2);
	scene.instance->pose.weight[0] = 0.4f;
	choose_level(&scene, 0);
	instance_update(scene.instance);
	for (int i = 0; i < batch->shadow_count; i++) {
		const struct batch_lod *list = &batch->shadow[i];

		assert_true(i == 0 ||
			list->vertex_count < batch->shadow[i - 1].vertex_count);
		assert_int_equal(
			list->first_vertex, batch->shadow[0].first_vertex);
		for (int k = 0; i == scene.drawable->shadow_list &&
			k < list->index_count;
			k++) {
			int vertex = list->first_vertex + list->index[k];
			float at[3], wanted[3];

			drawable_batch_position(
				scene.drawable, batch, vertex, at);
			drawable_position(scene.drawable,
				(int)batch->source[vertex], wanted);
			assert_near(at[2], wanted[2], 0.0);
		}
	}
	end(&scene);
}

/* Levels of a file, whose meshes have no normals either, are flat. */
static void test_levels_of_a_file_have_flat_triangles(void **state)
{
	static uint32_t two[6] = {0, 2, 8, 0, 8, 6};
	static struct model_lod lod = {
		.error_m = 0.01f, .index_count = 6, .index = two};
	struct scene scene = {.model = small_model_grid(2, 2, 1.0f, false)};
	const struct batch *batch;

	(void)state;
	scene.model->mesh[0].primitive[0].lod_count = 1;
	scene.model->mesh[0].primitive[0].lod = &lod;
	scene.instance = small_model_instance(scene.model);
	batch = scene.instance->drawable[0].batch;
	assert_int_equal(batch->lod_count, 1);
	assert_true(batch->lod[0].flat);
	assert_int_equal(batch->lod[0].vertex_count, 6);
	for (int i = 2; i < 6; i += 3) {
		assert_near(batch->normal[batch->lod[0].first_vertex +
				    batch->lod[0].index[i]][2],
			1.0, 1e-6);
	}
	end(&scene);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_levels_have_the_normals_of_posed_triangles),
		cmocka_unit_test(test_levels_of_what_never_moves_are_ready),
		cmocka_unit_test(
			test_another_level_is_gathered_when_it_is_chosen),
		cmocka_unit_test(test_shadows_have_posed_vertices),
		cmocka_unit_test(test_levels_of_a_file_have_flat_triangles),
	};

	return cmocka_run_group_tests_name("facet_levels", tests, NULL, NULL);
}
