/*
 * Until when a thread waits, and by which clock. The functions below replace
 * those of the C library, so that no time passes.
 */
#include "platform/base/compiler.h"
#include "platform/camera/v4l2/timed_lock.h"
#include "tests/support/test.h"

#include <errno.h>
#include <time.h>

static struct {
	struct timespec now, until;
	clockid_t read, waited_by;
	int wait_result;
	int attributes_result, clock_result, condition_result, mutex_result;
	const pthread_cond_t *condition;
	const pthread_mutex_t *mutex;
	int conditions_made, conditions_destroyed, mutexes_destroyed;
	int attributes; /* that have not been destroyed */
} libc;

int clock_gettime(clockid_t clock, struct timespec *out)
{
	libc.read = clock;
	*out = libc.now;
	return 0;
}

int pthread_cond_timedwait(pthread_cond_t *condition, pthread_mutex_t *mutex,
	const struct timespec *until)
{
	libc.condition = condition;
	libc.mutex = mutex;
	libc.until = *until;
	return libc.wait_result;
}

int pthread_condattr_init(pthread_condattr_t *attributes)
{
	(void)attributes;
	libc.attributes++;
	return libc.attributes_result;
}

int pthread_condattr_destroy(pthread_condattr_t *attributes)
{
	(void)attributes;
	libc.attributes--;
	return 0;
}

int pthread_cond_init(
	pthread_cond_t *condition, const pthread_condattr_t *attributes)
{
	(void)attributes;
	libc.condition = condition;
	libc.conditions_made++;
	return libc.condition_result;
}

int pthread_condattr_setclock(pthread_condattr_t *attributes, clockid_t clock)
{
	(void)attributes;
	libc.waited_by = clock;
	return libc.clock_result;
}

int pthread_mutex_init(
	pthread_mutex_t *mutex, const pthread_mutexattr_t *attributes)
{
	(void)mutex;
	(void)attributes;
	return libc.mutex_result;
}

int pthread_cond_destroy(pthread_cond_t *condition)
{
	libc.condition = condition;
	libc.conditions_destroyed++;
	return 0;
}

int pthread_mutex_destroy(pthread_mutex_t *mutex)
{
	libc.mutex = mutex;
	libc.mutexes_destroyed++;
	return 0;
}

static void begin(struct v4l2_timed_lock *lock)
{
	libc.attributes_result = libc.clock_result = 0;
	libc.condition_result = libc.mutex_result = 0;
	libc.waited_by = CLOCK_REALTIME;
	libc.conditions_made = libc.attributes = 0;
	assert_int_equal(v4l2_timed_lock_init(lock), 0);
	assert_int_equal(libc.conditions_made, 1);
	assert_ptr_equal(libc.condition, &lock->changed);
	assert_int_equal(libc.attributes, 0);
}

static void test_the_time_passes_by_the_monotonic_clock(void **state)
{
	struct v4l2_timed_lock lock;

	(void)state;
	begin(&lock);
	assert_int_equal(libc.waited_by, CLOCK_MONOTONIC);
	libc.read = CLOCK_REALTIME;
	v4l2_timed_lock_wait(&lock, 20);
	assert_int_equal(libc.read, CLOCK_MONOTONIC);
	assert_ptr_equal(libc.condition, &lock.changed);
	assert_ptr_equal(libc.mutex, &lock.mutex);
	v4l2_timed_lock_destroy(&lock);
}

/* Nanoseconds carry over into seconds, and stay below a second. */
static void test_waits_end_after_their_milliseconds(void **state)
{
	static const int timeouts_ms[] = {
		0, 1, 20, 500, 999, 1000, 1001, 1500, 1999, 2000, 60000};
	static const long begins_ns[] = {0, 1, 500000000, 999000000, 998999999,
		999000001, 979999999, 980000000, 999999999};
	struct v4l2_timed_lock lock;

	(void)state;
	begin(&lock);
	for (size_t i = 0; i < ARRAY_COUNT(timeouts_ms); i++) {
		for (size_t k = 0; k < ARRAY_COUNT(begins_ns); k++) {
			int64_t nanoseconds = begins_ns[k] +
				(int64_t)timeouts_ms[i] * 1000000;

			libc.now.tv_sec = 7;
			libc.now.tv_nsec = begins_ns[k];
			v4l2_timed_lock_wait(&lock, timeouts_ms[i]);
			assert_int_equal(libc.until.tv_sec,
				7 + nanoseconds / 1000000000);
			assert_int_equal(
				libc.until.tv_nsec, nanoseconds % 1000000000);
		}
	}
	v4l2_timed_lock_destroy(&lock);
}

static void test_only_a_change_ends_a_wait_well(void **state)
{
	struct v4l2_timed_lock lock;

	(void)state;
	begin(&lock);
	libc.wait_result = 0;
	assert_true(v4l2_timed_lock_wait(&lock, 5));
	libc.wait_result = ETIMEDOUT;
	assert_false(v4l2_timed_lock_wait(&lock, 5));
	v4l2_timed_lock_destroy(&lock);
}

static void test_both_parts_of_a_lock_are_destroyed(void **state)
{
	struct v4l2_timed_lock lock;

	(void)state;
	begin(&lock);
	libc.conditions_destroyed = libc.mutexes_destroyed = 0;
	v4l2_timed_lock_destroy(&lock);
	assert_int_equal(libc.conditions_destroyed, 1);
	assert_int_equal(libc.mutexes_destroyed, 1);
	assert_ptr_equal(libc.condition, &lock.changed);
	assert_ptr_equal(libc.mutex, &lock.mutex);
}

/* Each call in turn fails; what those before it made is destroyed. */
static void test_a_lock_that_cannot_be_made_is_an_error(void **state)
{
	int *const results[] = {&libc.attributes_result, &libc.clock_result,
		&libc.condition_result, &libc.mutex_result};
	struct v4l2_timed_lock lock;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(results); i++) {
		begin(&lock);
		libc.conditions_destroyed = 0;
		*results[i] = i % 2 ? EAGAIN : ENOMEM;
		assert_int_equal(v4l2_timed_lock_init(&lock), -*results[i]);
		assert_int_equal(libc.attributes, i == 0);
		assert_int_equal(libc.conditions_destroyed, i == 3);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_time_passes_by_the_monotonic_clock),
		cmocka_unit_test(test_waits_end_after_their_milliseconds),
		cmocka_unit_test(test_only_a_change_ends_a_wait_well),
		cmocka_unit_test(test_both_parts_of_a_lock_are_destroyed),
		cmocka_unit_test(test_a_lock_that_cannot_be_made_is_an_error),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
