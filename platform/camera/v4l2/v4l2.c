/*
 * V4L2 devices, each served by a thread of its own.
 *
 * Drivers may block for seconds, whatever they were opened with: in open() and
 * S_FMT while a sensor is set up, in DQBUF while it is silent. So the thread
 * makes every system call, and the frame loop only exchanges numbers of
 * buffers with it under a lock that neither holds across a call.
 *
 * A buffer belongs to the driver (queued), is the newest picture (ready), is
 * looked at by the frame loop (held), or comes back from there (returned). A
 * newer picture sends an older one that nobody took straight back to the
 * driver. Before the thread unmaps anything it takes ready away and waits until
 * nothing is held.
 *
 * A thread that is caught in a driver when the source is destroyed is left
 * behind, owns everything, and releases it when the driver lets it go.
 */
#include "platform/camera/v4l2/v4l2.h"

#include "platform/camera/v4l2/format.h"
#include "platform/camera/v4l2/session.h"
#include "platform/process/clock.h"

#include <errno.h>
#include <pthread.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
	WAIT_MS = 100,  /* for a picture, then for nothing */
	EMPTY_MS = 5,   /* after a driver said there is one and there is none */
	LEAVE_MS = 300, /* for the thread to end */
};

struct camera_source {
	pthread_mutex_t lock;
	pthread_cond_t changed; /* any of what is below */
	pthread_t thread;
	bool quit, ended, abandoned;

	/* Between the thread and the frame loop, -1: none. */
	int ready, held;
	bool returned[V4L2_BUFFERS];
	struct camera_image image[V4L2_BUFFERS];
	bool streaming;
	int64_t heard_ms; /* the last picture, or the start */
	bool any;         /* a picture came since the start */

	char name[V4L2_PATH_BYTES]; /* of the device */

	/* An outage is told once. */
	bool out; /* it is out now */
	char reason[V4L2_REASON_BYTES];
	bool reason_new;
	bool back_new;

	/* The frame loop's. */
	struct log log;

	/* The thread's. */
	struct v4l2_session session;
};

static int64_t now_ms(void)
{
	return clock_monotonic_ns() / 1000000;
}

/* Waits for a change, with the lock held; false when the time is over. */
static bool wait_changed(struct camera_source *source, int timeout_ms)
{
	struct timespec until;

	clock_gettime(CLOCK_MONOTONIC, &until);
	until.tv_sec += timeout_ms / 1000;
	until.tv_nsec += (long)(timeout_ms % 1000) * 1000000;
	if (until.tv_nsec >= 1000000000) {
		until.tv_sec++;
		until.tv_nsec -= 1000000000;
	}
	return pthread_cond_timedwait(
		       &source->changed, &source->lock, &until) == 0;
}

static void tell_outage(struct camera_source *source)
{
	const struct v4l2_session *session = &source->session;

	source->streaming = false;
	if (source->out) {
		return;
	}
	source->out = true;
	memcpy(source->reason, session->device.reason, sizeof(source->reason));
	source->reason_new = true;
	pthread_cond_broadcast(&source->changed);
}

/* Takes all pictures away from the frame loop, then closes. */
static void close_session(struct camera_source *source)
{
	pthread_mutex_lock(&source->lock);
	tell_outage(source);
	source->ready = -1;
	while (source->held >= 0) {
		wait_changed(source, WAIT_MS);
	}
	memset(source->returned, 0, sizeof(source->returned));
	pthread_mutex_unlock(&source->lock);
	v4l2_session_close(&source->session);
}

static void open_session(struct camera_source *source)
{
	struct v4l2_session *session = &source->session;
	bool fine = v4l2_session_open(session);

	pthread_mutex_lock(&source->lock);
	memcpy(source->name, session->path, sizeof(source->name));
	if (!fine) {
		tell_outage(source);
	} else if (session->state == V4L2_OPEN) {
		for (int i = 0; i < session->device.buffer_count; i++) {
			source->image[i] =
				v4l2_device_image(&session->device, i);
		}
		source->streaming = true;
		source->heard_ms = now_ms();
	} else if (!source->quit) {
		wait_changed(source, WAIT_MS);
	}
	pthread_mutex_unlock(&source->lock);
}

