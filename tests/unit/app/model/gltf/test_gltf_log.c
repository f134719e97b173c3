/* Warnings about a glTF file: how many there are, and which. */
#include "app/model/model.h"
#include "tests/support/model/model_fixture.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

#define HEAD        "{'asset':{'version':'2.0'},"
#define POINTS      "{'mode':0}"
#define FOUR_POINTS POINTS "," POINTS "," POINTS "," POINTS

static void load(const char *text, struct log_capture *logged)
{
	struct model *model;

	assert_int_equal(model_from_text(text, logged, &model), 0);
	model_destroy(model);
}

static void expect_one(const char *json, const char *sentence)
{
	struct log_capture logged;

	load(json, &logged);
	assert_int_equal(logged.count, 1);
	assert_string_equal(logged.sentence[0], sentence);
}

static void test_what_is_wrong_in_many_places_is_one_warning(void **state)
{
	(void)state;
	expect_one(HEAD "'meshes':[{'primitives':[" FOUR_POINTS "," FOUR_POINTS
			"," FOUR_POINTS "]}]}",
		"t.gltf: /meshes/0/primitives/0: limber does not draw points: export a triangle or two for each (similar: /meshes/0/primitives/1, /meshes/0/primitives/2, /meshes/0/primitives/3 and 8 more)");
}

static void test_two_places_are_both_named(void **state)
{
	(void)state;
	expect_one(HEAD "'meshes':[{'primitives':[" POINTS "," POINTS "]}]}",
		"t.gltf: /meshes/0/primitives/0: limber does not draw points: export a triangle or two for each (similar: /meshes/0/primitives/1)");
}

/* Before, nine others hid the one about lines. */
static void test_many_of_one_kind_hide_no_other_kind(void **state)
{
	struct log_capture logged;

	(void)state;
	load(HEAD "'meshes':[{'primitives':[" FOUR_POINTS "," FOUR_POINTS
		  "," POINTS ",{'mode':1}]}]}",
		&logged);
	assert_int_equal(logged.count, 2);
	assert_string_equal(logged.sentence[1],
		"t.gltf: /meshes/0/primitives/9: limber does not draw lines: export them as thin triangles, such as tubes");
}

#define POINTER_CLIP                                                     \
	"{'samplers':[{'input':0,'output':0}],'channels':[{'sampler':0," \
	"'target':{'path':'pointer'}}]}"

static void test_clips_with_pointers_are_one_warning(void **state)
{
	(void)state;
	expect_one(HEAD "'animations':[" POINTER_CLIP "," POINTER_CLIP
			"," POINTER_CLIP "]}",
		"t.gltf: /animations/0: limber ignores 1 of 1 channels, which KHR_animation_pointer defines (similar: /animations/1, /animations/2)");
}

static void test_extensions_are_each_named_but_at_most_eight(void **state)
{
	struct log_capture logged;

	(void)state;
	load(HEAD "'extensionsRequired':['KHR_materials_a','KHR_materials_b',"
		  "'KHR_materials_c','KHR_materials_d','KHR_materials_e',"
		  "'KHR_materials_f','KHR_materials_g','KHR_materials_h',"
		  "'KHR_materials_i','KHR_materials_j','KHR_materials_k',"
		  "'KHR_materials_l']}",
		&logged);
	assert_int_equal(logged.count, 9);
	assert_contains(logged.sentence[7], "KHR_materials_h");
	assert_string_equal(logged.sentence[8],
		"t.gltf: limber leaves out 4 more warnings about this file");
}

/* Loads a file that requires so many extensions, each of which is a warning. */
static int load_requiring(int count, const char *more,
	struct log_capture *logged, struct model **out)
{
	char text[2000] = HEAD "'extensionsRequired':[";

	for (int i = 0; i < count; i++) {
		size_t used = strlen(text);

		snprintf(text + used, sizeof(text) - used,
			"%s'KHR_materials_%d'", i > 0 ? "," : "", i);
	}
	snprintf(text + strlen(text), sizeof(text) - strlen(text), "%s", more);
	return model_from_text(text, logged, out);
}

static void test_the_eighth_warning_is_the_last_one(void **state)
{
	(void)state;
	for (int count = 7; count <= 10; count++) {
		struct log_capture logged;
		struct model *model;
		char rest[100];

		assert_int_equal(
			load_requiring(count, "]}", &logged, &model), 0);
		model_destroy(model);
		assert_int_equal(logged.count, count <= 8 ? count : 9);
		assert_contains(logged.sentence[6], "KHR_materials_6");
		if (count == 8) {
			assert_contains(logged.sentence[7], "KHR_materials_7");
		}
		if (count > 8) {
			snprintf(rest, sizeof(rest),
				"t.gltf: limber leaves out %d more warnings about this file",
				count - 8);
			assert_string_equal(logged.sentence[8], rest);
		}
	}
}

/* Only warnings are left out, also where the file cannot be read at last. */
static void test_an_error_is_told_after_any_warnings(void **state)
{
	(void)state;
	for (int count = 7; count <= 12; count++) {
		struct log_capture logged;
		struct model *model;
		int warnings = count < 8 ? count : 8;

		assert_true(load_requiring(count, ",'KHR_draco']}", &logged,
				    &model) < 0);
		assert_null(model);
		assert_int_equal(logged.count, warnings + 1 + (count > 8));
		assert_int_equal(logged.level[warnings], LOG_ERROR);
		assert_contains(logged.sentence[warnings], "KHR_draco");
	}
}

static void test_warnings_precede_the_error_that_ends_the_load(void **state)
{
	struct log_capture logged;
	struct model *model;

	(void)state;
	assert_true(model_from_text(HEAD "'meshes':[{'primitives':[" POINTS
					 "]}],'nodes':[{'mesh':7}]}",
			    &logged, &model) < 0);
	assert_int_equal(logged.count, 2);
	assert_contains(logged.sentence[0], "limber does not draw points");
	assert_int_equal(logged.level[1], LOG_ERROR);
}

static void test_instances_that_are_not_drawn_are_told(void **state)
{
	struct log_capture logged;

	(void)state;
	load(HEAD "'meshes':[{'primitives':[]}],'nodes':[{'mesh':0,"
		  "'extensions':{'EXT_mesh_gpu_instancing':{}}},{'mesh':0}]}",
		&logged);
	assert_int_equal(logged.count, 1);
	assert_contains(logged.sentence[0],
		"/nodes/0: limber draws one of the instances");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_what_is_wrong_in_many_places_is_one_warning),
		cmocka_unit_test(test_two_places_are_both_named),
		cmocka_unit_test(test_many_of_one_kind_hide_no_other_kind),
		cmocka_unit_test(test_clips_with_pointers_are_one_warning),
		cmocka_unit_test(
			test_extensions_are_each_named_but_at_most_eight),
		cmocka_unit_test(test_the_eighth_warning_is_the_last_one),
		cmocka_unit_test(test_an_error_is_told_after_any_warnings),
		cmocka_unit_test(
			test_warnings_precede_the_error_that_ends_the_load),
		cmocka_unit_test(test_instances_that_are_not_drawn_are_told),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
