#include "platform/camera/v4l2/timed_lock.h"

#include <time.h>

int v4l2_timed_lock_init(struct v4l2_timed_lock *lock)
{
	pthread_condattr_t attributes;
	int error = pthread_condattr_init(&attributes);

	if (error) {
		return -error;
	}
	error = pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
	if (!error) {
		error = pthread_cond_init(&lock->changed, &attributes);
	}
	pthread_condattr_destroy(&attributes);
	if (error) {
		return -error;
	}
	error = pthread_mutex_init(&lock->mutex, NULL);
	if (error) {
		pthread_cond_destroy(&lock->changed);
	}
	return -error;
}

void v4l2_timed_lock_destroy(struct v4l2_timed_lock *lock)
{
	pthread_cond_destroy(&lock->changed);
	pthread_mutex_destroy(&lock->mutex);
}

bool v4l2_timed_lock_wait(struct v4l2_timed_lock *lock, int timeout_ms)
{
	struct timespec until;

	clock_gettime(CLOCK_MONOTONIC, &until);
	until.tv_sec += timeout_ms / 1000;
	until.tv_nsec += (long)(timeout_ms % 1000) * 1000000;
	if (until.tv_nsec >= 1000000000) {
		until.tv_sec++;
		until.tv_nsec -= 1000000000;
	}
	return pthread_cond_timedwait(&lock->changed, &lock->mutex, &until) == 0;
}
