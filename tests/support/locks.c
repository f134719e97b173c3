/*
 * In the tests of this machine and of ARM the linker redirects limber's calls
 * of three functions of pthread here (--wrap in TEST_LDFLAGS). They end the
 * program if the mutex is not locked: a lock that is missing would otherwise
 * show once in thousands of runs.
 */
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* The C library's functions; NULL in programs linked without --wrap. */
#define REAL __attribute__((weak))
REAL int __real_pthread_mutex_unlock(pthread_mutex_t *mutex);
REAL int __real_pthread_cond_wait(
	pthread_cond_t *condition, pthread_mutex_t *mutex);
REAL int __real_pthread_cond_timedwait(pthread_cond_t *condition,
	pthread_mutex_t *mutex, const struct timespec *until);

int __wrap_pthread_mutex_unlock(pthread_mutex_t *mutex);
int __wrap_pthread_cond_wait(pthread_cond_t *condition, pthread_mutex_t *mutex);
int __wrap_pthread_cond_timedwait(pthread_cond_t *condition,
	pthread_mutex_t *mutex, const struct timespec *until);

static void expect_locked(pthread_mutex_t *mutex, const char *call)
{
	if (pthread_mutex_trylock(mutex) == 0) {
		fprintf(stderr, "%s(): the mutex is not locked\n", call);
		abort();
	}
}

int __wrap_pthread_mutex_unlock(pthread_mutex_t *mutex)
{
	expect_locked(mutex, "pthread_mutex_unlock");
	return __real_pthread_mutex_unlock(mutex);
}

int __wrap_pthread_cond_wait(pthread_cond_t *condition, pthread_mutex_t *mutex)
{
	expect_locked(mutex, "pthread_cond_wait");
	return __real_pthread_cond_wait(condition, mutex);
}

int __wrap_pthread_cond_timedwait(pthread_cond_t *condition,
	pthread_mutex_t *mutex, const struct timespec *until)
{
	expect_locked(mutex, "pthread_cond_timedwait");
	return __real_pthread_cond_timedwait(condition, mutex, until);
}