static void publish(struct camera_source *source, int index)
{
	int dropped;

	pthread_mutex_lock(&source->lock);
	dropped = source->ready;
	source->ready = index;
	source->heard_ms = now_ms();
	source->any = true;
	if (source->out) {
		source->out = false;
		source->back_new = true;
		source->reason_new = false;
	}
	pthread_cond_broadcast(&source->changed);
	pthread_mutex_unlock(&source->lock);
	if (dropped >= 0) {
		v4l2_session_queue(&source->session, dropped);
	}
}

static void queue_returned(struct camera_source *source)
{
	bool returned[V4L2_BUFFERS];

	pthread_mutex_lock(&source->lock);
	memcpy(returned, source->returned, sizeof(returned));
	memset(source->returned, 0, sizeof(source->returned));
	pthread_mutex_unlock(&source->lock);
	for (int i = 0; i < V4L2_BUFFERS; i++) {
		if (returned[i]) {
			v4l2_session_queue(&source->session, i);
		}
	}
}

static void rest(struct camera_source *source, int timeout_ms)
{
	pthread_mutex_lock(&source->lock);
	if (!source->quit) {
		wait_changed(source, timeout_ms);
	}
	pthread_mutex_unlock(&source->lock);
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
		rest(source, EMPTY_MS);
		return;
	}
	index = v4l2_session_dequeue(session, WAIT_MS);
	if (index >= 0) {
		publish(source, index);
	} else if (session->state != V4L2_FAILED) {
		rest(source, EMPTY_MS);
	}
}

static bool wants_to_go_on(struct camera_source *source)
{
	bool quit;

	pthread_mutex_lock(&source->lock);
	quit = source->quit;
	pthread_mutex_unlock(&source->lock);
	return !quit;
}

static void release(struct camera_source *source)
{
	pthread_cond_destroy(&source->changed);
	pthread_mutex_destroy(&source->lock);
	free(source);
}

