#include "platform/base/name_list.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	ROOM = sizeof(((struct name_list *)0)->text) - 1
};

/* A list of one name of so many letters. */
static struct name_list list_of(size_t length)
{
	struct name_list list = {""};
	char name[ROOM + 2];

	memset(name, 'x', length);
	name[length] = '\0';
	name_list_add(&list, name);
	return list;
}

static void test_names_are_separated_by_commas(void **state)
{
	struct name_list list = {""};

	(void)state;
	name_list_add(&list, "walk");
	assert_string_equal(list.text, "walk");
	name_list_add(&list, "run");
	name_list_add(&list, "jump");
	assert_string_equal(list.text, "walk, run, jump");
}

static void test_names_with_blanks_or_commas_stand_in_quotes(void **state)
{
	struct name_list list = {""};

	(void)state;
	name_list_add(&list, "two words");
	name_list_add(&list, "plain");
	name_list_add(&list, "a,b");
	name_list_add(&list, " ");
	assert_string_equal(list.text, "\"two words\", plain, \"a,b\", \" \"");
}

/* Its last byte is needed for the end of the text. */
static void test_a_name_that_just_fits_is_kept(void **state)
{
	struct name_list list = list_of(ROOM);

	(void)state;
	assert_int_equal(strlen(list.text), ROOM);
	list = list_of(ROOM + 1);
	assert_string_equal(list.text, "");
}

static void test_only_names_that_fit_behind_the_others_are_added(void **state)
{
	static const char *const names[] = {"1", "22", "333", "", "a b"};
	static const size_t needed[] = {3, 4, 5, 2, 7};

	(void)state;
	for (size_t i = 0; i < sizeof(needed) / sizeof(needed[0]); i++) {
		for (size_t left = 0; left < 10; left++) {
			struct name_list list = list_of(ROOM - left);
			struct name_list before = list;

			name_list_add(&list, names[i]);
			assert_int_equal(strlen(list.text),
				strlen(before.text) +
					(left >= needed[i] ? needed[i] : 0));
			assert_memory_equal(
				list.text, before.text, strlen(before.text));
		}
	}
}

static void test_shorter_names_follow_one_that_was_dropped(void **state)
{
	struct name_list list = list_of(ROOM - 5);

	(void)state;
	name_list_add(&list, "too long");
	name_list_add(&list, "abc");
	assert_string_equal(list.text + ROOM - 5, ", abc");
}

struct names {
	const char *const *name;
	int count;
};

static void add_all(struct name_choice *choice, const void *context)
{
	const struct names *names = context;

	for (int i = 0; i < names->count; i++) {
		name_choice_add(choice, names->name[i]);
	}
}

/* The list of what a message offers in place of a name. */
static void expect_choice(const char *wanted, const char *const *names,
	int count, const char *expected)
{
	const struct names all = {names, count};
	struct name_choice choice = {.wanted = wanted};

	name_choice_list(&choice, add_all, &all);
	assert_string_equal(choice.list.text, expected);
}

static void test_names_like_the_wanted_one_come_first(void **state)
{
	static const char *const bones[] = {
		"Hips", "rig:Left_Foot", "Door", "No", "left.foot.L", "Handle"};
	static const struct {
		const char *wanted, *expected;
	} cases[] = {
		{"LeftFoot",
			"rig:Left_Foot, left.foot.L, Hips, Door, No, Handle"},
		{"door1", "Door, Hips, rig:Left_Foot, No, left.foot.L, Handle"},
		{"hop", "Hips, rig:Left_Foot, Door, No, left.foot.L, Handle"},
		{"hips", "Hips, rig:Left_Foot, Door, No, left.foot.L, Handle"},
		{"no", "No, Hips, rig:Left_Foot, Door, left.foot.L, Handle"},
		{"handel", "Handle, Hips, rig:Left_Foot, Door, No, left.foot.L"},
		{"", "Hips, rig:Left_Foot, Door, No, left.foot.L, Handle"},
		{"o", "Hips, rig:Left_Foot, Door, No, left.foot.L, Handle"},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		expect_choice(cases[i].wanted, bones, 6, cases[i].expected);
	}
}

/* A skeleton may have a hundred names, and the wanted one may be the last. */
static void test_a_choice_tells_how_many_names_are_left_out(void **state)
{
	char name[100][16], expected[32];
	const char *names[100];
	const struct names all = {names, 100};
	struct name_choice choice = {.wanted = "JOINT_99"};
	int listed = 1;

	(void)state;
	for (int i = 0; i < 100; i++) {
		snprintf(name[i], sizeof(name[i]), "joint-long-%02d", i);
		names[i] = name[i];
	}
	names[99] = "joint 99";
	name_choice_list(&choice, add_all, &all);
	assert_int_equal(strncmp(choice.list.text, "\"joint 99\", ", 12), 0);
	for (const char *at = choice.list.text; (at = strchr(at, ',')); at++) {
		listed++;
	}
	snprintf(expected, sizeof(expected), "%d more", 100 - listed);
	assert_contains(choice.list.text, expected);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_names_are_separated_by_commas),
		cmocka_unit_test(
			test_names_with_blanks_or_commas_stand_in_quotes),
		cmocka_unit_test(test_a_name_that_just_fits_is_kept),
		cmocka_unit_test(
			test_only_names_that_fit_behind_the_others_are_added),
		cmocka_unit_test(test_shorter_names_follow_one_that_was_dropped),
		cmocka_unit_test(test_names_like_the_wanted_one_come_first),
		cmocka_unit_test(test_a_choice_tells_how_many_names_are_left_out),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
