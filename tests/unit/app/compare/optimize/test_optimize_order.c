/* Which accessors may be put into another order. */
#include "app/compare/optimize/optimize_order.h"
#include "platform/base/compiler.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdio.h>
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

/* A file whose order was found. */
struct found {
	struct log_capture logged;
	struct gltf_document *document;
	struct optimize_order order;
};

static void begin(struct found *found, const char *text)
{
	struct model_source source = {.name = "test.gltf",
		.data = (const uint8_t *)text,
		.size = strlen(text),
		.memory_bytes = 1 << 20};
	struct log log = log_capture_begin(&found->logged);

	found->order = (struct optimize_order){0};
	assert_int_equal(gltf_document_open(&source, &log, &found->document), 0);
	assert_int_equal(optimize_order_find(&found->order, found->document), 0);
}

static void end(struct found *found)
{
	optimize_order_release(&found->order);
	gltf_document_close(found->document);
}

static void test_groups_that_share_an_array_keep_their_order(void **state)
{
	(void)state;
	for (int sharing = 1; sharing <= GROUPS_MAX; sharing++) {
		char *text = file_of(sharing);
		struct found found;

		begin(&found, text);
		check_order(&found.order, sharing);
		end(&found);
		free(text);
	}
}

#define LISTED(bytes)                                                       \
	"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":3,"  \
	"\"uri\":\"data:application/octet-stream;base64," bytes "\"}],"     \
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":3}],\"accessors\":[" \
	"{\"type\":\"VEC3\",\"componentType\":5126,\"count\":3},"           \
	"{\"type\":\"SCALAR\",\"componentType\":5121,\"count\":3,"          \
	"\"bufferView\":0}],\"meshes\":[{\"primitives\":[{\"attributes\":{" \
	"\"POSITION\":0},\"indices\":1}]}]}"

/* 0, 1, 2 of three vertices, and 0, 1, 3. */
static void test_a_list_with_a_number_out_of_range_keeps_its_order(void **state)
{
	static const char *const texts[] = {LISTED("AAEC"), LISTED("AAED")};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct found found;

		begin(&found, texts[i]);
		assert_int_equal(
			optimize_order_list(&found.order, 1) == NULL, i == 1);
		assert_int_equal(
			optimize_order_vertices(&found.order, 0) == NULL,
			i == 1);
		end(&found);
	}
}

/* Two strips of 30 triangles, of which every seventh one comes next. */
static const char strips[] =
	"{\"asset\":{\"version\":\"2.0\"},"
	"\"buffers\":[{\"byteLength\":180,\"uri\":"
	"\"data:application/octet-stream;base64,"
	"AAECJCMlCAcJKissDg8QMjEzFhUXODk6HB0eIiEjBgUHKCkqDA0OMC8xFBMVNjc4"
	"GhscPj0/BAMFJicoCgsMLi0vEhETNDU2GBkaPDs9AgEDJCUmCAkKLCstEA8RMjM0"
	"FhcYOjk7Hh0fIiMkBgcIKikrDg0PMDEyFBUWODc5HBsdICEiBAUGKCcpDAsNLi8w"
	"EhMUNjU3GhkbPD0+AgMEJiUnCgkLLC0uEBESNDM1GBcZOjs8"
	"\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":180}],"
	"\"accessors\":[{\"type\":\"VEC3\",\"componentType\":5126,\"count\":64},"
	"{\"bufferView\":0,\"type\":\"SCALAR\",\"componentType\":5121,"
	"\"count\":180}],"
	"\"materials\":[{\"alphaMode\":\"%s\"}],"
	"\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},"
	"\"indices\":1,\"material\":0}]}]}";

