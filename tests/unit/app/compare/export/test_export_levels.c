/* Tests which levels of detail an exported mesh gets. */
#include <stdlib.h>

#include "app/compare/export/export_levels.h"
#include "tests/support/test.h"

enum {
	TRIANGLES_MAX = 1000,
	LODS_MAX = 14,
};

struct levels_test {
	struct glb glb;
	json_t *meshes, *levels;
	uint32_t index[3 * TRIANGLES_MAX];
	struct model_lod lod[2][LODS_MAX];
	struct export_lists lists[2];
};

static void begin(struct levels_test *test, int primitive_count)
{
	static const float corner[2][3] = {{0, 0, 0}, {2, 1, 1}};
	json_t *primitives = json_array();
	int position;

	*test = (struct levels_test){.levels = json_array()};
	for (uint32_t i = 0; i < 3 * TRIANGLES_MAX; i++) {
		test->index[i] = i % 100;
	}
	/* Levels beyond the last one, which none may read, would be the best. */
	for (int i = 0; i < 2 * LODS_MAX; i++) {
		test->lod[i / LODS_MAX][i % LODS_MAX] =
			(struct model_lod){.index_count = 3};
	}
	glb_begin_memory(&test->glb);
	position = glb_add_array(&test->glb, corner, 2, 3, GLB_FLOAT);
	for (int p = 0; p < primitive_count; p++) {
		json_array_append_new(primitives,
			json_pack("{s:{s:i}, s:i}", "attributes", "POSITION",
				position, "indices", 1000 + p));
		test->lists[p] = (struct export_lists){
			.index_count = 3 * TRIANGLES_MAX,
			.lod = test->lod[p],
			.scale = 1.0f,
		};
	}
	test->meshes = json_pack("[{s:o}]", "primitives", primitives);
}

static void add_lod(struct levels_test *test, int primitive, float error,
	int triangles, bool shadow)
{
	struct export_lists *lists = &test->lists[primitive];

	test->lod[primitive][lists->lod_count++] =
		(struct model_lod){.error_m = error,
			.shadow_only = shadow,
			.index_count = 3 * triangles,
			.index = test->index};
}

static void make(struct levels_test *test)
{
	export_level_meshes(
		&test->glb, test->meshes, 0, test->lists, test->levels);
	assert_int_equal(test->glb.error, 0);
}

static void end(struct levels_test *test)
{
	json_decref(test->meshes);
	json_decref(test->levels);
	glb_discard(&test->glb);
}

static const json_t *extras_of(const struct levels_test *test, size_t level)
{
	return json_object_get(json_array_get(test->levels, level), "extras");
}

static double error_of(const struct levels_test *test, size_t level)
{
	return json_real_value(
		json_object_get(extras_of(test, level), "error_m"));
}

/* The accessor of a primitive's indices in a level; 1000 + p is the full list. */
static int indices_of(const struct levels_test *test, size_t level, size_t p)
{
	const json_t *primitives = json_object_get(
		json_array_get(test->meshes, level + 1), "primitives");

	return (int)json_integer_value(
		json_object_get(json_array_get(primitives, p), "indices"));
}

static void test_primitives_share_the_errors_of_a_mesh(void **state)
{
	struct levels_test test;

	(void)state;
	begin(&test, 2);
	add_lod(&test, 0, 1.0f, 400, false);
	add_lod(&test, 1, 2.0f, 500, false);
	add_lod(&test, 0, 3.0f, 200, true);
	make(&test);
	assert_int_equal(json_array_size(test.levels), 3);
	assert_float_equal(error_of(&test, 0), 1.0, 1e-6);
	assert_int_not_equal(indices_of(&test, 0, 0), 1000);
	assert_int_equal(indices_of(&test, 0, 1), 1001);
	assert_float_equal(error_of(&test, 1), 2.0, 1e-6);
	assert_int_equal(indices_of(&test, 1, 0), indices_of(&test, 0, 0));
	assert_int_not_equal(indices_of(&test, 1, 1), 1001);
	assert_true(json_is_true(json_object_get(extras_of(&test, 2), "shape")));
	assert_int_equal(indices_of(&test, 2, 1), 1001);
	end(&test);
}

