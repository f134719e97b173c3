/* A file replaces whole lines of a file that it includes. */
#include "app/character/character_data.h"
#include "tests/support/files.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <string.h>

static void load(struct acting *acting, const char *included, const char *text)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "a.character");

	file_write(path.text, text, strlen(text));
	file_write(path_join(&folder, "b.character").text, included,
		strlen(included));
	acting_begin(acting, "assets/walker.glb");
	acting_load(acting, path.text);
	temp_dir_remove(&folder);
	assert_int_equal(acting->error, 0);
}

static void test_lists_are_replaced_and_not_continued(void **state)
{
	const struct character_parameter *parameter;
	const struct character_clip *clip;
	struct acting acting;

	(void)state;
	load(&acting,
		"[parameter c]\nchoices = x y z\n"
		"[parameter s]\nstops = 0 0.25 0.5\n"
		"[clip walk]\nmarks = 0.1 0.2 0.3\n",
		"include = b.character\n"
		"[parameter c]\nchoices = one two\n"
		"[parameter s]\nstops = 0.125 1\n"
		"[clip walk]\nmarks = 0.5 0.75\n");
	parameter = acting.character->parameter;
	assert_int_equal(parameter[0].choice_count, 2);
	assert_string_equal(parameter[0].choice[0], "one");
	assert_string_equal(parameter[0].choice[1], "two");
	assert_near(parameter[0].range[1], 1, 0);
	assert_int_equal(parameter[1].stop_count, 2);
	assert_all_near(parameter[1].stop, ((float[]){0.125f, 1}), 2, 0);
	clip = &acting.character->clip[model_find_clip(acting.model, "walk")];
	assert_int_equal(clip->mark_count, 2);
	assert_all_near(clip->mark, ((float[]){0.5f, 0.75f}), 2, 0);
	acting_end(&acting);
}

/* What a source leaves out is not that of the included file. */
static void test_a_source_is_replaced_with_its_numbers(void **state)
{
	const struct character_parameter *parameter;
	struct acting acting;

	(void)state;
	load(&acting,
		"[parameter b]\nsource = time 2 3\n"
		"[parameter t]\nsource = time 2 3\n"
		"[parameter p]\nsource = sine 4 0.5\n",
		"include = b.character\n"
		"[parameter b]\nsource = buttons\n"
		"[parameter t]\nsource = time\n"
		"[parameter p]\nsource = t\n");
	parameter = acting.character->parameter;
	assert_int_equal(parameter[0].source, CHARACTER_SOURCE_ACTIONS);
	assert_int_equal(parameter[1].source, CHARACTER_SOURCE_TIME);
	assert_int_equal(parameter[2].source, CHARACTER_SOURCE_PARAMETER);
	assert_ptr_equal(parameter[2].other, &parameter[1].value);
	for (int i = 0; i < 3; i++) {
		assert_near(parameter[i].scale, 1, 0);
		assert_near(parameter[i].offset, 0, 0);
	}
	acting_end(&acting);
}

static void test_choices_replace_a_range(void **state)
{
	const struct character_parameter *parameter;
	struct acting acting;

	(void)state;
	load(&acting, "[parameter r]\nrange = 5 9\n",
		"include = b.character\n[parameter r]\nchoices = a b c\n");
	parameter = acting.character->parameter;
	assert_near(parameter->range[0], 0, 0);
	assert_near(parameter->range[1], 2, 0);
	assert_near(parameter->start, 0, 0);
	acting_end(&acting);
}

static void test_a_number_replaces_a_parameter_of_a_freedom(void **state)
{
	const struct character_part *part;
	struct acting acting;

	(void)state;
	load(&acting, "[parameter p]\n[part head]\npitch = p\nbank = p\n",
		"include = b.character\n[part head]\npitch = 5\n");
	part = acting.character->part;
	assert_null(part->follows[CHARACTER_PITCH]);
	assert_near(part->freedom[CHARACTER_PITCH].value, 5, 0);
	assert_ptr_equal(part->follows[CHARACTER_BANK],
		&acting.character->parameter[0].value);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_lists_are_replaced_and_not_continued),
		cmocka_unit_test(test_a_source_is_replaced_with_its_numbers),
		cmocka_unit_test(test_choices_replace_a_range),
		cmocka_unit_test(test_a_number_replaces_a_parameter_of_a_freedom),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
