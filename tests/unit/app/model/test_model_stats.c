/* model_stats.h: sizes of a model. */
#include "app/model/model_stats.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

static void test_counts_vertices_triangles_and_bytes(void **state)
{
	struct model *model = model_fixture("gltf/mesh/indices.gltf", NULL);
	struct model_stats stats;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.primitive_count, 3);
	assert_int_equal(stats.vertex_count, 12);
	assert_int_equal(stats.triangle_count, 6);
	assert_int_equal(stats.geometry_bytes, 3 * (4 * 12 + 6 * 4));
	assert_int_equal(stats.influence_bytes, 0);
	assert_int_equal(stats.target_bytes, 0);
	assert_int_equal(stats.clip_bytes, 0);
	assert_int_equal(stats.max_influences, 0);
	model_destroy(model);
}

static void test_counts_every_vertex_attribute(void **state)
{
	struct model *model =
		model_fixture("gltf/accessor/interleaved.gltf", NULL);
	struct model_stats stats;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.geometry_bytes, 3 * (12 + 12 + 8 + 4) + 3 * 4);
	model_destroy(model);
}

static void test_each_vertex_attribute_takes_its_bytes(void **state)
{
	static float normal[2][3], tangent[2][4], texcoord[2][2];
	static uint8_t color[2][4];
	static const size_t bytes[] = {12, 16, 8, 4};

	(void)state;
	for (int i = 0; i < 16; i++) {
		struct model_primitive primitive = {.vertex_count = 2,
			.normal = i & 1 ? normal : NULL,
			.tangent = i & 2 ? tangent : NULL,
			.texcoord = i & 4 ? texcoord : NULL,
			.color = i & 8 ? color : NULL};
		const struct model_mesh mesh = {
			.primitive_count = 1, .primitive = &primitive};
		struct model_stats stats = {0};
		size_t each = 12;

		for (int k = 0; k < 4; k++) {
			each += i >> k & 1 ? bytes[k] : 0;
		}
		model_stats_add_mesh(&stats, &mesh);
		assert_int_equal(stats.geometry_bytes, 2 * each);
	}
}

static void test_counts_only_influences_with_a_weight(void **state)
{
	struct model *model = model_fixture("gltf/skin/odd_weights.gltf", NULL);
	struct model_stats stats;
	int k;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.influence_histogram[1], 3);
	assert_int_equal(stats.influence_histogram[2], 1);
	for (k = 3; k <= MODEL_INFLUENCES_MAX; k++) {
		assert_int_equal(stats.influence_histogram[k], 0);
	}
	assert_int_equal(stats.max_influences, 2);
	assert_int_equal(stats.influence_bytes, 4 * 4 * (2 + 4) + 2 * 64);
	model_destroy(model);
}

static void test_counts_five_of_eight_influences(void **state)
{
	struct model *model =
		model_fixture("gltf/skin/eight_influences.gltf", NULL);
	struct model_stats stats;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.influence_histogram[5], 3);
	assert_int_equal(stats.max_influences, 5);
	model_destroy(model);
}

static void test_counts_targets_and_keys(void **state)
{
	struct model *model = model_fixture("gltf/clip/cubic.gltf", NULL);
	struct model_stats stats;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.target_count, 2);
	assert_int_equal(stats.morph_vertex_count, 3);
	assert_int_equal(stats.target_bytes, 2 * 3 * 12);
	assert_int_equal(stats.channel_count, 2);
	assert_int_equal(stats.key_count, 4);
	assert_int_equal(stats.clip_bytes, 2 * 4 * (1 + 6) + 2 * 4 * (1 + 12));
	assert_near(stats.longest_s, 2, 0);
	model_destroy(model);
}

static void test_counts_images(void **state)
{
	struct model *model = model_fixture("gltf/material/textures.gltf", NULL);
	struct model_stats stats;

	(void)state;
	model_measure(model, &stats);
	assert_int_equal(stats.image_bytes, 4 * (4 + 1 + 128));
	model_destroy(model);
}

