#include "platform/base/name_list.h"
#include "tests/support/test.h"

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
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
