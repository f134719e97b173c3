#define _GNU_SOURCE /* RTLD_NEXT, getpriority() */

#include "platform/process/background.h"
#include "tests/support/test.h"

#include <dlfcn.h>
#include <errno.h>
#include <stdatomic.h>
#include <sys/resource.h>
#include <time.h>

static bool no_threads; /* can be created */

/* Takes the place of the C library's, which it calls. */
int pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
	void *(*run)(void *context), void *context)
{
	int (*create)(
		pthread_t *, const pthread_attr_t *, void *(*)(void *), void *);

	*(void **)&create = dlsym(RTLD_NEXT, "pthread_create");
	return no_threads ? EAGAIN : create(thread, attributes, run, context);
}

struct task {
	atomic_bool may_end;
	atomic_int done;
	int value;
};

static void nap(void)
{
	const struct timespec while_ns = {.tv_nsec = 1000000};

	(void)nanosleep(&while_ns, NULL);
}

/* Goes on after 20 seconds, as nobody can allow it while the caller waits. */
static void count_once_allowed(void *context)
{
	struct task *task = context;

	for (int i = 0; i < 20000 && !atomic_load(&task->may_end); i++) {
		nap();
	}
	task->value++;
	atomic_fetch_add(&task->done, 1);
}

static void test_the_task_runs_beside_the_caller(void **state)
{
	struct background background = {0};
	struct task task = {0};

	(void)state;
	background_begin(&background, count_once_allowed, &task);
	for (int i = 0; i < 20; i++) {
		nap();
	}
	assert_int_equal(atomic_load(&task.done), 0);
	atomic_store(&task.may_end, true);
	background_wait(&background);
	assert_int_equal(task.value, 1);
}

static void test_beginning_waits_for_the_former_task(void **state)
{
	struct background background = {0};
	struct task first = {.may_end = true};
	struct task second = {.may_end = true};

	(void)state;
	for (int i = 1; i <= 20; i++) {
		background_begin(&background, count_once_allowed, &first);
		background_begin(&background, count_once_allowed, &second);
		assert_int_equal(first.value, i);
		background_wait(&background);
		assert_int_equal(second.value, i);
	}
}

static void keep_priority(void *context)
{
	/* Of this thread. */
	*(int *)context = getpriority(PRIO_PROCESS, 0);
}

static void test_the_task_has_a_lower_priority(void **state)
{
	struct background background = {0};
	int before = getpriority(PRIO_PROCESS, 0), meanwhile = before;

	(void)state;
	background_begin(&background, keep_priority, &meanwhile);
	background_wait(&background);
	assert_int_equal(meanwhile, before + 5 < 19 ? before + 5 : 19);
	assert_int_equal(getpriority(PRIO_PROCESS, 0), before);
}

static void test_waiting_without_a_task_returns(void **state)
{
	struct background background = {0};
	struct task task = {.may_end = true};

	(void)state;
	background_wait(&background);
	background_begin(&background, count_once_allowed, &task);
	background_wait(&background);
	/* A thread must not be joined again, even if that often passes. */
	assert_false(background.running);
	background_wait(&background);
	assert_int_equal(task.value, 1);
}

struct place {
	pthread_t thread;
	int runs, priority;
};

static void note_place(void *context)
{
	struct place *place = context;

	place->thread = pthread_self();
	place->priority = getpriority(PRIO_PROCESS, 0);
	place->runs++;
}

static void test_without_a_thread_the_task_runs_at_once(void **state)
{
	struct background background = {0};
	struct place place = {0};

	(void)state;
	no_threads = true;
	background_begin(&background, note_place, &place);
	no_threads = false;
	assert_int_equal(place.runs, 1);
	assert_true(pthread_equal(place.thread, pthread_self()));
	assert_int_equal(place.priority, getpriority(PRIO_PROCESS, 0));
	background_wait(&background);
	background_begin(&background, note_place, &place);
	background_wait(&background);
	assert_int_equal(place.runs, 2);
	assert_false(pthread_equal(place.thread, pthread_self()));
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_task_runs_beside_the_caller),
		cmocka_unit_test(test_beginning_waits_for_the_former_task),
		cmocka_unit_test(test_the_task_has_a_lower_priority),
		cmocka_unit_test(test_waiting_without_a_task_returns),
		cmocka_unit_test(test_without_a_thread_the_task_runs_at_once),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