/* A primitive that limber split at loading counts once, without copies. */
static void test_counts_what_the_file_has(void **state)
{
	static struct model_target target[2];
	static float weight[8] = {0, 0, 0, 1, 1, 1, 1, 1};
	struct model_primitive primitive[] = {
		{.file_index = 4,
			.vertex_count = 9,
			.index_count = 15,
			.target = target},
		{.file_index = 4,
			.vertex_count = 8,
			.repeated_count = 3,
			.index_count = 6,
			.influences = 1,
			.weight = weight,
			.target = target},
		{.file_index = 5,
			.vertex_count = 7,
			.repeated_count = 2,
			.index_count = 3,
			.target = target},
	};
	struct model_mesh mesh = {
		.primitive = primitive, .primitive_count = 3, .target_count = 2};
	struct model_stats stats = {0};

	(void)state;
	model_stats_add_mesh(&stats, &mesh);
	assert_int_equal(stats.primitive_count, 2);
	assert_int_equal(stats.vertex_count, 9 + 5 + 5);
	assert_int_equal(stats.morph_vertex_count, 9 + 5 + 5);
	assert_int_equal(stats.triangle_count, 5 + 2 + 1);
	assert_int_equal(
		stats.geometry_bytes, (9 + 8 + 7) * 12 + (15 + 6 + 3) * 4);
	assert_int_equal(stats.target_count, 2);
	assert_int_equal(stats.influence_histogram[0], 0);
	assert_int_equal(stats.influence_histogram[1], 5);
	mesh.target_count = 0;
	stats = (struct model_stats){0};
	model_stats_add_mesh(&stats, &mesh);
	assert_int_equal(stats.morph_vertex_count, 0);
}

static void test_counts_mesh_by_mesh(void **state)
{
	struct model *model = model_fixture("gltf/mesh/modes.gltf", NULL);
	struct model_stats stats = {0};

	(void)state;
	model_stats_add_mesh(&stats, &model->mesh[6]);
	assert_int_equal(stats.primitive_count, 2);
	assert_int_equal(stats.triangle_count, 3 + 1);
	model_stats_add_mesh(&stats, &model->mesh[7]);
	assert_int_equal(stats.triangle_count, 3 + 1 + 2);
	model_destroy(model);
}

/* A list with corners of the full list has two numbers a corner. */
static void test_counts_levels_of_detail(void **state)
{
	static uint32_t index[6];
	static struct model_lod lod[3] = {
		{.index_count = 6, .index = index, .error_m = 0.25f},
		{.index_count = 3,
			.index = index,
			.corner = index,
			.error_m = 0.125f},
		{.index_count = 3, .index = index, .shadow_only = true}};
	struct model *model = model_fixture("gltf/mesh/indices.gltf", NULL);
	struct model_primitive two[2] = {
		{.index_count = 300, .lod_count = 3, .lod = lod},
		{.index_count = 30, .lod_count = 1, .lod = lod + 1}};
	const struct model_mesh mesh = {.primitive_count = 2, .primitive = two};
	struct model_stats stats;
	struct model_level level;

	(void)state;
	model->mesh[0].primitive[0].lod = lod;
	model->mesh[0].primitive[0].lod_count = 3;
	model_measure(model, &stats);
	assert_int_equal(stats.geometry_bytes,
		3 * (4 * 12 + 6 * 4) + (6 + 2 * 3 + 3) * 4);
	model_destroy(model);
	assert_int_equal(model_level_count(&mesh), 3);
	level = model_level(&mesh, 0);
	assert_int_equal(level.triangle_count, 2 + 1);
	assert_near(level.error_m, 0.25, 0);
	/* What has no such level keeps all its triangles. */
	level = model_level(&mesh, 1);
	assert_int_equal(level.triangle_count, 1 + 10);
	assert_near(level.error_m, 0.125, 0);
	assert_false(level.shadow_only);
	level = model_level(&mesh, 2);
	assert_int_equal(level.triangle_count, 1 + 10);
	assert_true(level.shadow_only);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_counts_vertices_triangles_and_bytes),
		cmocka_unit_test(test_counts_every_vertex_attribute),
		cmocka_unit_test(test_each_vertex_attribute_takes_its_bytes),
		cmocka_unit_test(test_counts_only_influences_with_a_weight),
		cmocka_unit_test(test_counts_five_of_eight_influences),
		cmocka_unit_test(test_counts_targets_and_keys),
		cmocka_unit_test(test_counts_images),
		cmocka_unit_test(test_counts_what_the_file_has),
		cmocka_unit_test(test_counts_mesh_by_mesh),
		cmocka_unit_test(test_counts_levels_of_detail),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
