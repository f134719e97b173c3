/* How often a job is timed, by a clock that only jobs advance. */
#include "app/cmd/bench/bench_time.h"
#include "platform/process/clock.h"
#include "tests/support/test.h"

#include <errno.h>
#include <string.h>

/* The jobs' costs in microseconds, each of which comes in turn. */
static struct {
	double now_us;
	const double *cost_us;
	int cost_count;
	long calls;
} jobs;

/* These replace clock.c, whose functions a program links all or none. */
struct clock clock_real(void)
{
	return (struct clock){.start_s = jobs.now_us};
}

double clock_tick(struct clock *clock)
{
	return (jobs.now_us - clock->start_s) / 1e6;
}

int64_t clock_monotonic_ns(void)
{
	return 0;
}

int64_t clock_monotonic_ms(void)
{
	return 0;
}

struct clock clock_fixed(double rate_hz, double start_s)
{
	return (struct clock){.rate_hz = rate_hz, .start_s = start_s};
}

void clock_begin(struct clock *clock, double start_s)
{
	clock->start_s = start_s;
}

double clock_thread_s(void)
{
	return 0.0;
}

int clock_parse(const char *text, struct clock *out)
{
	(void)text;
	(void)out;
	return -EINVAL;
}

static void work(void *state)
{
	(void)state;
	jobs.now_us += jobs.cost_us[jobs.calls++ % jobs.cost_count];
}

static struct bench_time time_jobs(const double *cost_us, int count, int runs)
{
	static uint64_t data[8];
	struct bench_evictor evictor = {.count = 8, .data = data};
	const struct bench_job job = {.vertex_count = 10, .run = work};

	memset(&jobs, 0, sizeof(jobs));
	jobs.cost_us = cost_us;
	jobs.cost_count = count;
	return bench_time_job(&job, &evictor, runs);
}

/* 8 times 3 us are the first that take 20 us; then three runs, warm and cold. */
static void test_a_short_job_is_repeated_until_it_lasts(void **state)
{
	static const double cost_us[] = {3.0};
	struct bench_time time = time_jobs(cost_us, 1, 3);

	(void)state;
	assert_int_equal(jobs.calls, 1 + 2 + 4 + 8 + 3 * 8 + 3);
	assert_near(time.warm_ns, 300.0, 1e-6);
	assert_near(time.cold_ns, 300.0, 1e-6);
}

static void test_a_job_of_20_us_runs_once(void **state)
{
	static const double lasting_us[] = {20.0}, short_us[] = {19.9};

	(void)state;
	time_jobs(lasting_us, 1, 4);
	assert_int_equal(jobs.calls, 1 + 4 + 4);
	time_jobs(short_us, 1, 4);
	assert_int_equal(jobs.calls, 1 + 2 + 4 * 2 + 4);
}

/* A clock may be too coarse for it, so that the repetitions must end. */
static void test_a_job_without_a_time_runs_a_million_times(void **state)
{
	static const double cost_us[] = {0.0};

	(void)state;
	time_jobs(cost_us, 1, 1);
	assert_int_equal(jobs.calls, (1 << 20) - 1 + (1 << 20) + 1);
}

/* The first cost is that of the run that warms the caches. */
static void test_the_time_is_the_median_of_the_runs(void **state)
{
	static const double odd_us[] = {
		1e3, 50, 30, 90, 20, 40, 80, 60, 70, 1e3, 90};
	static const double even_us[] = {1e3, 50, 30, 90, 20, 80, 60, 70, 1e3};
	struct bench_time time = time_jobs(odd_us, 11, 5);

	(void)state;
	assert_near(time.warm_ns, 4000.0, 1e-6);
	assert_near(time.cold_ns, 8000.0, 1e-6);
	time = time_jobs(even_us, 9, 4);
	assert_near(time.warm_ns, 4000.0, 1e-6);
	assert_near(time.cold_ns, 7500.0, 1e-6);
}

/* A word of each line of an ARM11, which has 32 bytes, is written to before
 * each cold run. */
static void test_caches_are_emptied_before_cold_runs(void **state)
{
	static const double cost_us[] = {20.0};
	const struct bench_job job = {.vertex_count = 1, .run = work};
	uint64_t data[24] = {0};
	struct bench_evictor evictor = {.count = 24, .data = data};

	(void)state;
	jobs.cost_us = cost_us;
	jobs.cost_count = 1;
	bench_time_job(&job, &evictor, 5);
	for (int i = 0; i < 24; i++) {
		assert_int_equal(data[i], i % 4 == 0 ? 5 : 0);
	}
	assert_int_equal(bench_evictor_init(&evictor), 0);
	assert_int_equal(evictor.count, 4 * 1024 * 1024);
	bench_evictor_release(&evictor);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_short_job_is_repeated_until_it_lasts),
		cmocka_unit_test(test_a_job_of_20_us_runs_once),
		cmocka_unit_test(test_a_job_without_a_time_runs_a_million_times),
		cmocka_unit_test(test_the_time_is_the_median_of_the_runs),
		cmocka_unit_test(test_caches_are_emptied_before_cold_runs),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
