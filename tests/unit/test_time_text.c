#include "app/cmd/time_text.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

static void test_reads_seconds_frames_and_ticks_alike(void **state)
{
	static const char *const texts[] = {
		"1.5", "45f@30", "36f@24", "7200t", "37.5f@25", "1.5e0"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		double time_s = 0.0;

		assert_true(time_text_parse(texts[i], &time_s));
		assert_near(time_s, 1.5, 1e-12);
	}
}

static void test_a_frame_of_each_usual_rate_is_whole_ticks(void **state)
{
	static const int rates[] = {24, 25, 30, 50, 60};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rates); i++) {
		assert_int_equal(TIME_TICKS_PER_S % rates[i], 0);
	}
}

static void test_reads_times_before_zero(void **state)
{
	double time_s = 0.0;

	(void)state;
	assert_true(time_text_parse("-2400t", &time_s));
	assert_near(time_s, -0.5, 1e-12);
}

static void test_refuses_what_is_no_time(void **state)
{
	static const char *const texts[] = {"", "soon", "1.5s", "45f", "45f@",
		"45f@0", "45f@-30", "45f@30x", "45f@nan", "7200tt", "t", "nan",
		"inf", "1e400", "1 5"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		double time_s = 7.0;

		assert_false(time_text_parse(texts[i], &time_s));
		assert_near(time_s, 7.0, 0.0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_reads_seconds_frames_and_ticks_alike),
		cmocka_unit_test(test_a_frame_of_each_usual_rate_is_whole_ticks),
		cmocka_unit_test(test_reads_times_before_zero),
		cmocka_unit_test(test_refuses_what_is_no_time),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
