/*
 * A mutex, and a condition that threads wait for with a timeout. The timeout is
 * measured by the monotonic clock, because the real-time clock of a board
 * without a battery jumps by decades when the board finds a network.
 */
#ifndef PLATFORM_CAMERA_V4L2_TIMED_LOCK_H
#define PLATFORM_CAMERA_V4L2_TIMED_LOCK_H

#include <pthread.h>
#include <stdbool.h>

struct v4l2_timed_lock {
	pthread_mutex_t mutex;
	pthread_cond_t changed;
};

/* Returns 0 or -errno. v4l2_timed_lock_destroy() releases the lock. */
int v4l2_timed_lock_init(struct v4l2_timed_lock *lock);
void v4l2_timed_lock_destroy(struct v4l2_timed_lock *lock);

/*
 * Waits for a signal of changed. The caller holds the mutex. Returns false
 * after timeout_ms.
 */
bool v4l2_timed_lock_wait(struct v4l2_timed_lock *lock, int timeout_ms);

#endif
