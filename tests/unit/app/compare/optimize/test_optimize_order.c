/* Which accessors may be put into another order. */
#include "app/compare/optimize/optimize_order.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	GROUPS_MAX = 4
};

/* Accessors of a file: positions, then a group's normals and its list. */
static int normals_of(int group)
{
	return 1 + 2 * group;
}

static int list_of(int group)
{
	return 2 + 2 * group;
}

static void add_accessor(
	json_t *accessors, const char *type, int component, int count)
{
	json_t *accessor = json_pack("{s:s, s:i, s:i}", "type", type,
		"componentType", component, "count", count);

	assert_int_equal(json_array_append_new(accessors, accessor), 0);
}

/* Groups with one array of positions in common, and one with all of its own. */
static char *file_of(int sharing)
{
	json_t *accessors = json_array(), *primitives = json_array();
	json_t *root;
	char *text;

	add_accessor(accessors, "VEC3", 5126, 3);
	for (int i = 0; i <= sharing; i++) {
		json_t *one = i < sharing
			? json_pack("{s:{s:i, s:i}, s:i}", "attributes",
				  "POSITION", 0, "NORMAL", normals_of(i),
				  "indices", list_of(i))
			: json_pack("{s:{s:i}, s:i}", "attributes", "POSITION",
				  normals_of(i), "indices", list_of(i));

		add_accessor(accessors, "VEC3", 5126, 3);
		add_accessor(accessors, "SCALAR", 5123, 3);
		assert_int_equal(json_array_append_new(primitives, one), 0);
	}
	root = json_pack("{s:{s:s}, s:o, s:[{s:o}]}", "asset", "version", "2.0",
		"accessors", accessors, "meshes", "primitives", primitives);
	text = json_dumps(root, JSON_COMPACT);
	assert_non_null(text);
	json_decref(root);
	return text;
}

/* One that has the positions alone is free; each of several is fixed. */
static void check_order(const struct optimize_order *order, int sharing)
{
	bool alone = sharing == 1;

	assert_true((optimize_order_vertices(order, 0) != NULL) == alone);
	for (int i = 0; i <= sharing; i++) {
		bool is_free = i == sharing || alone;

		assert_true((optimize_order_vertices(order, normals_of(i)) !=
				    NULL) == is_free);
		assert_true((optimize_order_list(order, list_of(i)) != NULL) ==
			is_free);
	}
}

static void test_groups_that_share_an_array_keep_their_order(void **state)
{
	(void)state;
	for (int sharing = 1; sharing <= GROUPS_MAX; sharing++) {
		char *text = file_of(sharing);
		struct model_source source = {.name = "test.gltf",
			.data = (const uint8_t *)text,
			.size = strlen(text),
			.memory_bytes = 1 << 20};
		struct log_capture logged;
		struct log log = log_capture_begin(&logged);
		struct gltf_document *document;
		struct optimize_order order = {0};

		assert_int_equal(
			gltf_document_open(&source, &log, &document), 0);
		assert_int_equal(optimize_order_find(&order, document), 0);
		check_order(&order, sharing);
		optimize_order_release(&order);
		gltf_document_close(document);
		free(text);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_groups_that_share_an_array_keep_their_order),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
