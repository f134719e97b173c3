/* Jobs that several threads do. */
#define _GNU_SOURCE /* RTLD_NEXT */

#include "platform/process/clock.h"
#include "platform/process/jobs.h"
#include "tests/support/test.h"

#include <dlfcn.h>
#include <pthread.h>
#include <stdatomic.h>
#include <time.h>
#include <unistd.h>

enum {
	JOBS = 500
};

/* What the system says of its processors in place of the truth, unless 0. */
static long processors;

/* Takes the place of the C library's, which it calls. */
long sysconf(int name)
{
	long (*ask)(int);

	if (name == _SC_NPROCESSORS_ONLN && processors) {
		return processors;
	}
	*(void **)&ask = dlsym(RTLD_NEXT, "sysconf");
	return ask(name);
}

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
}

static void test_processors_are_those_of_the_system(void **state)
{
	const long count = sysconf(_SC_NPROCESSORS_ONLN);

	(void)state;
	assert_int_equal(jobs_processors(),
		count < 1                          ? 1
			: count > JOBS_THREADS_MAX ? JOBS_THREADS_MAX
						   : count);
}

static void test_there_are_1_to_as_many_processors_as_threads(void **state)
{
	(void)state;
	for (long count = 1; count <= JOBS_THREADS_MAX; count++) {
		processors = count;
		assert_int_equal(jobs_processors(), count);
	}
	processors = JOBS_THREADS_MAX + 1;
	assert_int_equal(jobs_processors(), JOBS_THREADS_MAX);
	/* The system does not know. */
	processors = -1;
	assert_int_equal(jobs_processors(), 1);
	processors = 0;
}

struct meeting {
	pthread_t caller;
	int expected;
	atomic_int begun, ended;
};

/* Ends when the others have begun, those of other threads a moment later. */
static int meet(struct jobs *jobs, int job, void *context)
{
	const struct timespec moment = {.tv_nsec = 2000000};
	const int64_t begun_ns = clock_monotonic_ns();
	struct meeting *meeting = context;

	(void)jobs;
	(void)job;
	atomic_fetch_add(&meeting->begun, 1);
	while (atomic_load(&meeting->begun) < meeting->expected) {
		nanosleep(&moment, NULL);
		if (clock_monotonic_ns() - begun_ns > 30000000000) {
			return -1;
		}
	}
	for (int i = 0; i < 5; i++) {
		if (!pthread_equal(pthread_self(), meeting->caller)) {
			nanosleep(&moment, NULL);
		}
	}
	atomic_fetch_add(&meeting->ended, 1);
	return 0;
}

static void test_as_many_jobs_run_at_once_as_there_are_threads(void **state)
{
	(void)state;
	for (int threads = 1; threads <= JOBS_THREADS_MAX; threads *= 2) {
		struct meeting meeting = {pthread_self(), threads, 0, 0};

		assert_int_equal(jobs_run(threads, threads, meet, &meeting), 0);
		assert_int_equal(meeting.ended, threads);
	}
}

static int note_thread(struct jobs *jobs, int job, void *context)
{
	(void)jobs;
	(void)job;
	*(pthread_t *)context = pthread_self();
	return 0;
}

/* Threads that find no job would still cost their beginning. */
static void test_one_job_runs_in_the_callers_thread(void **state)
{
	(void)state;
	for (int i = 0; i < 50; i++) {
		pthread_t thread;

		assert_int_equal(
			jobs_run(1, JOBS_THREADS_MAX, note_thread, &thread), 0);
		assert_true(pthread_equal(thread, pthread_self()));
	}
}

struct room {
	atomic_int within, most;
};

static int stay_a_moment(struct jobs *jobs, int job, void *context)
{
	const struct timespec moment = {.tv_nsec = 1000000};
	struct room *room = context;

	(void)job;
	jobs_lock(jobs);
	if (atomic_fetch_add(&room->within, 1) + 1 > atomic_load(&room->most)) {
		atomic_fetch_add(&room->most, 1);
	}
	nanosleep(&moment, NULL);
	atomic_fetch_sub(&room->within, 1);
	jobs_unlock(jobs);
	return 0;
}

static void test_one_job_at_a_time_holds_the_lock(void **state)
{
	struct room room = {0, 0};

	(void)state;
	assert_int_equal(jobs_run(8, 4, stay_a_moment, &room), 0);
	assert_int_equal(room.most, 1);
	assert_int_equal(room.within, 0);
}

/* The first ends when the second has failed, and fails, too. */
static int fail_after_the_second(struct jobs *jobs, int job, void *context)
{
	const struct timespec moment = {.tv_nsec = 20000000};
	atomic_int *begun = context;

	(void)jobs;
	atomic_fetch_add(begun, 1);
	while (atomic_load(begun) < 2) {
		nanosleep(&moment, NULL);
	}
	if (job == 0) {
		nanosleep(&moment, NULL);
	}
	return -1 - job;
}

static void test_the_first_error_is_returned(void **state)
{
	atomic_int begun = 0;

	(void)state;
	assert_int_equal(jobs_run(8, 2, fail_after_the_second, &begun), -2);
	assert_int_equal(begun, 2);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_each_job_runs_once_in_any_number_of_threads),
		cmocka_unit_test(
			test_as_many_jobs_run_at_once_as_there_are_threads),
		cmocka_unit_test(test_one_job_runs_in_the_callers_thread),
		cmocka_unit_test(test_no_job_begins_after_an_error),
		cmocka_unit_test(test_one_job_at_a_time_holds_the_lock),
		cmocka_unit_test(test_the_first_error_is_returned),
		cmocka_unit_test(test_no_jobs_are_fine),
		cmocka_unit_test(test_processors_are_those_of_the_system),
		cmocka_unit_test(
			test_there_are_1_to_as_many_processors_as_threads),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
