/*
 * The main program of tests of the window where limber is built without SDL:
 * one test, which is skipped.
 */
#ifndef TESTS_UNIT_PLATFORM_DISPLAY_WINDOW_NO_WINDOW_H
#define TESTS_UNIT_PLATFORM_DISPLAY_WINDOW_NO_WINDOW_H

#include "platform/display/display.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

static void test_this_target_has_no_window(void **state)
{
	struct log log = log_to_nowhere();

	(void)state;
	assert_null(display_choose("window", &log));
	skip_because("built without SDL: this target has no window");
}

static int skip_the_window(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_this_target_has_no_window),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}

#endif
