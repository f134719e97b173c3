/*
 * What every unit test includes: cmocka with the headers it wants before it,
 * and comparisons of numbers that cmocka lacks.
 *
 * Not assert_float_equal(): it takes NaN for equal to anything.
 */
#ifndef TESTS_SUPPORT_TEST_H
#define TESTS_SUPPORT_TEST_H

#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

/* Fails unless |actual - expected| <= tolerance; NaN is near nothing. */
#define assert_near(actual, expected, tolerance)                               \
	test_assert_near((actual), (expected), (tolerance), #actual, __FILE__, \
		__LINE__)

/*
 * The same for each of count floats: pointers to the first of each, of any
 * array type (float (*)[3] with 3 * rows as count and so on).
 */
#define assert_all_near(actual, expected, count, tolerance)               \
	test_assert_all_near((const float *)(actual),                     \
		(const float *)(expected), (count), (tolerance), #actual, \
		__FILE__, __LINE__)

/* Fails unless the string holds the part. */
#define assert_contains(text, part) \
	test_assert_contains((text), (part), __FILE__, __LINE__)

/* Ends the test as skipped, with the reason in the report. */
#define skip_because(reason) test_skip_because((reason), __FILE__, __LINE__)

/* What the comparisons go by. */
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
