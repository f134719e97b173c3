#include "tests/support/test.h"

#include <fcntl.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum {
	DESCRIPTORS = 1024
};

/* Finds out which of the first DESCRIPTORS descriptors are open. */
static void find_open(bool open[DESCRIPTORS])
{
	for (int fd = 0; fd < DESCRIPTORS; fd++) {
		open[fd] = fcntl(fd, F_GETFD) >= 0;
	}
}

int test_run_group(const char *name, const struct CMUnitTest *tests,
	size_t count, CMFixtureFunction setup, CMFixtureFunction teardown)
{
	bool before[DESCRIPTORS], after[DESCRIPTORS];
	int failed;

	find_open(before);
	failed = _cmocka_run_group_tests(name, tests, count, setup, teardown);
	find_open(after);
	for (int fd = 0; fd < DESCRIPTORS; fd++) {
		char link[64], what[256] = "";

		if (before[fd] == after[fd]) {
			continue;
		}
		snprintf(link, sizeof(link), "/proc/self/fd/%d", fd);
		if (readlink(link, what, sizeof(what) - 1) < 0) {
			what[0] = '\0';
		}
		printf("# descriptor %d was left %s: %s\n", fd,
			after[fd] ? "open" : "closed", what);
		failed++;
	}
	return failed;
}

bool test_is_near(double actual, double expected, double tolerance)
{
	return fabs(actual - expected) <= tolerance || actual == expected;
}

void test_assert_near(double actual, double expected, double tolerance,
	const char *what, const char *file, int line)
{
	if (!test_is_near(actual, expected, tolerance)) {
		print_error("%s is %.9g, not %.9g within %g\n", what, actual,
			expected, tolerance);
		_fail(file, line);
	}
}

void test_assert_all_near(const float *actual, const float *expected,
	size_t count, double tolerance, const char *what, const char *file,
	int line)
{
	for (size_t i = 0; i < count; i++) {
		if (!test_is_near(actual[i], expected[i], tolerance)) {
			print_error(
				"%s: float %zu of %zu is %.9g, not %.9g within %g\n",
				what, i, count, actual[i], expected[i],
				tolerance);
			_fail(file, line);
		}
	}
}

void test_assert_contains(
	const char *text, const char *part, const char *file, int line)
{
	if (!text || !strstr(text, part)) {
		print_error("\"%s\" does not contain \"%s\"\n",
			text ? text : "(null)", part);
		_fail(file, line);
	}
}

void test_skip_because(const char *reason, const char *file, int line)
{
	printf("# skipped: %s\n", reason);
	fflush(stdout);
	_skip(file, line);
}
