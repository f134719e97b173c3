/*
 * A V4L2 source, shared by the frame loop and a thread that serves the device.
 *
 * Drivers may block for seconds, even with O_NONBLOCK: in open() and S_FMT
 * while a sensor is set up, in DQBUF while it delivers nothing. So the thread
 * makes every system call. The frame loop exchanges buffer numbers with it
 * under a lock that neither holds during a call.
 *
 * A buffer is in one of four states. The driver has it (queued), it is the
 * newest picture (ready), the frame loop uses it (held), or the frame loop is
 * done with it (returned). When a newer picture arrives, the thread queues an
 * older one that is still ready. Before the thread unmaps the buffers it takes
 * back the ready one and waits until none is held.
 *
 * If the thread is blocked in a driver when the source is destroyed, it is
 * abandoned: it then owns the source, and releases it when the call returns.
 */
#ifndef PLATFORM_CAMERA_V4L2_V4L2_THREAD_H
#define PLATFORM_CAMERA_V4L2_V4L2_THREAD_H

#include "platform/camera/v4l2/session.h"
#include "platform/camera/v4l2/timed_lock.h"

#include <pthread.h>

struct camera_source {
	struct v4l2_timed_lock lock; /* protects the members up to back_new */
	pthread_t thread;
	bool quit, ended, abandoned;

	int ready, held; /* buffers; -1 for none */
	bool returned[V4L2_BUFFERS];
	struct camera_image image[V4L2_BUFFERS];
	bool started;     /* a device streamed since the source was created */
	int64_t heard_ms; /* time of the last picture, or of the start */
	bool any;         /* a picture has come since the source was created */

	char name[V4L2_PATH_BYTES]; /* the device's path */

	/* While out is set there is an outage. The frame loop logs it once. */
	bool out;
	char reason[V4L2_REASON_BYTES];
	bool reason_new; /* reason has not been logged yet */
	bool back_new;   /* the device is back, which has not been logged yet */

	struct log log; /* for the frame loop only */

	struct v4l2_session session; /* for the thread only */
};

/*
 * Initializes the lock and starts the thread; session must be initialized.
 * Returns 0 or -errno.
 */
int v4l2_thread_start(struct camera_source *source);

/*
 * Waits up to timeout_ms for a change. The caller holds the lock. Returns false
 * when the time is over.
 */
bool v4l2_thread_wait(struct camera_source *source, int timeout_ms);

/* Stops the thread and releases the source, or abandons both to the thread. */
void v4l2_thread_stop(struct camera_source *source);

#endif