/* Whether the first two triangles stay apart, as they are in the file. */
static bool keeps_triangles_apart(const char *mode)
{
	char text[1024];
	struct found found;
	const uint32_t *list;
	bool apart = true;

	snprintf(text, sizeof(text), strips, mode);
	begin(&found, text);
	list = optimize_order_list(&found.order, 1);
	assert_non_null(list);
	for (int i = 3; i < 6; i++) {
		/* Vertices are numbered as the list needs them. */
		apart = apart && list[i] > 2;
	}
	end(&found);
	return apart;
}

static void test_blended_triangles_keep_their_order(void **state)
{
	(void)state;
	assert_true(keeps_triangles_apart("BLEND"));
	assert_false(keeps_triangles_apart("OPAQUE"));
	assert_false(keeps_triangles_apart("MASK"));
}

/* Places 0 and 1 of 3 vertices, 2 of two; lists 3 to 6 of 0, 1, 2. */
static const char meshes[] =
	"{\"asset\":{\"version\":\"2.0\"},\"buffers\":[{\"byteLength\":3,"
	"\"uri\":\"data:application/octet-stream;base64,AAEC\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":3}],\"accessors\":["
	"{\"type\":\"VEC3\",\"componentType\":5126,\"count\":3},"
	"{\"type\":\"VEC3\",\"componentType\":5126,\"count\":3},"
	"{\"type\":\"VEC3\",\"componentType\":5126,\"count\":2},"
	"{\"type\":\"SCALAR\",\"componentType\":5121,\"count\":3,"
	"\"bufferView\":0},"
	"{\"type\":\"SCALAR\",\"componentType\":5121,\"count\":2,"
	"\"bufferView\":0},"
	"{\"type\":\"SCALAR\",\"componentType\":5121,\"count\":3,"
	"\"normalized\":true,\"bufferView\":0},"
	"{\"type\":\"SCALAR\",\"componentType\":5120,\"count\":3,"
	"\"bufferView\":0}],\"meshes\":[{\"primitives\":[%s]}]}";

#define OF(places, list, more) \
	"{\"attributes\":{\"POSITION\":" places "},\"indices\":" list more "}"

/* Vertices of lists of triangles are sorted, unless other lists need them. */
static void test_only_vertices_of_whole_triangles_are_sorted(void **state)
{
	static const struct {
		const char *primitives;
		bool sorted;
	} cases[] = {
		{OF("0", "3", ""), true},
		{OF("0", "3", ",\"mode\":4"), true},
		{OF("0", "3", ",\"mode\":1"), false},
		{OF("0", "4", ""), false},
		{OF("0", "5", ""), false},
		{OF("0", "6", ""), false},
		{"{\"attributes\":{\"POSITION\":0}}", false},
		{OF("0", "3", "") "," OF("0", "3", ""), true},
		{OF("0", "3", "") "," OF("0", "3", ",\"mode\":1"), false},
		{OF("0", "3", ",\"mode\":1") "," OF("0", "3", ""), false},
		{OF("0", "3", "") "," OF("1", "3", ""), false},
		{OF("0", "3", ",\"targets\":[{\"POSITION\":1}]"), true},
		{OF("0", "3", ",\"targets\":[{\"POSITION\":2}]"), false},
		{OF("0", "3", ",\"targets\":[{\"POSITION\":1}]") "," OF(
			 "1", "3", ""),
			false},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char text[2048];
		struct found found;

		snprintf(text, sizeof(text), meshes, cases[i].primitives);
		begin(&found, text);
		if ((optimize_order_vertices(&found.order, 0) != NULL) !=
			cases[i].sorted) {
			fail_msg("%s", cases[i].primitives);
		}
		assert_int_equal(optimize_order_list(&found.order, 3) != NULL,
			cases[i].sorted);
		end(&found);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_groups_that_share_an_array_keep_their_order),
		cmocka_unit_test(
			test_a_list_with_a_number_out_of_range_keeps_its_order),
		cmocka_unit_test(test_blended_triangles_keep_their_order),
		cmocka_unit_test(
			test_only_vertices_of_whole_triangles_are_sorted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