static void *run(void *argument)
{
	struct camera_source *source = argument;
	bool abandoned;

	while (wants_to_go_on(source)) {
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
	pthread_mutex_lock(&source->lock);
	source->ended = true;
	abandoned = source->abandoned;
	pthread_cond_broadcast(&source->changed);
	pthread_mutex_unlock(&source->lock);
	if (abandoned) {
		release(source);
	}
	return NULL;
}

/* Signals are the frame loop's. */
static int start_thread(struct camera_source *source)
{
	sigset_t all, before;
	int error;

	sigfillset(&all);
	pthread_sigmask(SIG_SETMASK, &all, &before);
	error = pthread_create(&source->thread, NULL, run, source);
	pthread_sigmask(SIG_SETMASK, &before, NULL);
	return -error;
}

static int init_lock(struct camera_source *source)
{
	pthread_condattr_t attributes;
	int error = pthread_condattr_init(&attributes);

	if (error) {
		return -error;
	}
	error = pthread_condattr_setclock(&attributes, CLOCK_MONOTONIC);
	if (!error) {
		error = pthread_cond_init(&source->changed, &attributes);
	}
	pthread_condattr_destroy(&attributes);
	if (error) {
		return -error;
	}
	error = pthread_mutex_init(&source->lock, NULL);
	if (error) {
		pthread_cond_destroy(&source->changed);
	}
	return -error;
}

static int read_request(
	const struct camera_options *options, struct v4l2_request *out)
{
	*out = (struct v4l2_request){
		.width = options->width, .height = options->height};
	if (options->argument && strlen(options->argument) >= sizeof(out->path)) {
		log_error(options->log,
			"--camera %s: a name of more than %zu characters",
			options->argument, sizeof(out->path) - 1);
		return -EINVAL;
	}
	if (options->argument) {
		strcpy(out->path, options->argument);
	}
	if (options->format) {
		out->fourcc = v4l2_format_find(options->format);
		if (!out->fourcc) {
			log_error(options->log,
				"--camera: no format %s: want rgb565, uyvy, yuyv, nv12, yuv420, rgb24, bgr24 or a code of four letters such as mjpg",
				options->format);
			return -EINVAL;
		}
	}
	return 0;
}

int v4l2_source_create(const struct camera_options *options,
	const struct v4l2_calls *calls, struct camera_source **out)
{
	struct camera_source *source;
	struct v4l2_request request;
	int error = read_request(options, &request);

	if (error) {
		return error;
	}
	source = calloc(1, sizeof(*source));
	error = source ? init_lock(source) : -ENOMEM;
	if (error) {
		goto fail;
	}
	source->log = *options->log;
	source->ready = source->held = -1;
	v4l2_session_init(&source->session, calls, &request);
	error = start_thread(source);
	if (!error) {
		*out = source;
		return 0;
	}
	pthread_cond_destroy(&source->changed);
	pthread_mutex_destroy(&source->lock);
fail:
	free(source);
	log_error(options->log, "--camera: cannot start its thread (%s)",
		strerror(-error));
	return error;
}

static int create(
	const struct camera_options *options, struct camera_source **out)
{
	return v4l2_source_create(options, &v4l2_calls_real, out);
}

/* What to tell, out of the lock's way. */
struct news {
	char name[V4L2_PATH_BYTES];
	char reason[V4L2_REASON_BYTES];
	bool outage, back, silent;
};

static void collect_news(struct camera_source *source, struct news *news)
{
	bool quiet = source->streaming &&
		now_ms() - source->heard_ms >= V4L2_SILENCE_MS;

	*news = (struct news){
		.outage = source->reason_new, .back = source->back_new};
	memcpy(news->name, source->name, sizeof(news->name));
	if (source->reason_new) {
		memcpy(news->reason, source->reason, sizeof(news->reason));
	}
	source->reason_new = source->back_new = false;
	/* The thread may be caught in the driver and cannot tell. */
	if (quiet && !source->out) {
		source->out = true;
		news->silent = true;
	}
}

static void tell_news(struct camera_source *source, const struct news *news)
{
	if (news->outage) {
		log_warning(&source->log,
			"camera %s: %s; it goes on without and tries again",
			news->name, news->reason);
	}
	if (news->silent) {
		log_warning(&source->log,
			"camera %s: no picture for %d s; it goes on without and tries again",
			news->name, V4L2_SILENCE_MS / 1000);
	}
	if (news->back) {
		log_note(&source->log, "camera %s: it is back", news->name);
	}
}

static enum camera_status take(struct camera_source *source, int64_t frame_ms,
	struct camera_image *out)
{
	enum camera_status found = CAMERA_NONE;
	struct news news;

	(void)frame_ms;
	pthread_mutex_lock(&source->lock);
	if (source->ready >= 0) {
		source->held = source->ready;
		source->ready = -1;
		*out = source->image[source->held];
		found = CAMERA_NEW;
	} else if (source->streaming && source->any && !source->out) {
		found = CAMERA_SAME;
	}
	collect_news(source, &news);
	pthread_mutex_unlock(&source->lock);
	tell_news(source, &news);
	return found;
}

static void give_back(struct camera_source *source)
{
	pthread_mutex_lock(&source->lock);
	if (source->held >= 0) {
		source->returned[source->held] = true;
		source->held = -1;
		pthread_cond_broadcast(&source->changed);
	}
	pthread_mutex_unlock(&source->lock);
}

static void await(struct camera_source *source, int timeout_ms)
{
	int64_t until_ms = now_ms() + timeout_ms;

	pthread_mutex_lock(&source->lock);
	while (source->ready < 0 && !source->out) {
		int64_t left_ms = until_ms - now_ms();

		if (left_ms <= 0) {
			break;
		}
		wait_changed(source, (int)left_ms);
	}
	pthread_mutex_unlock(&source->lock);
}

static void destroy(struct camera_source *source)
{
	int64_t until_ms = now_ms() + LEAVE_MS;
	bool ended;

	if (!source) {
		return;
	}
	give_back(source);
	pthread_mutex_lock(&source->lock);
	source->quit = true;
	pthread_cond_broadcast(&source->changed);
	while (!source->ended && now_ms() < until_ms) {
		wait_changed(source, LEAVE_MS);
	}
	ended = source->ended;
	source->abandoned = !ended;
	if (!ended) {
		pthread_detach(source->thread);
	}
	pthread_mutex_unlock(&source->lock);
	if (ended) {
		pthread_join(source->thread, NULL);
		release(source);
	}
}

static void survey_real(const struct survey *survey)
{
	v4l2_survey_on(&v4l2_calls_real, survey);
}

const struct camera_driver camera_driver_v4l2 = {
	.name = "v4l2",
	.summary = "a Video4Linux device",
	.create = create,
	.take = take,
	.give_back = give_back,
	.await = await,
	.destroy = destroy,
	.survey = survey_real,
};
