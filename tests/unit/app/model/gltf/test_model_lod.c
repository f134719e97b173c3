/* Levels of detail of glTF meshes (MSFT_lod). */
#include "app/model/model.h"
#include "platform/base/compiler.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"
#include "tests/unit/app/model/gltf/buffer.h"

#include <errno.h>
#include <stdio.h>

static const struct model_primitive *primitive_of(
	const struct model *model, const char *node)
{
	int index = model_find_node(model, node);

	assert_true(index >= 0);
	return &model->mesh[model->node[index].mesh].primitive[0];
}

static void test_levels_become_index_lists_of_the_full_mesh(void **state)
{
	static const uint32_t corners[6] = {0, 2, 8, 0, 8, 6};
	struct model *model = model_fixture("gltf/mesh/levels.gltf", NULL);
	const struct model_primitive *grid = primitive_of(model, "grid");

	(void)state;
	assert_int_equal(grid->vertex_count, 9);
	assert_int_equal(grid->index_count, 24);
	assert_int_equal(grid->lod_count, 3);
	assert_int_equal(grid->lod[1].index_count, 6);
	assert_memory_equal(grid->lod[1].index, corners, sizeof(corners));
	model_destroy(model);
}

/* In the file, the shadow level comes first and the finest level last. */
static void test_levels_are_sorted_with_shadow_levels_last(void **state)
{
	struct model *model = model_fixture("gltf/mesh/levels.gltf", NULL);
	const struct model_lod *lod = primitive_of(model, "grid")->lod;

	(void)state;
	assert_near(lod[0].error_m, 0.01, 1e-7);
	assert_int_equal(lod[0].index_count, 18);
	assert_false(lod[0].shadow_only);
	assert_near(lod[1].error_m, 0.1, 1e-7);
	assert_false(lod[1].shadow_only);
	assert_near(lod[2].error_m, 0.05, 1e-7);
	assert_int_equal(lod[2].index_count, 3);
	assert_true(lod[2].shadow_only);
	model_destroy(model);
}

static void test_levels_become_no_nodes_and_no_meshes(void **state)
{
	static const char *const levels[] = {
		"finest", "coarsest", "shape", "covered level"};
	struct model *model = model_fixture("gltf/mesh/levels.gltf", NULL);

	(void)state;
	assert_int_equal(model->node_count, 5);
	assert_int_equal(model->mesh_count, 4);
	for (size_t i = 0; i < 4; i++) {
		assert_int_equal(model_find_node(model, levels[i]), -1);
	}
	model_destroy(model);
}

static void test_indices_behind_a_level_are_remapped(void **state)
{
	struct model *model = model_fixture("gltf/mesh/levels.gltf", NULL);
	int own = model_find_node(model, "own");

	(void)state;
	assert_int_equal(model->node[own].file_index, 5);
	assert_int_equal(model->clip[0].channel[0].node, own);
	assert_int_equal(
		model->node[own].parent, model_find_node(model, "root"));
	model_destroy(model);
}

static void test_other_vertices_disqualify_a_level(void **state)
{
	struct log_capture logged;
	struct model *model = model_fixture("gltf/mesh/levels.gltf", &logged);
	int level = model_find_node(model, "own level");

	(void)state;
	assert_int_equal(primitive_of(model, "own")->lod_count, 0);
	assert_true(level >= 0);
	assert_false(model->node[level].in_scene);
	assert_int_equal(logged.count, 0);
	model_destroy(model);
}

/* At a coverage of 1/4, one metre of the grid covers 320 pixels. */
static void test_screen_coverage_gives_the_error_of_a_level(void **state)
{
	struct model *model = model_fixture("gltf/mesh/levels.gltf", NULL);
	const struct model_primitive *covered = primitive_of(model, "covered");

	(void)state;
	assert_int_equal(covered->lod_count, 1);
	assert_near(covered->lod[0].error_m, 1.0 / 320.0, 1e-7);
	model_destroy(model);
}

