#include "platform/base/compiler.h"
#include "platform/process/library.h"
#include "tests/support/test.h"

#include <string.h>

/* What the tests load from the library of mathematics. */
struct table {
	double (*fabs)(double value);
	double (*cbrt)(double value);
};

static const struct library_slot slots[] = {
	{"fabs", offsetof(struct table, fabs)},
	{"cbrt", offsetof(struct table, cbrt)},
	{"no_such_function", 0},
};

static void test_the_first_library_that_exists_is_opened(void **state)
{
	static const char *const names[] = {
		"libnowhere.so.7", "libm.so.6", "libc.so.6", NULL};
	void *library = library_open(names, NULL);

	(void)state;
	assert_non_null(library);
	assert_ptr_equal(library, library_open(&names[1], NULL));
	assert_ptr_not_equal(library, library_open(&names[2], NULL));
	assert_non_null(library_find(library, "cbrt"));
	assert_null(library_find(library, "no_such_function"));
}

static void test_a_missing_library_has_a_reason(void **state)
{
	static const char *const names[] = {
		"libnowhere.so.7", "libnowhere.so.8", NULL};
	const char *why = "";

	(void)state;
	assert_null(library_open(names, &why));
	assert_contains(why, "libnowhere.so.8: ");
	assert_null(library_open(names, NULL));
	assert_null(library_open(&names[2], &why));
}

static double own_fabs(double value)
{
	return value + 1;
}

static void test_members_that_are_null_are_filled(void **state)
{
	static const char *const names[] = {"libm.so.6", NULL};
	void *library = library_open(names, NULL);
	struct table table = {.fabs = own_fabs};

	(void)state;
	assert_null(library_fill(&table, slots, 2, library_find, library));
	assert_ptr_equal(table.fabs, own_fabs);
	assert_near(table.cbrt(27), 3, 1e-9);
	table.fabs = NULL;
	assert_null(library_fill(&table, slots, 1, library_find, library));
	assert_near(table.fabs(-5), 5, 0);
}

static void test_the_first_function_that_is_missing_is_named(void **state)
{
	static const char *const names[] = {"libm.so.6", NULL};
	void *library = library_open(names, NULL);
	struct table table = {NULL, NULL};

	(void)state;
	assert_string_equal(
		library_fill(&table, slots + 2, 1, library_find, library),
		"no_such_function");
	assert_null(table.fabs);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_first_library_that_exists_is_opened),
		cmocka_unit_test(test_a_missing_library_has_a_reason),
		cmocka_unit_test(test_members_that_are_null_are_filled),
		cmocka_unit_test(
			test_the_first_function_that_is_missing_is_named),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
