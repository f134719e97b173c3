#include "app/cmd/time_text.h"
#include "tests/support/test.h"

#include <errno.h>

static void test_seconds_frames_and_ticks_are_read(void **state)
{
	static const struct {
		const char *text;
		double time_s;
	} cases[] = {
		{"0", 0},
		{"1.5", 1.5},
		{".25", 0.25},
		{"45f@30", 1.5},
		{"45f", 1.5},
		{"36f@24", 1.5},
		{"29.97f@29.97", 1},
		{"7200t", 1.5},
		{"160t", 1 / 30.0},
		{"0.5t", 0.5 / 4800},
		{"86400", 86400},
		{"2592000f@30", 86400},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		double time_s = -1;

		assert_int_equal(time_parse(cases[i].text, &time_s), 0);
		assert_near(time_s, cases[i].time_s, 1e-12);
	}
}

static void test_anything_else_is_refused(void **state)
{
	static const char *const cases[] = {"", " 1", "-1", "+1", "1s", "1.5x",
		"45f@", "45f@0", "45f@-30", "45f@30x", "45 f", "f@30", "t",
		"1tt", "45f30", "nan", "inf", "1e400", "86401", "45f@nan", "."};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		double time_s = -1;

		assert_int_equal(time_parse(cases[i], &time_s), -EINVAL);
		assert_true(time_s == -1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_seconds_frames_and_ticks_are_read),
		cmocka_unit_test(test_anything_else_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
