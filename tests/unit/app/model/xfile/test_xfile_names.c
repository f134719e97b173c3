#include "app/model/xfile/xfile_names.h"

#include "tests/support/test.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void test_finds_names_and_nothing_else(void **state)
{
	static const char *const sample[] = {"arm", "ar", "a", "armature", "b",
		"\xff", "\x80x", "arm", "Arm", "a\x01", "zz"};
	struct arena arena = arena_empty();
	struct xfile_names names;

	(void)state;
	assert_int_equal(xfile_names_init(&names, &arena, 16), 0);
	assert_int_equal(xfile_names_find(&names, "arm"), -1);
	for (int i = 0; i < 11; i++) {
		xfile_names_add(&names, sample[i], i);
	}
	xfile_names_add(&names, "", 99);
	for (int i = 0; i < 11; i++) {
		/* Of equal names the first one counts. */
		assert_int_equal(
			xfile_names_find(&names, sample[i]), i == 7 ? 0 : i);
	}
	assert_int_equal(xfile_names_find(&names, ""), -1);
	assert_int_equal(xfile_names_find(&names, "armatur"), -1);
	assert_int_equal(xfile_names_find(&names, "armaturen"), -1);
	assert_int_equal(xfile_names_find(&names, "c"), -1);
	arena_release(&arena);
}

static void test_many_names_keep_their_numbers(void **state)
{
	enum {
		COUNT = 20000
	};
	struct arena arena = arena_empty();
	struct xfile_names names;

	(void)state;
	assert_int_equal(xfile_names_init(&names, &arena, COUNT), 0);
	for (int i = 0; i < COUNT; i++) {
		char name[16];

		snprintf(name, sizeof(name), "%x", (unsigned int)i * 7919u);
		xfile_names_add(&names, arena_strdup(&arena, name), i);
	}
	for (int i = 0; i < COUNT; i++) {
		char name[16];

		snprintf(name, sizeof(name), "%x", (unsigned int)i * 7919u);
		assert_int_equal(xfile_names_find(&names, name), i);
		snprintf(name, sizeof(name), "%x", (unsigned int)i * 7919u + 1);
		assert_int_equal(xfile_names_find(&names, name), -1);
	}
	arena_release(&arena);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_finds_names_and_nothing_else),
		cmocka_unit_test(test_many_names_keep_their_numbers),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
