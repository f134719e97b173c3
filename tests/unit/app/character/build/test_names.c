/* Names of a model and of sections, and the order of what sections do. */
#include "app/character/character_data.h"
#include "app/character/parts/held.h"
#include "app/character/parts/parts.h"
#include "platform/base/compiler.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

/*
 * Three nodes, twelve morph targets and two clips, of which some have a name of
 * one letter and the last none.
 */
static const char json[] =
	"{\"asset\":{\"version\":\"2.0\"},\"scene\":0,"
	"\"scenes\":[{\"nodes\":[0,1,2]}],"
	"\"nodes\":[{%s},{%s\"mesh\":0},{}],"
	"\"meshes\":[{\"extras\":{\"targetNames\":[\"s\",\"\",\"\",\"\","
	"\"\",\"\",\"\",\"\",\"\",\"\",\"\",\"\"]},\"primitives\":[{"
	"\"attributes\":{\"POSITION\":0},\"targets\":["
	"{\"POSITION\":0},{\"POSITION\":0},{\"POSITION\":0},"
	"{\"POSITION\":0},{\"POSITION\":0},{\"POSITION\":0},"
	"{\"POSITION\":0},{\"POSITION\":0},{\"POSITION\":0},"
	"{\"POSITION\":0},{\"POSITION\":0},{\"POSITION\":0}]}]}],"
	"\"animations\":[{\"name\":\"g\",\"channels\":[{\"sampler\":0,"
	"\"target\":{\"node\":0,\"path\":\"translation\"}}],"
	"\"samplers\":[{\"input\":1,\"output\":2}]},"
	"{\"channels\":[{\"sampler\":0,"
	"\"target\":{\"node\":0,\"path\":\"translation\"}}],"
	"\"samplers\":[{\"input\":1,\"output\":2}]}],"
	"\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,"
	"\"type\":\"VEC3\",\"min\":[0,0,0],\"max\":[1,1,1]},"
	"{\"bufferView\":1,\"componentType\":5126,\"count\":2,"
	"\"type\":\"SCALAR\",\"min\":[0],\"max\":[1]},"
	"{\"bufferView\":0,\"componentType\":5126,\"count\":2,"
	"\"type\":\"VEC3\"}],"
	"\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},"
	"{\"buffer\":0,\"byteOffset\":36,\"byteLength\":8}],"
	"\"buffers\":[{\"byteLength\":44,\"uri\":\"names.bin\"}]}";

static void begin(struct acting *acting, const char *first, const char *second)
{
	static const float data[11] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "names.bin");
	char text[sizeof(json) + 64];

	file_write(path.text, data, sizeof(data));
	path = path_join(&folder, "names.gltf");
	snprintf(text, sizeof(text), json, first, second);
	file_write(path.text, text, strlen(text));
	acting_begin(acting, path.text);
	temp_dir_remove(&folder);
}

#define BUTTON "[buttons]\nUP = "

static void test_an_error_lists_the_names_that_there_are(void **state)
{
	static const struct {
		const char *text, *error;
	} cases[] = {
		{"[shake x]\nbone = other\n",
			"there is no node named other: there are A, B"},
		{"[state a]\nclip = other\n",
			"there is no clip named other: there are g, 1, rest"},
		{"[state a]\nclip = ,\n",
			"the clip's name is missing: there are g, 1, rest"},
		{"[state a]\nclip = 2\n", "there is no clip named 2: "},
		{"[expression x]\ntargets = other\n",
			"there is no morph target named other: there are s, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11"},
		{"[expression x]\ntargets = 12\n",
			"there is no morph target named 12: "},
		{"[expression x]\ntargets = -1\n",
			"there is no morph target named -1: "},
		{"[expression x]\ntargets = 1x\n",
			"there is no morph target named 1x: "},
		{"[expression x]\ntargets = \"\"\n",
			"the morph target's name is missing: "},
		{BUTTON "play wave\n",
			"there is no layer named wave: add a section [layer wave]"},
		{BUTTON "play ,\n",
			"there is no layer named NAME: add a section [layer NAME]"},
		{BUTTON "play \"\"\n",
			"there is no layer named NAME: add a section [layer NAME]"},
		{"[state]\n", "this kind of section has one name"},
		{"[stat a]\n",
			"there is no such kind of section: use one of character, names, parameter, clip, state, transition, layer, "},
	};
	struct acting acting;

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		acting_read(&acting, cases[i].text);
		assert_int_equal(acting.error, -EINVAL);
		assert_contains(acting.logged.sentence[0], cases[i].error);
	}
	acting_end(&acting);
}