/* The same for the longest side of the mesh, whichever vertices and axis. */
static void test_screen_coverage_counts_the_longest_side(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		int axis = i % 3, far = i / 3;
		float position[3][3], sign = i % 2 ? 1.0f : -1.0f;
		struct model *model;

		for (int v = 0; v < 3; v++) {
			for (int k = 0; k < 3; k++) {
				position[v][k] = 5.0f + 0.125f * (float)(v == k);
			}
		}
		position[far][axis] = 5.0f + sign * 0.5f;
		position[(far + 1) % 3][axis] = 5.0f;
		model = buffer_model(position, sizeof(position),
			"'accessors':[{'bufferView':0,'componentType':5126,"
			"'count':3,'type':'VEC3'},{'componentType':5121,"
			"'count':3,'type':'SCALAR'}],'meshes':[{'primitives':["
			"{'attributes':{'POSITION':0}}]},{'primitives':[{"
			"'attributes':{'POSITION':0},'indices':1}]}],"
			"'nodes':[{'mesh':0,'extras':{'MSFT_screencoverage':["
			"0.25]},'extensions':{'MSFT_lod':{'ids':[1]}}},"
			"{'mesh':1}],'scenes':[{'nodes':[0]}]");
		assert_near(model->mesh[0].primitive[0].lod[0].error_m,
			(sign < 0 && (far + 2) % 3 == axis ? 0.625 : 0.5) / 320.0,
			1e-7);
		model_destroy(model);
	}
}

#define COARSE "{'attributes':{'POSITION':0},'indices':1}"

PRINTF_LIKE(1, 2) static struct model *load_text(const char *format, ...)
{
	struct log_capture logged;
	struct model *model = NULL;
	char text[2048];
	va_list values;

	va_start(values, format);
	assert_in_range(vsnprintf(text, sizeof(text), format, values), 0,
		sizeof(text) - 1);
	va_end(values);
	assert_int_equal(model_from_text(text, &logged, &model), 0);
	return model;
}

/* Levels of 1, 2 and 4 mm, the one with a mark only for shadows. */
static void test_levels_are_sorted_from_any_order(void **state)
{
	static const int orders[6][3] = {{1, 2, 4}, {1, 4, 2}, {2, 1, 4},
		{2, 4, 1}, {4, 1, 2}, {4, 2, 1}};

	(void)state;
	for (int i = 0; i < 24; i++) {
		const int *order = orders[i % 6];
		/* None, or the one of 1, 2 or 4 mm. */
		int shadow = 1 << i / 6 >> 1;
		struct model *model = load_text(
			"{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}],"
			"'accessors':[{'componentType':5126,'count':3,"
			"'type':'VEC3'},{'componentType':5121,'count':3,"
			"'type':'SCALAR'}],'meshes':[{'primitives':[{"
			"'attributes':{'POSITION':0}}]},{'primitives':[" COARSE
			"]},{'primitives':[" COARSE "]},{'primitives':[" COARSE
			"]}],'nodes':[{'mesh':0,'extensions':{'MSFT_lod':"
			"{'ids':[1,2,3]}}},{'mesh':1,'extras':{'error_m':0.00%d,"
			"'shape':%s}},{'mesh':2,'extras':{'error_m':0.00%d,"
			"'shape':%s}},{'mesh':3,'extras':{'error_m':0.00%d,"
			"'shape':%s}}]}",
			order[0], order[0] == shadow ? "true" : "false",
			order[1], order[1] == shadow ? "true" : "false",
			order[2], order[2] == shadow ? "true" : "false");
		const struct model_primitive *primitive =
			&model->mesh[0].primitive[0];
		int at = 0;

		assert_int_equal(primitive->lod_count, 3);
		for (int mm = 1; mm <= 4; mm *= 2) {
			const struct model_lod *lod =
				&primitive->lod[mm == shadow ? 2 : at++];

			assert_near(lod->error_m, 0.001 * mm, 1e-7);
			assert_int_equal(lod->shadow_only, mm == shadow);
		}
		model_destroy(model);
	}
}