static void test_levels_that_save_little_are_left_out(void **state)
{
	struct levels_test test;

	(void)state;
	begin(&test, 1);
	add_lod(&test, 0, 1.0f, 900, false);
	add_lod(&test, 0, 2.0f, 700, false);
	add_lod(&test, 0, 3.0f, 600, false);
	add_lod(&test, 0, 4.0f, 0, false);
	make(&test);
	assert_int_equal(json_array_size(test.levels), 1);
	assert_float_equal(error_of(&test, 0), 2.0, 1e-6);
	end(&test);
}

/* A fifth of 1000 triangles is 200. */
static void test_a_level_saves_a_fifth_or_more(void **state)
{
	(void)state;
	for (int triangles = 799; triangles <= 801; triangles++) {
		struct levels_test test;

		begin(&test, 1);
		add_lod(&test, 0, 1.0f, triangles, false);
		make(&test);
		assert_int_equal(json_array_size(test.levels), triangles <= 800);
		end(&test);
	}
}

static void test_levels_of_all_primitives_come_in_order_of_their_errors(
	void **state)
{
	struct levels_test test;

	(void)state;
	begin(&test, 2);
	add_lod(&test, 0, 1.0f, 500, false);
	add_lod(&test, 0, 3.0f, 100, false);
	add_lod(&test, 1, 2.0f, 500, false);
	add_lod(&test, 1, 4.0f, 100, false);
	make(&test);
	assert_int_equal(json_array_size(test.levels), 4);
	for (size_t i = 0; i < 4; i++) {
		assert_near(error_of(&test, i), (double)i + 1.0, 1e-6);
	}
	assert_int_equal(indices_of(&test, 0, 1), 1001);
	assert_int_equal(indices_of(&test, 1, 0), indices_of(&test, 0, 0));
	assert_int_not_equal(indices_of(&test, 2, 0), indices_of(&test, 1, 0));
	assert_int_equal(indices_of(&test, 2, 1), indices_of(&test, 1, 1));
	assert_int_equal(indices_of(&test, 3, 0), indices_of(&test, 2, 0));
	end(&test);
}

/*
 * Of ten levels of half the triangles each, six are kept. Without the finest
 * one the next saves three quarters, so that the third is left out then.
 */
static void test_of_levels_that_save_as_much_the_finer_is_left_out(void **state)
{
	static const int kept[] = {2, 4, 6, 8, 9, 10};
	struct levels_test test;

	(void)state;
	begin(&test, 1);
	test.lists[0].index_count = 3 * 1024;
	for (int i = 1; i <= 10; i++) {
		add_lod(&test, 0, (float)i, 1024 >> i, true);
	}
	make(&test);
	assert_int_equal(json_array_size(test.levels), ARRAY_COUNT(kept));
	for (size_t i = 0; i < ARRAY_COUNT(kept); i++) {
		assert_near(error_of(&test, i), kept[i], 1e-6);
	}
	end(&test);
}

static void test_there_are_no_more_levels_than_the_loader_reads(void **state)
{
	struct levels_test test;

	(void)state;
	begin(&test, 2);
	for (int i = 0; i < 12; i++) {
		add_lod(&test, 0, (float)i + 1.0f, 800 >> i, false);
		add_lod(&test, 1, (float)i + 1.5f, 800 >> i, false);
	}
	make(&test);
	assert_in_range(json_array_size(test.levels), 5, 10);
	for (size_t i = 1; i < json_array_size(test.levels); i++) {
		assert_true(error_of(&test, i) > error_of(&test, i - 1));
	}
	end(&test);
}

/* Four of fourteen save a fifth of the triangles, the others a third. */
static void test_of_too_many_levels_those_that_save_least_are_left_out(
	void **state)
{
	static const int weak[] = {1, 3, 4, 7};
	double triangles = TRIANGLES_MAX;
	struct levels_test test;
	size_t kept = 0;

	(void)state;
	begin(&test, 1);
	for (int i = 0, w = 0; i < LODS_MAX; i++) {
		bool is_weak = w < 4 && weak[w] == i;

		w += is_weak;
		triangles *= is_weak ? 0.79 : 0.7;
		add_lod(&test, 0, (float)i + 1.0f, (int)triangles, false);
	}
	make(&test);
	assert_int_equal(json_array_size(test.levels), 10);
	for (int i = 0, w = 0; i < LODS_MAX; i++) {
		if (w < 4 && weak[w] == i) {
			w++;
			continue;
		}
		assert_float_equal(error_of(&test, kept), (float)(i + 1), 1e-6);
		kept++;
	}
	end(&test);
}

