#include "app/cmd/show/pace.h"
#include "platform/process/clock.h"
#include "tests/support/test.h"

#include <string.h>
#include <time.h>

static int64_t cpu_ns(void)
{
	struct timespec now;

	assert_int_equal(clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now), 0);
	return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static void test_frames_are_evenly_spaced(void **state)
{
	struct pace pace = pace_begin(200.0, 0.0);
	int64_t begun = pace.next_ns - pace.period_ns;
	int64_t cpu = cpu_ns();
	int64_t spent;

	(void)state;
	for (int i = 0; i < 40; i++) {
		pace_wait(&pace);
	}
	spent = clock_monotonic_ns() - begun;
	/* No frame is early, however late this machine wakes the loop. */
	assert_true(spent >= 40 * 5000000);
	/* The loop slept in between. */
	assert_true(cpu_ns() - cpu < spent / 2);
}

static void test_a_late_frame_is_not_caught_up(void **state)
{
	struct pace pace = pace_begin(100.0, 0.0);
	int64_t late_ns;

	(void)state;
	pace.next_ns -= 1000000000;
	late_ns = clock_monotonic_ns();
	pace_wait(&pace);
	/* The next frame is a whole period away. */
	assert_true(pace.next_ns >= late_ns + pace.period_ns);
}

static void test_the_screens_own_rate_is_not_slowed_down(void **state)
{
	(void)state;
	assert_true(pace_begin(0.0, 75.0).period_ns < 1000000000 / 75);
	assert_true(pace_begin(0.0, 75.0).period_ns > 1000000000 / 90);
	assert_int_equal(pace_begin(0.0, 0.0).period_ns, 1000000000 / 60);
	assert_int_equal(pace_begin(30.0, 75.0).period_ns, 1000000000 / 30);
}

static void test_none_never_waits(void **state)
{
	struct pace pace = pace_none();
	int64_t begun = clock_monotonic_ns();

	(void)state;
	for (int i = 0; i < 1000; i++) {
		pace_wait(&pace);
	}
	assert_true(clock_monotonic_ns() - begun < 1000000000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_frames_are_evenly_spaced),
		cmocka_unit_test(test_a_late_frame_is_not_caught_up),
		cmocka_unit_test(test_the_screens_own_rate_is_not_slowed_down),
		cmocka_unit_test(test_none_never_waits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