static void test_an_error_says_that_nothing_has_a_name(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "", "");
	acting_read(&acting, "[shake x]\nbone = head\n");
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(acting.logged.sentence[0],
		"there is no node named head: no node of the model has a name");
	acting_end(&acting);
}

static void test_targets_and_clips_have_a_name_or_a_number(void **state)
{
	static const struct {
		const char *name;
		int target;
	} targets[] = {
		{"s", 0}, {"0", 0}, {"1", 1}, {"9", 9}, {"10", 10}, {"11", 11}};
	static const struct {
		const char *name;
		int clip;
	} clips[] = {{"g", 0}, {"0", 0}, {"1", 1}, {"rest", 2}};
	struct acting acting;
	char text[128];

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	for (size_t i = 0; i < ARRAY_COUNT(targets); i++) {
		snprintf(text, sizeof(text), "[expression x]\ntargets = %s\n",
			targets[i].name);
		acting_expect(&acting, text);
		assert_int_equal(acting.character->expression[0].target[0],
			targets[i].target);
	}
	for (size_t i = 0; i < ARRAY_COUNT(clips); i++) {
		snprintf(text, sizeof(text), "[state x]\nclip = %s\n",
			clips[i].name);
		acting_expect(&acting, text);
		assert_ptr_equal(acting.character->machine.state[0].entry[0].of,
			&acting.character->clip[clips[i].clip]);
	}
	acting_end(&acting);
}

/* As an included file may have given it another one. */
static void test_a_name_without_a_value_is_the_models(void **state)
{
	struct acting acting;

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	acting_expect(&acting, "[names]\ng =\n[state a]\nclip = g\n");
	acting_end(&acting);
}

static void test_a_switch_is_on_at_full_weight_unless_told_otherwise(
	void **state)
{
	struct acting acting;
	const struct character_switch *is;

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	acting_expect(&acting, "[shake x]\nbone = A\n");
	is = acting.character->switches[0];
	assert_int_equal(acting.character->switch_count, 1);
	assert_near(*is->weight, 1, 0);
	assert_near(is->fade_s, 0.4, 1e-6);
	assert_true(is->is_on);
	assert_near(is->level, 1, 0);
	assert_near(is->now, 1, 0);
	acting_end(&acting);
}

/* Whatever their order in the file is; those of a stage keep it. */
static void test_operations_run_by_stages(void **state)
{
	static const enum character_stage stages[] = {CHARACTER_STAGE_LAYER,
		CHARACTER_STAGE_MORPH, CHARACTER_STAGE_SEQUENCE,
		CHARACTER_STAGE_PART, CHARACTER_STAGE_BONE, CHARACTER_STAGE_BONE,
		CHARACTER_STAGE_ATTACHED, CHARACTER_STAGE_CLOTH};
	const struct character *character;
	struct acting acting;

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	acting_expect(&acting,
		"[cape c]\nbone = A\n[part A]\nx = 0\n[shake two]\nbone = A\n"
		"[shake one]\nbone = B\n[layer l]\nclip = g\n"
		"[sequence s]\nstep = a 1, A x 0\n"
		"[expression e]\ntargets = s\n");
	character = acting.character;
	assert_int_equal(character->op_count, ARRAY_COUNT(stages));
	for (size_t i = 0; i < ARRAY_COUNT(stages); i++) {
		assert_int_equal(character->op[i].stage, stages[i]);
	}
	assert_string_equal(
		((struct character_switch *)character->op[4].what)->name, "two");
	assert_string_equal(
		((struct character_switch *)character->op[5].what)->name, "one");
	acting_end(&acting);
}

/* A part has two operations, with one section. */
static void test_a_lone_part_has_both_of_its_operations(void **state)
{
	const struct character *character;
	struct acting acting;

	(void)state;
	begin(&acting, "\"name\":\"A\"", "\"name\":\"B\",");
	acting_expect(&acting, "[part A]\nx = 0\n");
	character = acting.character;
	assert_int_equal(character->op_count, 2);
	assert_ptr_equal(character->op[0].run, character_parts_run);
	assert_ptr_equal(character->op[1].run, character_held_run);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_an_error_lists_the_names_that_there_are),
		cmocka_unit_test(test_an_error_says_that_nothing_has_a_name),
		cmocka_unit_test(test_targets_and_clips_have_a_name_or_a_number),
		cmocka_unit_test(test_a_name_without_a_value_is_the_models),
		cmocka_unit_test(
			test_a_switch_is_on_at_full_weight_unless_told_otherwise),
		cmocka_unit_test(test_operations_run_by_stages),
		cmocka_unit_test(test_a_lone_part_has_both_of_its_operations),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
