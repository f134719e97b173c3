/* glTF meshes: triangle modes, indices, colours, morph weights. */
#include "app/model/model.h"
#include "tests/support/model/deltas.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"
#include "tests/unit/app/model/gltf/buffer.h"

#include <stdio.h>

static void expect_indices(const struct model_primitive *primitive,
	const uint32_t *expected, int count)
{
	assert_int_equal(primitive->index_count, count);
	assert_memory_equal(
		primitive->index, expected, (size_t)count * sizeof(*expected));
}

static void test_ignores_points_and_lines_with_a_warning(void **state)
{
	struct log_capture logged;
	struct model *model = model_fixture("gltf/mesh/modes.gltf", &logged);
	int mode;

	(void)state;
	for (mode = 0; mode < 4; mode++) {
		assert_int_equal(model->mesh[mode].primitive_count, 1);
	}
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"modes.gltf: /meshes/0/primitives/0: limber does not draw points: export a triangle or two for each"));
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/meshes/1/primitives/0: limber does not draw lines: export them as thin triangles, such as tubes (similar: /meshes/2/primitives/0, /meshes/3/primitives/0)"));
	model_destroy(model);
}

static void test_keeps_the_file_numbers_of_later_primitives(void **state)
{
	struct model *model = model_fixture("gltf/mesh/modes.gltf", NULL);

	(void)state;
	assert_int_equal(model->mesh[1].primitive[0].file_index, 1);
	assert_int_equal(model->mesh[5].primitive_count, 2);
	assert_int_equal(model->mesh[5].primitive[0].file_index, 0);
	assert_int_equal(model->mesh[5].primitive[1].file_index, 1);
	model_destroy(model);
}

static void test_ignores_indices_beyond_whole_triangles(void **state)
{
	static const uint32_t expected[3] = {0, 1, 2};
	struct log_capture logged;
	struct model *model = model_fixture("gltf/mesh/modes.gltf", &logged);

	(void)state;
	expect_indices(&model->mesh[4].primitive[0], expected, 3);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/meshes/4/primitives/0: has 5 indices, not a multiple of 3"));
	model_destroy(model);
}

/* glTF 2.0, 3.7.2.1: every second triangle of a strip is reversed. */
static void test_turns_strips_into_triangles_of_one_winding(void **state)
{
	static const uint32_t expected[9] = {0, 1, 2, 1, 3, 2, 2, 3, 4};
	struct model *model = model_fixture("gltf/mesh/modes.gltf", NULL);

	(void)state;
	expect_indices(&model->mesh[5].primitive[0], expected, 9);
	model_destroy(model);
}

static void test_drops_degenerate_triangles_of_strips(void **state)
{
	static const uint32_t expected[6] = {0, 1, 2, 1, 3, 2};
	struct model *model = model_fixture("gltf/mesh/modes.gltf", NULL);

	(void)state;
	expect_indices(&model->mesh[7].primitive[0], expected, 6);
	model_destroy(model);
}

/* Triangles of a strip of which two corners are one vertex, whichever. */
static void test_strips_drop_triangles_with_any_vertex_twice(void **state)
{
	static const uint8_t lists[][6] = {{0, 0, 1}, {1, 0, 0}, {0, 1, 0},
		{2, 2, 2}, {0, 1, 2}, {2, 1, 0}};

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct model *model = buffer_model(lists[i], sizeof(lists[i]),
			"'accessors':[{'componentType':5126,'count':3,"
			"'type':'VEC3'},{'bufferView':0,'componentType':5121,"
			"'count':3,'type':'SCALAR'}],'meshes':[{'primitives':["
			"{'mode':5,'attributes':{'POSITION':0},'indices':1}]}],"
			"'nodes':[{'mesh':0}]");

		assert_int_equal(
			model->mesh[0].primitive[0].index_count, i < 4 ? 0 : 3);
		model_destroy(model);
	}
}

/* A strip or a fan of fewer than three corners has no triangle. */
static void test_strips_and_fans_may_be_too_short(void **state)
{
	(void)state;
	for (int i = 0; i < 8; i++) {
		int mode = 5 + i % 2, corners = 1 + i / 2;
		struct log_capture logged;
		struct model *model;
		char text[512];

		snprintf(text, sizeof(text),
			"{'asset':{'version':'2.0'},'accessors':["
			"{'componentType':5126,'count':%d,'type':'VEC3'}],"
			"'meshes':[{'primitives':[{'mode':%d,'attributes':"
			"{'POSITION':0}}]}],'nodes':[{'mesh':0}]}",
			corners, mode);
		assert_int_equal(model_from_text(text, &logged, &model), 0);
		assert_int_equal(model->mesh[0].primitive[0].index_count,
			corners < 3 ? 0 : 3 * (corners - 2));
		assert_int_equal(logged.count, 0);
		model_destroy(model);
	}
}

