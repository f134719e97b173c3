#include "platform/camera/v4l2/v4l2_thread.h"

#include "platform/base/compiler.h"
#include "platform/process/clock.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
	WAIT_MS = 100,  /* the longest wait for a picture or a change */
	EMPTY_MS = 5,   /* the pause when there is no picture or no buffer */
	LEAVE_MS = 300, /* how long v4l2_thread_stop() waits for the thread */
};

bool v4l2_thread_wait(struct camera_source *source, int timeout_ms)
{
	return v4l2_timed_lock_wait(&source->lock, timeout_ms);
}

static void record_outage(struct camera_source *source)
{
	const struct v4l2_session *session = &source->session;

	if (source->out) {
		return;
	}
	source->out = true;
	memcpy(source->reason, session->device.reason, sizeof(source->reason));
	source->reason_new = true;
	source->back_new = false;
	pthread_cond_broadcast(&source->lock.changed);
}

/* Waits until the frame loop uses no picture, then closes the device. */
static void close_session(struct camera_source *source)
{
	pthread_mutex_lock(&source->lock.mutex);
	record_outage(source);
	source->ready = -1;
	while (source->held >= 0) {
		v4l2_thread_wait(source, WAIT_MS);
	}
	memset(source->returned, 0, sizeof(source->returned));
	pthread_mutex_unlock(&source->lock.mutex);
	v4l2_session_close(&source->session);
}

static void open_session(struct camera_source *source)
{
	struct v4l2_session *session = &source->session;
	bool fine = v4l2_session_open(session);

	pthread_mutex_lock(&source->lock.mutex);
	memcpy(source->name, session->path, sizeof(source->name));
	if (!fine) {
		record_outage(source);
	} else if (session->state == V4L2_OPEN) {
		for (int i = 0; i < session->device.buffer_count; i++) {
			source->image[i] =
				v4l2_device_image(&session->device, i);
		}
		source->started = true;
		source->heard_ms = clock_monotonic_ms();
	} else if (!source->quit) {
		v4l2_thread_wait(source, WAIT_MS);
	}
	pthread_mutex_unlock(&source->lock.mutex);
}

static void publish(struct camera_source *source, int index)
{
	int dropped;

	pthread_mutex_lock(&source->lock.mutex);
	dropped = source->ready;
	source->ready = index;
	source->heard_ms = clock_monotonic_ms();
	source->any = true;
	if (source->out) {
		source->out = false;
		source->back_new = true;
	}
	pthread_cond_broadcast(&source->lock.changed);
	pthread_mutex_unlock(&source->lock.mutex);
	if (dropped >= 0) {
		v4l2_session_queue(&source->session, dropped);
	}
}

static void queue_returned(struct camera_source *source)
{
	bool returned[V4L2_BUFFERS];

	pthread_mutex_lock(&source->lock.mutex);
	memcpy(returned, source->returned, sizeof(returned));
	memset(source->returned, 0, sizeof(source->returned));
	pthread_mutex_unlock(&source->lock.mutex);
	for (int i = 0; i < V4L2_BUFFERS; i++) {
		if (returned[i]) {
			v4l2_session_queue(&source->session, i);
		}
	}
}

static void pause_thread(struct camera_source *source, int timeout_ms)
{
	pthread_mutex_lock(&source->lock.mutex);
	if (!source->quit) {
		v4l2_thread_wait(source, timeout_ms);
	}
	pthread_mutex_unlock(&source->lock.mutex);
}

static void stream(struct camera_source *source)
{
	struct v4l2_session *session = &source->session;
	int index;

	queue_returned(source);
	if (session->state == V4L2_FAILED) {
		return;
	}
	if (v4l2_device_queued(&session->device) == 0) {
		pause_thread(source, EMPTY_MS);
		return;
	}
	index = v4l2_session_dequeue(session, WAIT_MS);
	if (index >= 0) {
		publish(source, index);
	} else if (session->state != V4L2_FAILED) {
		pause_thread(source, EMPTY_MS);
	}
}

static bool is_running(struct camera_source *source)
{
	bool quit;

	pthread_mutex_lock(&source->lock.mutex);
	quit = source->quit;
	pthread_mutex_unlock(&source->lock.mutex);
	return !quit;
}

static void release(struct camera_source *source)
{
	v4l2_timed_lock_destroy(&source->lock);
	free(source);
}

static void *run(void *argument)
{
	struct camera_source *source = argument;
	bool abandoned;

	while (is_running(source)) {
		if (source->session.state == V4L2_CLOSED) {
			open_session(source);
		} else {
			stream(source);
		}
		if (source->session.state == V4L2_FAILED) {
			close_session(source);
		}
	}
	v4l2_device_close(&source->session.device);
	pthread_mutex_lock(&source->lock.mutex);
	source->ended = true;
	abandoned = source->abandoned;
	pthread_cond_broadcast(&source->lock.changed);
	pthread_mutex_unlock(&source->lock.mutex);
	if (abandoned) {
		release(source);
	}
	return NULL;
}

/*
 * Blocks signals in the thread, so that the main thread gets them. Not faults:
 * if a driver's picture makes libv4lconvert crash, the handler that gives the
 * screen back must run, and Linux runs none of a blocked fault.
 */
static int create_thread(struct camera_source *source)
{
	static const int faults[] = {
		SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT, SIGSYS, SIGTRAP};
	sigset_t all, before;
	int error;

	sigfillset(&all);
	for (size_t i = 0; i < ARRAY_COUNT(faults); i++) {
		sigdelset(&all, faults[i]);
	}
	pthread_sigmask(SIG_SETMASK, &all, &before);
	error = pthread_create(&source->thread, NULL, run, source);
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	return -error;
}

int v4l2_thread_start(struct camera_source *source)
{
	int error = v4l2_timed_lock_init(&source->lock);

	if (error) {
		return error;
	}
	error = create_thread(source);
	if (error) {
		v4l2_timed_lock_destroy(&source->lock);
	}
	return error;
}

void v4l2_thread_stop(struct camera_source *source)
{
	int64_t until_ms = clock_monotonic_ms() + LEAVE_MS;
	bool ended;

	pthread_mutex_lock(&source->lock.mutex);
	source->quit = true;
	pthread_cond_broadcast(&source->lock.changed);
	while (!source->ended && clock_monotonic_ms() < until_ms) {
		v4l2_thread_wait(source, LEAVE_MS);
	}
	ended = source->ended;
	source->abandoned = !ended;
	if (!ended) {
		pthread_detach(source->thread);
	}
	pthread_mutex_unlock(&source->lock.mutex);
	if (ended) {
		pthread_join(source->thread, NULL);
		release(source);
	}
}