/* Node 1 is a level of node 0; a test inserts more members. */
static struct model *load(const char *level, const char *more)
{
	return load_text(
		"{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}],"
		"'accessors':[{'componentType':5126,'count':3,'type':'VEC3'},"
		"{'componentType':5121,'count':3,'type':'SCALAR'},"
		"{'componentType':5126,'count':1,'type':'SCALAR'},"
		"{'componentType':5126,'count':1,'type':'VEC3'}],"
		"'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]},"
		"{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}],"
		"'nodes':[{'mesh':0,'extensions':{'MSFT_lod':{'ids':[1]}}},"
		"{'mesh':1,%s}%s}",
		level, more);
}

static void expect_levels(const char *level, const char *more, int count)
{
	struct model *model = load(level, more);

	assert_int_equal(model->mesh[0].primitive[0].lod_count, count);
	assert_int_equal(model->mesh_count, 2 - count);
	model_destroy(model);
}

#define ERROR "'extras':{'error_m':1}"

static void test_another_reference_disqualifies_a_level(void **state)
{
	(void)state;
	expect_levels(ERROR, "]", 1);
	expect_levels(ERROR, ",{'children':[1]}]", 0);
	expect_levels(ERROR, ",{'mesh':1}]", 0);
	expect_levels(ERROR, "],'skins':[{'joints':[1]}]", 0);
	expect_levels(ERROR, "],'skins':[{'joints':[0],'skeleton':1}]", 0);
	expect_levels(ERROR,
		"],'animations':[{'samplers':[{'input':2,'output':3}],"
		"'channels':[{'sampler':0,'target':{'node':1,"
		"'path':'translation'}}]}]",
		0);
}

/* Loads a level of a mesh, with these nodes of the scene and these ids. */
static int count_levels(const char *roots, const char *ids)
{
	struct model *model = load_text(
		"{'asset':{'version':'2.0'},'scenes':[{'nodes':[%s]}],"
		"'accessors':[{'componentType':5126,'count':3,'type':'VEC3'},"
		"{'componentType':5121,'count':3,'type':'SCALAR'}],"
		"'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]},"
		"{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}],"
		"'nodes':[{'mesh':0,'extensions':{'MSFT_lod':{'ids':[%s]}}},"
		"{'mesh':1," ERROR "}]}",
		roots, ids);
	int count = model->mesh[0].primitive[0].lod_count;

	model_destroy(model);
	return count;
}

static void test_a_root_of_the_scene_is_no_level(void **state)
{
	(void)state;
	assert_int_equal(count_levels("0", "1"), 1);
	assert_int_equal(count_levels("0,1", "1"), 0);
	assert_int_equal(count_levels("1,0", "1"), 0);
}

static void test_the_first_16_ids_of_a_node_are_read(void **state)
{
	(void)state;
	assert_int_equal(
		count_levels("0", "7,7,7,7,7,7,7,7,7,7,7,7,7,7,7,1"), 1);
	assert_int_equal(
		count_levels("0", "7,7,7,7,7,7,7,7,7,7,7,7,7,7,7,7,1"), 0);
}

/* The first mesh of the file is a level of the second one. */
static void test_the_first_mesh_may_be_a_level(void **state)
{
	struct model *model = load_text(
		"{'asset':{'version':'2.0'},'scenes':[{'nodes':[0]}],"
		"'accessors':[{'componentType':5126,'count':3,'type':'VEC3'},"
		"{'componentType':5121,'count':3,'type':'SCALAR'}],"
		"'meshes':[{'primitives':[{'attributes':{'POSITION':0},"
		"'indices':1}]},{'primitives':[{'attributes':{'POSITION':0}}]}],"
		"'nodes':[{'mesh':1,'extensions':{'MSFT_lod':{'ids':[1]}}},"
		"{'mesh':0," ERROR "}]}");

	(void)state;
	assert_int_equal(model->mesh_count, 1);
	assert_int_equal(model->mesh[0].primitive[0].lod_count, 1);
	model_destroy(model);
}