static void test_turns_fans_into_triangles(void **state)
{
	static const uint32_t expected[9] = {1, 2, 0, 2, 3, 0, 3, 4, 0};
	struct model *model = model_fixture("gltf/mesh/modes.gltf", NULL);

	(void)state;
	expect_indices(&model->mesh[6].primitive[0], expected, 9);
	model_destroy(model);
}

static void test_reads_indices_of_every_size(void **state)
{
	static const uint32_t expected[6] = {0, 1, 2, 3, 2, 1};
	struct model *model = model_fixture("gltf/mesh/indices.gltf", NULL);
	int i;

	(void)state;
	for (i = 0; i < 3; i++) {
		expect_indices(&model->mesh[i].primitive[0], expected, 6);
	}
	model_destroy(model);
}

/* 0.5 is 188, 0.25 is 137, 0.75 is 225, 0.1 is 89, 0.001 is 3 in sRGB. */
static void test_encodes_linear_colours_as_srgb(void **state)
{
	static const uint8_t expected[3][4] = {
		{0, 188, 255, 255}, {137, 3, 255, 255}, {0, 225, 89, 255}};
	struct model *model = model_fixture("gltf/mesh/colors.gltf", NULL);

	(void)state;
	assert_memory_equal(
		model->mesh[0].primitive[0].color, expected, sizeof(expected));
	model_destroy(model);
}

static void test_keeps_alpha_linear(void **state)
{
	struct model *model = model_fixture("gltf/mesh/colors.gltf", NULL);
	uint8_t(*color)[4] = model->mesh[1].primitive[0].color;

	(void)state;
	assert_int_equal(color[0][3], 0);
	assert_int_equal(color[1][3], 128);
	assert_int_equal(color[2][3], 255);
	assert_int_equal(color[0][1], 188);
	model_destroy(model);
}

static void test_reads_colours_of_bytes_and_shorts(void **state)
{
	static const uint8_t expected[3][4] = {
		{0, 188, 255, 128}, {137, 0, 255, 128}, {0, 224, 90, 128}};
	struct model *model = model_fixture("gltf/mesh/colors.gltf", NULL);

	(void)state;
	assert_memory_equal(
		model->mesh[2].primitive[0].color, expected, sizeof(expected));
	assert_memory_equal(
		model->mesh[3].primitive[0].color, expected, sizeof(expected));
	model_destroy(model);
}

static void test_leaves_absent_attributes_null(void **state)
{
	struct model *model = model_fixture("gltf/mesh/indices.gltf", NULL);
	const struct model_primitive *primitive = &model->mesh[0].primitive[0];

	(void)state;
	assert_non_null(primitive->position);
	assert_null(primitive->normal);
	assert_null(primitive->tangent);
	assert_null(primitive->texcoord);
	assert_null(primitive->color);
	assert_null(primitive->joint);
	assert_null(primitive->weight);
	assert_int_equal(primitive->influences, 0);
	model_destroy(model);
}

static void test_prefers_node_weights_to_mesh_weights(void **state)
{
	static const float expected[3][2] = {{0.75f, 1}, {0.25f, 0.5f}, {0, 0}};
	struct model *model = model_fixture("gltf/mesh/weights.gltf", NULL);
	int i;

	(void)state;
	assert_int_equal(model->weight_count, 6);
	for (i = 0; i < 3; i++) {
		assert_all_near(model->rest_weights +
				fixture_node(model, i)->weight_offset,
			expected[i], 2, 0);
	}
	model_destroy(model);
}

static void test_gives_each_node_its_own_weights(void **state)
{
	struct model *model = model_fixture("gltf/mesh/weights.gltf", NULL);
	bool seen[6] = {false};
	int i;

	(void)state;
	for (i = 0; i < 3; i++) {
		int offset = fixture_node(model, i)->weight_offset;

		assert_true(offset >= 0 && offset + 2 <= 6);
		assert_false(seen[offset] || seen[offset + 1]);
		seen[offset] = seen[offset + 1] = true;
	}
	model_destroy(model);
}

static void test_shares_targets_among_primitives(void **state)
{
	struct model *model = model_fixture("gltf/mesh/weights.gltf", NULL);
	const struct model_mesh *mesh = &model->mesh[0];
	int i;

	(void)state;
	assert_int_equal(mesh->target_count, 2);
	for (i = 0; i < 2; i++) {
		const struct model_target *target =
			&mesh->primitive[i].target[1];
		float moved[3];

		model_deltas_get(&target->position, 2, moved);
		assert_near(moved[2], 2, 0);
		assert_int_equal(target->normal.vertex_count, 0);
	}
	assert_string_equal(mesh->target_name[0], "");
	model_destroy(model);
}

static void test_drops_target_normals_where_the_base_has_none(void **state)
{
	const struct model_target *target;
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},"
			"'accessors':[{'componentType':5126,'count':3,'type':'"
			"VEC3'}],"
			"'meshes':[{'primitives':[{'attributes':{'POSITION':0},"
			"'targets':[{'NORMAL':0,'TANGENT':0}]}]}]}",
			&logged, &model),
		0);
	target = model->mesh[0].primitive[0].target;
	assert_int_equal(target->position.vertex_count, 0);
	assert_int_equal(target->normal.vertex_count, 0);
	assert_int_equal(target->tangent.vertex_count, 0);
	model_destroy(model);
}