static void test_errors_are_in_the_unit_of_the_file(void **state)
{
	struct levels_test test;
	const json_t *node;
	json_t *nodes;

	(void)state;
	begin(&test, 1);
	test.lists[0].scale = 0.5f;
	add_lod(&test, 0, 1.0f, 400, false);
	make(&test);
	assert_float_equal(error_of(&test, 0), 0.5, 1e-6);
	nodes = json_pack("[{s:i, s:s, s:[i]}, {s:s}]", "mesh", 0, "name",
		"body", "children", 1, "name", "hand");
	export_level_nodes(&test.glb, nodes, test.meshes, test.levels);
	assert_int_equal(json_array_size(nodes), 3);
	node = json_array_get(nodes, 2);
	assert_string_equal(
		json_string_value(json_object_get(node, "name")), "body.lod1");
	assert_null(json_object_get(node, "children"));
	assert_int_equal(json_integer_value(json_object_get(node, "mesh")), 1);
	json_decref(nodes);
	end(&test);
}

/* Lets the first primitive span this much along an axis, and less on others. */
static void set_span(struct levels_test *test, int axis, float span)
{
	float corner[2][3] = {{-1, -1, -1}, {-1, -1, -1}};
	json_t *primitives =
		json_object_get(json_array_get(test->meshes, 0), "primitives");
	int position;

	corner[1][axis] += span;
	corner[1][(axis + 1) % 3] += 0.25f * span;
	position = glb_add_array(&test->glb, corner, 2, 3, GLB_FLOAT);
	json_object_set_new(
		json_object_get(json_array_get(primitives, 0), "attributes"),
		"POSITION", json_integer(position));
}

/* Its longest side on a screen of 640 pixels where the error is one of them. */
static void test_a_level_is_shown_at_its_share_of_the_screen(void **state)
{
	static const float spans[] = {0.0625f, 0.5f, 4.0f};

	(void)state;
	for (int i = 0; i < 9; i++) {
		float span = spans[i / 3];
		struct levels_test test;
		const json_t *shares;
		json_t *nodes;

		begin(&test, 1);
		set_span(&test, i % 3, span);
		add_lod(&test, 0, span / 320.0f, 400, false);
		add_lod(&test, 0, span / 64.0f, 200, false);
		make(&test);
		nodes = json_pack("[{s:i}]", "mesh", 0);
		export_level_nodes(&test.glb, nodes, test.meshes, test.levels);
		shares = json_object_get(
			json_object_get(json_array_get(nodes, 0), "extras"),
			"MSFT_screencoverage");
		assert_int_equal(json_array_size(shares), 3);
		assert_near(json_number_value(json_array_get(shares, 0)), 0.25,
			1e-6);
		assert_near(json_number_value(json_array_get(shares, 1)), 0.01,
			1e-6);
		assert_near(json_number_value(json_array_get(shares, 2)), 0, 0);
		json_decref(nodes);
		end(&test);
	}
}

static double coverage(const json_t *nodes, size_t level)
{
	return json_number_value(json_array_get(
		json_object_get(
			json_object_get(json_array_get(nodes, 0), "extras"),
			"MSFT_screencoverage"),
		level));
}

/* The mesh would be wider than the screen where the error is a pixel. */
static void test_a_level_of_less_error_than_a_pixel_is_always_shown(void **state)
{
	struct levels_test test;
	json_t *nodes = json_pack("[{s:i}]", "mesh", 0);

	(void)state;
	begin(&test, 1);
	add_lod(&test, 0, 0.0f, 700, false);
	add_lod(&test, 0, 2.0f / 960.0f, 400, false);
	add_lod(&test, 0, 2.0f / 480.0f, 200, false);
	make(&test);
	export_level_nodes(&test.glb, nodes, test.meshes, test.levels);
	assert_near(coverage(nodes, 0), 1.0, 0.0);
	assert_near(coverage(nodes, 1), 1.0, 0.0);
	assert_near(coverage(nodes, 2), 0.5625, 1e-6);
	json_decref(nodes);
	end(&test);
}

