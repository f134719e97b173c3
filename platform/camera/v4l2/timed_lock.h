/*
 * A lock, and a condition on which threads wait for a time at most. That time
 * passes by the monotonic clock: a board without a clock of its own is set
 * forward by decades when it finds a network.
 */
#ifndef PLATFORM_CAMERA_V4L2_TIMED_LOCK_H
#define PLATFORM_CAMERA_V4L2_TIMED_LOCK_H

#include <pthread.h>
#include <stdbool.h>

struct v4l2_timed_lock {
	pthread_mutex_t mutex;
	pthread_cond_t changed;
};

/* Returns 0 or -errno; v4l2_timed_lock_destroy() releases it. */
int v4l2_timed_lock_init(struct v4l2_timed_lock *lock);
void v4l2_timed_lock_destroy(struct v4l2_timed_lock *lock);

/* The mutex is held. Returns false when the time is over. */
bool v4l2_timed_lock_wait(struct v4l2_timed_lock *lock, int timeout_ms);

#endif