#define VEC3_OF_ZEROS "{'componentType':5126,'count':3,'type':'VEC3'}"

static void test_ignores_primitives_without_positions(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'accessors':[" VEC3_OF_ZEROS
			"],'meshes':[{'primitives':[{"
			"'attributes':{'NORMAL':0}},{'attributes':{"
			"'POSITION':0}}]},{'primitives':[]}]}",
			&logged, &model),
		0);
	assert_int_equal(model->mesh[0].primitive_count, 1);
	assert_int_equal(model->mesh[0].primitive[0].file_index, 1);
	assert_int_equal(model->mesh[1].primitive_count, 0);
	assert_true(log_capture_has(&logged, LOG_WARNING,
		"/meshes/0/primitives/0: has no POSITION"));
	model_destroy(model);
}

static void test_keeps_a_zero_normal_zero(void **state)
{
	static const float zeros[9];
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'accessors':[" VEC3_OF_ZEROS
			"],'meshes':[{'primitives':[{"
			"'attributes':{'POSITION':0.0,'NORMAL':0}}]}]}",
			&logged, &model),
		0);
	assert_all_near(model->mesh[0].primitive[0].normal, zeros, 9, 0);
	model_destroy(model);
}

/* Bytes 0 128 255 64, 55 1 255 0 and 255 0 0 255, not marked as normalised. */
static void test_treats_integer_colours_as_normalised(void **state)
{
	static const uint8_t expected[3][4] = {
		{0, 188, 255, 64}, {128, 13, 255, 0}, {255, 0, 0, 255}};
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_int_equal(
		model_from_text(
			"{'asset':{'version':'2.0'},'buffers':[{'byteLength':"
			"12,'uri':'data:;base64,AID/QDcB/wD/AAD/'}],"
			"'bufferViews':[{'buffer':0,'byteLength':12}],"
			"'accessors':[" VEC3_OF_ZEROS ",{'bufferView':0,"
			"'componentType':5121,'count':3,'type':'VEC4'}],"
			"'meshes':[{'primitives':[{'attributes':{"
			"'POSITION':0,'COLOR_0':1}}]}]}",
			&logged, &model),
		0);
	assert_memory_equal(
		model->mesh[0].primitive[0].color, expected, sizeof(expected));
	model_destroy(model);
}

/* A mesh of limber compare says that its targets are key frames. */
static void test_reads_the_mark_of_key_frames(void **state)
{
	static const struct {
		const char *extras;
		bool marked;
	} row[] = {{"", false}, {",'extras':{'keyFrames':true}", true},
		{",'extras':{'keyFrames':1}", false}, {",'extras':3", false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(row); i++) {
		struct log_capture logged;
		struct model *model;
		char text[256];

		snprintf(text, sizeof(text),
			"{'asset':{'version':'2.0'},'meshes':[{'primitives':"
			"[{'attributes':{},'targets':[{},{}]}]%s}]}",
			row[i].extras);
		assert_int_equal(model_from_text(text, &logged, &model), 0);
		assert_int_equal(model->mesh[0].key_frames, row[i].marked);
		model_destroy(model);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_ignores_points_and_lines_with_a_warning),
		cmocka_unit_test(test_keeps_the_file_numbers_of_later_primitives),
		cmocka_unit_test(test_ignores_indices_beyond_whole_triangles),
		cmocka_unit_test(test_turns_strips_into_triangles_of_one_winding),
		cmocka_unit_test(test_drops_degenerate_triangles_of_strips),
		cmocka_unit_test(
			test_strips_drop_triangles_with_any_vertex_twice),
		cmocka_unit_test(test_strips_and_fans_may_be_too_short),
		cmocka_unit_test(test_turns_fans_into_triangles),
		cmocka_unit_test(test_reads_indices_of_every_size),
		cmocka_unit_test(test_encodes_linear_colours_as_srgb),
		cmocka_unit_test(test_keeps_alpha_linear),
		cmocka_unit_test(test_reads_colours_of_bytes_and_shorts),
		cmocka_unit_test(test_leaves_absent_attributes_null),
		cmocka_unit_test(test_prefers_node_weights_to_mesh_weights),
		cmocka_unit_test(test_gives_each_node_its_own_weights),
		cmocka_unit_test(test_shares_targets_among_primitives),
		cmocka_unit_test(
			test_drops_target_normals_where_the_base_has_none),
		cmocka_unit_test(test_ignores_primitives_without_positions),
		cmocka_unit_test(test_keeps_a_zero_normal_zero),
		cmocka_unit_test(test_treats_integer_colours_as_normalised),
		cmocka_unit_test(test_reads_the_mark_of_key_frames),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
