/*
 * Every unit test includes this: cmocka, the headers that cmocka needs, and
 * comparisons that cmocka lacks.
 *
 * Do not use cmocka's assert_float_equal(): to it, NaN equals any number.
 */
#ifndef TESTS_SUPPORT_TEST_H
#define TESTS_SUPPORT_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Fails unless |actual - expected| <= tolerance; a NaN always fails. */
#define assert_near(actual, expected, tolerance)                               \
	test_assert_near((actual), (expected), (tolerance), #actual, __FILE__, \
		__LINE__)

/*
 * The same for count floats. Pointers of any array type will do, such as
 * float (*)[3] with a count of 3 * rows.
 */
#define assert_all_near(actual, expected, count, tolerance)              \
	test_assert_all_near((const float *)(actual),                    \
		(const float *)(expected), (size_t)(count), (tolerance), \
		#actual, __FILE__, __LINE__)

/* Fails unless the string contains the part. */
#define assert_contains(text, part) \
	test_assert_contains((text), (part), __FILE__, __LINE__)

/*
 * Run all tests, as cmocka does, and then fail if they have left descriptors
 * open: what opens a file, a device or a socket closes it on each path.
 */
#undef cmocka_run_group_tests
#define cmocka_run_group_tests(tests, setup, teardown) \
	cmocka_run_group_tests_name(#tests, tests, setup, teardown)
#undef cmocka_run_group_tests_name
#define cmocka_run_group_tests_name(name, tests, setup, teardown)           \
	test_run_group((name), (tests), sizeof(tests) / sizeof((tests)[0]), \
		(setup), (teardown))

/* Of so many random cases, those that a test tries: a third of them in
 * qemu-arm, where they take minutes. */
#ifdef __arm__
#define RANDOM_CASES(count) ((count) / 3)
#else
#define RANDOM_CASES(count) (count)
#endif

/* Ends the test as skipped and gives the reason to the tally. */
#define skip_because(reason) test_skip_because((reason), __FILE__, __LINE__)

/* What the macros above call. */
int test_run_group(const char *name, const struct CMUnitTest *tests,
	size_t count, CMFixtureFunction setup, CMFixtureFunction teardown);
bool test_is_near(double actual, double expected, double tolerance);

void test_assert_near(double actual, double expected, double tolerance,
	const char *what, const char *file, int line);
void test_assert_all_near(const float *actual, const float *expected,
	size_t count, double tolerance, const char *what, const char *file,
	int line);
void test_assert_contains(
	const char *text, const char *part, const char *file, int line);
void test_skip_because(const char *reason, const char *file, int line);

#endif