/* The full mesh's node keeps what levels would have twice. */
static void test_the_node_of_a_level_has_no_children_and_extensions(void **state)
{
	struct levels_test test;
	const json_t *node;
	json_t *nodes = json_pack("[{s:i, s:s, s:[i], s:{s:{}}, s:{s:i}, s:i}]",
		"mesh", 0, "name", "body", "children", 1, "extensions",
		"EXT_any", "extras", "any", 3, "skin", 5);

	(void)state;
	begin(&test, 1);
	add_lod(&test, 0, 1.0f, 400, true);
	make(&test);
	export_level_nodes(&test.glb, nodes, test.meshes, test.levels);
	assert_int_equal(json_array_size(nodes), 2);
	node = json_array_get(nodes, 1);
	assert_int_equal(json_object_size(node), 4);
	assert_string_equal(json_string_value(json_object_get(node, "name")),
		"body.shape1");
	assert_int_equal(json_integer_value(json_object_get(node, "mesh")), 1);
	assert_int_equal(json_integer_value(json_object_get(node, "skin")), 5);
	assert_true(json_equal(
		json_object_get(node, "extras"), extras_of(&test, 0)));
	json_decref(nodes);
	end(&test);
}

static void test_a_file_has_the_extension_if_a_node_has_levels(void **state)
{
	(void)state;
	for (int mesh = 0; mesh < 2; mesh++) {
		struct levels_test test;
		json_t *nodes = json_pack(
			"[{s:s}, {s:i}]", "name", "none", "mesh", mesh);
		const json_t *used;

		begin(&test, 1);
		add_lod(&test, 0, 1.0f, 400, false);
		make(&test);
		export_level_nodes(&test.glb, nodes, test.meshes, test.levels);
		used = json_object_get(test.glb.root, "extensionsUsed");
		assert_int_equal(json_array_size(nodes), mesh == 0 ? 3 : 2);
		assert_int_equal(json_array_size(used), mesh == 0);
		assert_int_equal(json_object_get(json_array_get(nodes, 1),
					 "extensions") != NULL,
			mesh == 0);
		if (used) {
			assert_string_equal(
				json_string_value(json_array_get(used, 0)),
				"MSFT_lod");
		}
		json_decref(nodes);
		end(&test);
	}
}

static void test_mirrored_triangles_are_turned_round(void **state)
{
	static const uint32_t index[] = {0, 1, 2, 5, 4, 3, 2, 4, 6};
	static const uint16_t turned[] = {0, 2, 1, 5, 3, 4, 2, 6, 4};
	struct glb glb;
	size_t before;

	(void)state;
	glb_begin_memory(&glb);
	before = glb.size;
	assert_int_equal(export_triangles(&glb, index, 9, true), 0);
	assert_int_equal(fflush(glb.data), 0);
	assert_memory_equal(glb.memory + before, turned, sizeof(turned));
	glb_discard(&glb);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_primitives_share_the_errors_of_a_mesh),
		cmocka_unit_test(test_levels_that_save_little_are_left_out),
		cmocka_unit_test(test_a_level_saves_a_fifth_or_more),
		cmocka_unit_test(
			test_levels_of_all_primitives_come_in_order_of_their_errors),
		cmocka_unit_test(
			test_of_levels_that_save_as_much_the_finer_is_left_out),
		cmocka_unit_test(
			test_there_are_no_more_levels_than_the_loader_reads),
		cmocka_unit_test(
			test_of_too_many_levels_those_that_save_least_are_left_out),
		cmocka_unit_test(test_errors_are_in_the_unit_of_the_file),
		cmocka_unit_test(
			test_a_level_is_shown_at_its_share_of_the_screen),
		cmocka_unit_test(
			test_a_level_of_less_error_than_a_pixel_is_always_shown),
		cmocka_unit_test(
			test_the_node_of_a_level_has_no_children_and_extensions),
		cmocka_unit_test(
			test_a_file_has_the_extension_if_a_node_has_levels),
		cmocka_unit_test(test_mirrored_triangles_are_turned_round),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
