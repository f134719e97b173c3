/*
 * The cameras that limber doctor reports. A driver may block for seconds, so a
 * thread inspects each device. A thread that is blocked is abandoned and then
 * owns the inspection.
 */
#include "platform/camera/v4l2/format.h"
#include "platform/camera/v4l2/timed_lock.h"
#include "platform/camera/v4l2/v4l2.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	DEVICES_MAX = 64,
	TIMEOUT_MS = 700,
	FORMATS_MAX = 16
};

/* The result of an inspection. */
struct view {
	int error; /* 0, or -errno of open() or of VIDIOC_QUERYCAP */
	struct v4l2_capability capability;
	uint32_t fourcc[FORMATS_MAX];
	int format_count;
};

struct inspection {
	struct v4l2_timed_lock lock;
	bool begun, done, abandoned;
	const struct v4l2_calls *calls;
	char path[V4L2_PATH_BYTES];
	struct view view;
};

static void release(struct inspection *inspection)
{
	v4l2_timed_lock_destroy(&inspection->lock);
	free(inspection);
}

static void list_formats(
	const struct v4l2_calls *calls, int fd, struct view *view)
{
	while (view->format_count < FORMATS_MAX) {
		struct v4l2_fmtdesc offer = {
			.index = (uint32_t)view->format_count,
			.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		};

		if (calls->ioctl(calls->user, fd, VIDIOC_ENUM_FMT, &offer) != 0) {
			return;
		}
		view->fourcc[view->format_count++] = offer.pixelformat;
	}
}

static void *run(void *argument)
{
	struct inspection *inspection = argument;
	const struct v4l2_calls *calls = inspection->calls;
	struct view view = {0};
	bool abandoned;
	int fd;

	pthread_mutex_lock(&inspection->lock.mutex);
	inspection->begun = true;
	pthread_cond_signal(&inspection->lock.changed);
	pthread_mutex_unlock(&inspection->lock.mutex);
	view.error = fd = calls->open(calls->user, inspection->path);
	if (fd >= 0) {
		view.error = calls->ioctl(
			calls->user, fd, VIDIOC_QUERYCAP, &view.capability);
		if (!view.error) {
			list_formats(calls, fd, &view);
		}
		calls->close(calls->user, fd);
	}
	pthread_mutex_lock(&inspection->lock.mutex);
	inspection->view = view;
	inspection->done = true;
	abandoned = inspection->abandoned;
	pthread_cond_signal(&inspection->lock.changed);
	pthread_mutex_unlock(&inspection->lock.mutex);
	if (abandoned) {
		release(inspection);
	}
	return NULL;
}

/*
 * Waits for the thread's result, or abandons the inspection to the thread. The
 * time starts when the thread runs, which may be late on a busy machine.
 */
static int await(
	struct inspection *inspection, pthread_t thread, struct view *out)
{
	bool in_time = true;
	int error;

	pthread_mutex_lock(&inspection->lock.mutex);
	while (!inspection->begun) {
		pthread_cond_wait(
			&inspection->lock.changed, &inspection->lock.mutex);
	}
	while (!inspection->done && in_time) {
		in_time = v4l2_timed_lock_wait(&inspection->lock, TIMEOUT_MS);
	}
	*out = inspection->view;
	inspection->abandoned = !inspection->done;
	error = inspection->done ? 0 : -ETIMEDOUT;
	pthread_mutex_unlock(&inspection->lock.mutex);
	if (error) {
		pthread_detach(thread);
	} else {
		pthread_join(thread, NULL);
		release(inspection);
	}
	return error;
}

/* Inspects a device. Returns 0 or -errno. */
static int inspect(
	const struct v4l2_calls *calls, const char *path, struct view *out)
{
	struct inspection *inspection = calloc(1, sizeof(*inspection));
	pthread_t thread;
	int error;

	if (!inspection) {
		return -ENOMEM;
	}
	inspection->calls = calls;
	snprintf(inspection->path, sizeof(inspection->path), "%s", path);
	error = v4l2_timed_lock_init(&inspection->lock);
	if (error) {
		free(inspection);
		return error;
	}
	error = pthread_create(&thread, NULL, run, inspection);
	if (error) {
		release(inspection);
		return -error;
	}
	error = await(inspection, thread, out);
	return error ? error : out->error;
}