static void test_another_transform_disqualifies_a_level(void **state)
{
	(void)state;
	expect_levels(ERROR ",'translation':[0,0,1]", "]", 0);
	expect_levels(ERROR ",'children':[]", "]", 0);
}

static void test_an_unknown_error_disqualifies_a_level(void **state)
{
	(void)state;
	expect_levels("'extras':{'error_m':0}", "]", 0);
	expect_levels("'extras':{'error_m':'much'}", "]", 0);
	expect_levels("'extras':7", "]", 0);
}

static void expect_failure(const char *text, const char *sentence)
{
	struct log_capture logged;
	struct model *model = NULL;

	assert_int_equal(model_from_text(text, &logged, &model), -EINVAL);
	assert_true(log_capture_has(&logged, LOG_ERROR, sentence));
}

/* The level's triangle has the vertices 0, 1 and 2. */
static void test_a_level_with_an_index_out_of_range_is_refused(void **state)
{
	(void)state;
	expect_failure(
		"{'asset':{'version':'2.0'},"
		"'buffers':[{'byteLength':3,'uri':"
		"'data:application/octet-stream;base64,AAEC'}],"
		"'bufferViews':[{'buffer':0,'byteLength':3}],"
		"'accessors':[{'componentType':5126,'count':2,'type':'VEC3'},"
		"{'bufferView':0,'componentType':5121,'count':3,"
		"'type':'SCALAR'}],"
		"'meshes':[{'primitives':[{'attributes':{'POSITION':0}}]},"
		"{'primitives':[{'attributes':{'POSITION':0},'indices':1}]}],"
		"'nodes':[{'mesh':0,'extensions':{'MSFT_lod':{'ids':[1]}}},"
		"{'mesh':1," ERROR "}]}",
		"t.gltf: /meshes/1/primitives/0/indices: index 2 refers to vertex 2, but there are only 2");
}

static void test_invalid_ids_are_ignored(void **state)
{
	static const char *const ids[] = {
		"7", "{}", "[7,-1,'x',1.5,0]", "[[1]]", "null"};

	(void)state;
	for (size_t i = 0; i < 5; i++) {
		struct model *model = load_text(
			"{'asset':{'version':'2.0'},'accessors':"
			"[{'componentType':5126,'count':3,'type':'VEC3'}],"
			"'meshes':[{'primitives':[{'attributes':"
			"{'POSITION':0}}]}],'nodes':[{'mesh':0," ERROR
			",'extensions':{'MSFT_lod':{'ids':%s}}}]}",
			ids[i]);

		assert_int_equal(model->node_count, 1);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_levels_become_index_lists_of_the_full_mesh),
		cmocka_unit_test(test_levels_are_sorted_with_shadow_levels_last),
		cmocka_unit_test(test_levels_become_no_nodes_and_no_meshes),
		cmocka_unit_test(test_indices_behind_a_level_are_remapped),
		cmocka_unit_test(test_other_vertices_disqualify_a_level),
		cmocka_unit_test(test_screen_coverage_gives_the_error_of_a_level),
		cmocka_unit_test(test_screen_coverage_counts_the_longest_side),
		cmocka_unit_test(test_levels_are_sorted_from_any_order),
		cmocka_unit_test(test_another_reference_disqualifies_a_level),
		cmocka_unit_test(test_a_root_of_the_scene_is_no_level),
		cmocka_unit_test(test_the_first_16_ids_of_a_node_are_read),
		cmocka_unit_test(test_the_first_mesh_may_be_a_level),
		cmocka_unit_test(test_another_transform_disqualifies_a_level),
		cmocka_unit_test(test_an_unknown_error_disqualifies_a_level),
		cmocka_unit_test(
			test_a_level_with_an_index_out_of_range_is_refused),
		cmocka_unit_test(test_invalid_ids_are_ignored),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
