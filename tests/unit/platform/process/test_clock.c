#include "platform/process/clock.h"
#include "tests/support/test.h"

#include <errno.h>
#include <time.h>

static void test_fixed_clock_counts_frames(void **state)
{
	struct clock clock = clock_fixed(30, 2);

	(void)state;
	assert_true(clock_tick(&clock) == 2);
	assert_true(clock_tick(&clock) == 2 + 1 / 30.0);
	assert_true(clock_tick(&clock) == 2 + 2 / 30.0);
	assert_int_equal(clock.frame, 3);
}

static void test_fixed_clock_does_not_drift(void **state)
{
	struct clock clock = clock_fixed(30, 0);
	double time_s = 0;

	(void)state;
	for (int i = 0; i <= 30 * 3600; i++) {
		time_s = clock_tick(&clock);
	}
	assert_true(time_s == 3600);
}

static void test_real_clock_follows_the_machine(void **state)
{
	const struct timespec pause = {.tv_nsec = 20000000};
	struct clock clock = clock_real();
	double before_s = clock_tick(&clock);
	double after_s;

	(void)state;
	nanosleep(&pause, NULL);
	after_s = clock_tick(&clock);
	assert_true(before_s >= 0 && before_s < 5);
	assert_true(after_s - before_s >= 0.02);
	assert_true(after_s - before_s < 5);
}

/* In both units; what they have lost is less than a unit. */
static void test_the_monotonic_clock_is_that_of_the_system(void **state)
{
	struct timespec before, after;
	int64_t ns, ms;

	(void)state;
	clock_gettime(CLOCK_MONOTONIC, &before);
	ns = clock_monotonic_ns();
	ms = clock_monotonic_ms();
	clock_gettime(CLOCK_MONOTONIC, &after);
	assert_in_range(ns, before.tv_sec * INT64_C(1000000000) + before.tv_nsec,
		after.tv_sec * INT64_C(1000000000) + after.tv_nsec);
	assert_in_range(ms,
		before.tv_sec * INT64_C(1000) + before.tv_nsec / 1000000,
		after.tv_sec * INT64_C(1000) + after.tv_nsec / 1000000);
}

static void test_a_thread_spends_time_on_work_only(void **state)
{
	const struct timespec pause = {.tv_nsec = 100000000};
	const double begun_s = clock_thread_s();
	const clock_t begun = clock();
	double slept_s, worked_s;

	(void)state;
	nanosleep(&pause, NULL);
	slept_s = clock_thread_s() - begun_s;
	assert_true(slept_s >= 0 && slept_s < 0.09);
	do {
		worked_s = clock_thread_s() - begun_s;
	} while (worked_s < 0.02);
	assert_true(worked_s < 5);
	/* What the process has spent. */
	assert_in_range(
		clock() - begun, CLOCKS_PER_SEC / 100, CLOCKS_PER_SEC / 10);
}

static void test_a_clock_begins_when_and_at_what_it_is_told(void **state)
{
	const struct timespec pause = {.tv_nsec = 100000000};
	struct clock real = clock_real(), fixed = clock_fixed(4, 7);
	int64_t before_ns;
	double time_s;

	(void)state;
	clock_tick(&fixed);
	nanosleep(&pause, NULL);
	before_ns = clock_monotonic_ns();
	clock_begin(&real, 86400);
	time_s = clock_tick(&real) - 86400;
	assert_true(time_s >= 0);
	assert_true(time_s <= (double)(clock_monotonic_ns() - before_ns) * 1e-9);
	clock_begin(&fixed, 86400);
	assert_true(clock_tick(&fixed) == 86400);
	assert_true(clock_tick(&fixed) == 86400.25);
}

static void test_parse_reads_both_kinds(void **state)
{
	struct clock clock = {.fixed = true};

	(void)state;
	assert_int_equal(clock_parse("real", &clock), 0);
	assert_false(clock.fixed);
	assert_in_range(clock.origin_ns, 1, clock_monotonic_ns());
	assert_int_equal(clock_parse("fixed:0.001", &clock), 0);
	assert_int_equal(clock_parse("fixed:29.97", &clock), 0);
	assert_true(clock.fixed);
	assert_true(clock.rate_hz == 29.97);
	assert_true(clock_tick(&clock) == 0);
	assert_int_equal(clock_parse("fixed:1000", &clock), 0);
}

static void test_parse_refuses_anything_else(void **state)
{
	static const char *const cases[] = {"", "Real", "real ", "fixed",
		"fixed:", "fixed:0", "fixed:-5", "fixed:1000.5", "fixed:0.0009",
		"fixed:30fps", "fixed:nan", "fixed=30", "30"};
	struct clock clock;

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		assert_int_equal(clock_parse(cases[i], &clock), -EINVAL);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_fixed_clock_counts_frames),
		cmocka_unit_test(test_fixed_clock_does_not_drift),
		cmocka_unit_test(test_real_clock_follows_the_machine),
		cmocka_unit_test(test_the_monotonic_clock_is_that_of_the_system),
		cmocka_unit_test(test_a_thread_spends_time_on_work_only),
		cmocka_unit_test(test_a_clock_begins_when_and_at_what_it_is_told),
		cmocka_unit_test(test_parse_reads_both_kinds),
		cmocka_unit_test(test_parse_refuses_anything_else),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
