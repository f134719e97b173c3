/*
 * V4L2 devices: the part of the driver that runs in the frame loop.
 */
#include "platform/camera/v4l2/v4l2.h"

#include "platform/camera/v4l2/format.h"
#include "platform/camera/v4l2/v4l2_thread.h"
#include "platform/process/clock.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int read_request(
	const struct camera_options *options, struct v4l2_request *out)
{
	*out = (struct v4l2_request){
		.width = options->width, .height = options->height};
	if (options->argument && strlen(options->argument) >= sizeof(out->path)) {
		log_error(options->log,
			"--camera %s: give a name of at most %zu characters",
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
				"--camera: no such format: %s: choose rgb565, uyvy, yuyv, nv12, yuv420, rgb24, bgr24 or a code of four letters such as mjpg",
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
	error = -ENOMEM;
	if (source) {
		source->log = *options->log;
		source->ready = source->held = -1;
		v4l2_session_init(&source->session, calls, &request);
		error = v4l2_thread_start(source);
	}
	if (error) {
		free(source);
		log_error(options->log, "--camera: cannot start its thread: %s",
			strerror(-error));
		return error;
	}
	*out = source;
	return 0;
}

static int create(
	const struct camera_options *options, struct camera_source **out)
{
	return v4l2_source_create(options, &v4l2_calls_real, out);
}

/* What take() logs after it has released the lock. */
struct changes {
	char name[V4L2_PATH_BYTES];
	char reason[V4L2_REASON_BYTES];
	bool outage, back, silent;
};

static void collect_changes(
	struct camera_source *source, struct changes *changes)
{
	bool quiet = source->started &&
		clock_monotonic_ms() - source->heard_ms >= V4L2_SILENCE_MS;

	*changes = (struct changes){
		.outage = source->reason_new, .back = source->back_new};
	memcpy(changes->name, source->name, sizeof(changes->name));
	if (source->reason_new) {
		memcpy(changes->reason, source->reason, sizeof(changes->reason));
	}
	source->reason_new = source->back_new = false;
	/* The thread cannot notice silence while it is blocked in the driver. */
	if (quiet && !source->out) {
		source->out = true;
		changes->silent = true;
	}
}

static void log_changes(
	struct camera_source *source, const struct changes *changes)
{
	if (changes->outage) {
		log_warning(&source->log,
			"camera %s: %s: limber continues without it and tries again",
			changes->name, changes->reason);
	}
	if (changes->silent) {
		log_warning(&source->log,
			"camera %s: no picture for %d s: limber continues without it and tries again",
			changes->name, V4L2_SILENCE_MS / 1000);
	}
	if (changes->back) {
		log_note(&source->log, "camera %s: it is back", changes->name);
	}
}

static enum camera_status take(struct camera_source *source, int64_t frame_ms,
	struct camera_image *out)
{
	enum camera_status found = CAMERA_NONE;
	struct changes changes;

	(void)frame_ms;
	pthread_mutex_lock(&source->lock.mutex);
	if (source->ready >= 0) {
		source->held = source->ready;
		source->ready = -1;
		*out = source->image[source->held];
		found = CAMERA_NEW;
	} else if (source->any && !source->out) {
		found = CAMERA_SAME;
	}
	collect_changes(source, &changes);
	pthread_mutex_unlock(&source->lock.mutex);
	log_changes(source, &changes);
	return found;
}

static void give_back(struct camera_source *source)
{
	pthread_mutex_lock(&source->lock.mutex);
	if (source->held >= 0) {
		source->returned[source->held] = true;
		source->held = -1;
		pthread_cond_broadcast(&source->lock.changed);
	}
	pthread_mutex_unlock(&source->lock.mutex);
}

static void await(struct camera_source *source, int timeout_ms)
{
	int64_t until_ms = clock_monotonic_ms() + timeout_ms;

	pthread_mutex_lock(&source->lock.mutex);
	while (source->ready < 0 && !source->out) {
		int64_t left_ms = until_ms - clock_monotonic_ms();

		if (left_ms <= 0) {
			break;
		}
		v4l2_thread_wait(source, (int)left_ms);
	}
	pthread_mutex_unlock(&source->lock.mutex);
}

static void destroy(struct camera_source *source)
{
	if (source) {
		give_back(source);
		v4l2_thread_stop(source);
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
