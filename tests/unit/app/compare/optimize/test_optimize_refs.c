/* Which nodes other programs need, and which extensions stay. */
#include "app/compare/optimize/optimize_refs.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>

static void test_nodes_that_other_programs_need_are_found(void **state)
{
	static const struct {
		const char *node;
		bool unnamed, named; /* needed, without and with a text */
	} nodes[] = {
		{"{\"mesh\":0}", true, true},
		{"{}", false, false},
		{"{\"camera\":0}", true, true},
		{"{\"extensions\":{}}", true, true},
		{"{\"extras\":1}", true, true},
		{"{\"name\":\"\"}", false, false},
		{"{\"name\":\"hand\"}", false, true},
		{"{\"name\":\"hands\"}", false, false},
		{"{\"children\":[1],\"skin\":0}", false, false},
		{"{\"name\":\"foot\",\"mesh\":0}", true, true},
		{"{\"name\":\"foot\"}", false, true},
	};
	int count = (int)ARRAY_COUNT(nodes);
	json_t *root = json_pack("{s:[]}", "nodes");

	(void)state;
	for (int i = 0; i < count; i++) {
		json_array_append_new(json_object_get(root, "nodes"),
			json_loads(nodes[i].node, 0, NULL));
	}
	for (int named = 0; named < 2; named++) {
		bool *needed = optimize_find_needed(
			root, named ? "look = hand\nstep = foot\n" : NULL);

		assert_non_null(needed);
		for (int i = 0; i < count; i++) {
			if (needed[i] !=
				(named ? nodes[i].named : nodes[i].unnamed)) {
				fail_msg("%s", nodes[i].node);
			}
		}
		free(needed);
	}
	json_decref(root);
}

static void add_name(void *context, const char *name)
{
	strcat(strcat(context, name), " ");
}

/* In each list and object of the file, but not in extras. */
static void test_extensions_stay_by_their_names(void **state)
{
	static const char text[] =
		"{\"extensionsUsed\":[\"KHR_lights_punctual\",\"KHR_material\","
		"\"KHR_materials_\",\"KHR_materials_unlit\",\"MSFT_lod2\",7,"
		"\"EXT_texture_webp\"],\"materials\":[{\"extensions\":{"
		"\"KHR_materials_unlit\":{},\"KHR_material\":{},"
		"\"KHR_materialsX\":{},\"A\":{}}},"
		"{\"extensions\":{\"MSFT_lod2\":{}},\"extras\":{"
		"\"extensions\":{\"B\":{}}},\"deep\":[{\"extensions\":{"
		"\"C\":{},\"MSFT_lod\":{\"extensions\":{\"D\":{}}}}}]}]}";
	static const char wanted[] =
		"{\"extensionsUsed\":[\"KHR_lights_punctual\","
		"\"KHR_materials_\",\"KHR_materials_unlit\","
		"\"EXT_texture_webp\"],\"materials\":[{\"extensions\":{"
		"\"KHR_materials_unlit\":{}}},"
		"{\"extras\":{\"extensions\":{\"B\":{}}},\"deep\":[{"
		"\"extensions\":{\"MSFT_lod\":{}}}]}]}";
	json_t *root = json_loads(text, 0, NULL);
	json_t *stripped = json_loads(wanted, 0, NULL);
	json_t *none = json_pack("{s:[s]}", "extensionsUsed", "E");
	char removed[200] = "";

	(void)state;
	assert_non_null(root);
	assert_non_null(stripped);
	optimize_strip_extensions(root, add_name, removed);
	assert_true(json_equal(root, stripped));
	assert_string_equal(removed, "MSFT_lod2 KHR_material ");
	optimize_strip_extensions(none, add_name, removed);
	assert_int_equal(json_object_size(none), 0);
	json_decref(root);
	json_decref(stripped);
	json_decref(none);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_nodes_that_other_programs_need_are_found),
		cmocka_unit_test(test_extensions_stay_by_their_names),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
