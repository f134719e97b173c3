#include "app/cmd/show/frame_stats.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>
#include <time.h>

static void wait_ms(long ms)
{
	struct timespec time = {.tv_nsec = ms * 1000000};

	nanosleep(&time, NULL);
}

static int64_t now_ns(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (int64_t)now.tv_sec * 1000000000 + now.tv_nsec;
}

static void test_waiting_between_frames_is_not_work(void **state)
{
	struct frame_stats stats = {0};

	(void)state;
	for (int i = 0; i < 3; i++) {
		frame_stats_begin(&stats);
		wait_ms(5);
		frame_stats_end(&stats);
		wait_ms(20);
	}
	assert_int_equal(stats.frames, 3);
	assert_true(stats.work_ns >= 15 * 1000000);
	assert_true(stats.work_max_ns >= 5 * 1000000);
	assert_true(stats.apart_max_ns >= 25 * 1000000);
	assert_true(stats.work_ns < stats.ended_ns - stats.first_ns);
}

static void test_latency_lasts_from_the_oldest_press_to_the_end_of_its_frame(
	void **state)
{
	struct frame_stats stats = {0};
	int64_t pressed = now_ns();

	(void)state;
	wait_ms(10);
	frame_stats_begin(&stats);
	frame_stats_press(&stats, now_ns());
	frame_stats_press(&stats, pressed);
	frame_stats_end(&stats);
	assert_int_equal(stats.presses, 2);
	assert_true(stats.latency_max_ns >= 10 * 1000000);
	assert_true(stats.latency_max_ns <= now_ns() - pressed);
	pressed = stats.latency_max_ns;
	frame_stats_begin(&stats);
	frame_stats_end(&stats);
	assert_int_equal(stats.latency_max_ns, pressed);
}

static void test_percentiles_count_frames(void **state)
{
	struct frame_stats stats = {.frames = 100};

	(void)state;
	stats.bucket[10] = 94;
	stats.bucket[30] = 5;
	stats.bucket[FRAME_STATS_BUCKETS - 1] = 1;
	assert_int_equal(frame_stats_percentile_ms(&stats, 0.5), 11);
	assert_int_equal(frame_stats_percentile_ms(&stats, 0.95), 31);
	assert_int_equal(
		frame_stats_percentile_ms(&stats, 1.0), FRAME_STATS_BUCKETS);
}

static void test_the_last_percentile_is_the_longest_frame(void **state)
{
	struct frame_stats stats = {.frames = 3};

	(void)state;
	stats.bucket[4] = 2;
	stats.bucket[7] = 1;
	assert_int_equal(frame_stats_percentile_ms(&stats, 0.0), 5);
	assert_int_equal(frame_stats_percentile_ms(&stats, 1.0), 8);
}

static void test_a_run_without_frames_has_figures_too(void **state)
{
	struct frame_stats stats = {0};
	char text[512] = "";
	FILE *out = fmemopen(text, sizeof(text), "w");

	(void)state;
	frame_stats_write(&stats, out);
	fclose(out);
	assert_true(strstr(text, "{\"frames\": 0,") == text);
	assert_non_null(strstr(text, "\"fps\": 0.00,"));
	assert_non_null(strstr(text, "\"p50\": 0, \"p95\": 0, "));
	assert_null(strstr(text, "nan"));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_waiting_between_frames_is_not_work),
		cmocka_unit_test(
			test_latency_lasts_from_the_oldest_press_to_the_end_of_its_frame),
		cmocka_unit_test(test_percentiles_count_frames),
		cmocka_unit_test(test_the_last_percentile_is_the_longest_frame),
		cmocka_unit_test(test_a_run_without_frames_has_figures_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