static bool captures(const struct view *view)
{
	const struct v4l2_capability *capability = &view->capability;
	uint32_t bits = capability->capabilities & V4L2_CAP_DEVICE_CAPS
		? capability->device_caps
		: capability->capabilities;

	return bits & V4L2_CAP_VIDEO_CAPTURE && bits & V4L2_CAP_STREAMING;
}

/* Writes " RGBP UYVY (MJPG)", with formats that need the library in brackets.
 * Returns whether limber can read one of them, or the device lists none. */
static bool write_formats(const struct view *view, char *text, size_t size)
{
	bool any = view->format_count == 0;
	size_t used = 0;

	text[0] = '\0';
	for (int i = 0; i < view->format_count && used < size; i++) {
		bool own = v4l2_format_of(view->fourcc[i]) != CAMERA_FORMATS;
		char code[5];

		v4l2_format_text(view->fourcc[i], code);
		used += (size_t)snprintf(
			text + used, size - used, own ? " %s" : " (%s)", code);
		any = any || own;
	}
	return any;
}

static void report_camera(
	const char *path, const struct view *view, const struct survey *survey)
{
	char formats[FORMATS_MAX * 8];
	bool own = write_formats(view, formats, sizeof(formats));
	const char *card = (const char *)view->capability.card;
	const char *driver = (const char *)view->capability.driver;
	int card_bytes = (int)sizeof(view->capability.card);
	int driver_bytes = (int)sizeof(view->capability.driver);

	if (!captures(view)) {
		survey_report(survey, SURVEY_UNUSED, path, NULL,
			"%.*s, driver %.*s: captures no video into mapped buffers",
			card_bytes, card, driver_bytes, driver);
		return;
	}
	if (!own && !convert_library_is_available()) {
		survey_report(survey, SURVEY_BROKEN, path,
			"sudo apt install libv4lconvert0",
			"%.*s, driver %.*s:%s: these formats need libv4lconvert",
			card_bytes, card, driver_bytes, driver, formats);
		return;
	}
	survey_report(survey, SURVEY_WORKS, path, NULL, "%.*s, driver %.*s:%s",
		card_bytes, card, driver_bytes, driver,
		view->format_count ? formats : " lists no formats");
}

static void report_error(
	const char *path, int error, const struct survey *survey)
{
	char remedy[V4L2_PATH_BYTES + 40];

	snprintf(remedy, sizeof(remedy), "find that program: sudo fuser -v %s",
		path);
	if (error == -EACCES || error == -EPERM) {
		survey_report_denied(survey, path);
	} else if (error == -EBUSY) {
		survey_report(survey, SURVEY_TAKEN, path, remedy,
			"another program is using it");
	} else if (error == -ETIMEDOUT) {
		survey_report(survey, SURVEY_BROKEN, path,
			"dmesg | tail may show what its driver waits for; limber plays without the camera until then",
			"its driver does not answer within %d ms", TIMEOUT_MS);
	} else {
		survey_report(survey, SURVEY_BROKEN, path,
			"unplug it and plug it in again; dmesg | tail may show the cause",
			"%s", strerror(-error));
	}
}

/* Reports the device of that number; false when there is none. */
static bool report_number(
	const struct v4l2_calls *calls, int number, const struct survey *survey)
{
	struct view view = {0};
	char path[V4L2_PATH_BYTES], entry[64];
	int error;

	snprintf(path, sizeof(path), "/dev/video%d", number);
	error = calls->exists(calls->user, path) ? inspect(calls, path, &view)
						 : -ENOENT;
	if (error == -ENOENT || error == -ENXIO || error == -ENODEV) {
		snprintf(entry, sizeof(entry), "class/video4linux/video%d",
			number);
		return survey_report_no_node(survey, path, entry, error);
	}
	if (error) {
		report_error(path, error, survey);
	} else {
		report_camera(path, &view, survey);
	}
	return true;
}

void v4l2_survey_on(const struct v4l2_calls *calls, const struct survey *survey)
{
	bool any = false;

	for (int i = 0; i < DEVICES_MAX; i++) {
		any = report_number(calls, i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "/dev/video*",
			"plug one in (sudo modprobe uvcvideo), or use the test picture: --camera pattern",
			"there is no camera");
	}
}
