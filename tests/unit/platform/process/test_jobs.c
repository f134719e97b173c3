/* Jobs that several threads do. */
#include "platform/process/jobs.h"
#include "tests/support/test.h"

enum {
	JOBS = 500
};

struct count {
	int runs[JOBS];
	int sum; /* under the lock */
	int fails_at;
};

static int count_job(struct jobs *jobs, int job, void *context)
{
	struct count *count = context;

	count->runs[job]++;
	jobs_lock(jobs);
	count->sum += job;
	jobs_unlock(jobs);
	return job == count->fails_at ? -5 : 0;
}

static void test_each_job_runs_once_in_any_number_of_threads(void **state)
{
	(void)state;
	for (int threads = 1; threads <= 2 * JOBS; threads *= 5) {
		struct count count = {.fails_at = -1};

		assert_int_equal(jobs_run(JOBS, threads, count_job, &count), 0);
		for (int i = 0; i < JOBS; i++) {
			assert_int_equal(count.runs[i], 1);
		}
		assert_int_equal(count.sum, JOBS * (JOBS - 1) / 2);
	}
}

static void test_no_job_begins_after_an_error(void **state)
{
	struct count count = {.fails_at = 7};

	(void)state;
	assert_int_equal(jobs_run(JOBS, 1, count_job, &count), -5);
	assert_int_equal(count.runs[7], 1);
	assert_int_equal(count.runs[8], 0);
	assert_int_equal(jobs_run(JOBS, 3, count_job, &count), -5);
	assert_int_equal(count.runs[JOBS - 1], 0);
}

static void test_no_jobs_are_fine(void **state)
{
	struct count count = {.fails_at = -1};

	(void)state;
	assert_int_equal(jobs_run(0, 4, count_job, &count), 0);
	assert_true(jobs_processors() >= 1);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_job_runs_once_in_any_number_of_threads),
		cmocka_unit_test(test_no_job_begins_after_an_error),
		cmocka_unit_test(test_no_jobs_are_fine),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
