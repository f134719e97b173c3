/*
 * What there is to be seen of cameras. Drivers may block for seconds where
 * they should not, so each device is looked at by a thread; one that is caught
 * is left behind and owns what it works on.
 */
#include "platform/camera/v4l2/format.h"
#include "platform/camera/v4l2/v4l2.h"

#include <errno.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum {
	DEVICES_MAX = 64,
	PATIENCE_MS = 700,
	FORMATS_MAX = 16
};

/* What a look found. */
struct view {
	int error; /* of opening it or asking what it is */
	struct v4l2_capability capability;
	uint32_t fourcc[FORMATS_MAX];
	int format_count;
};

struct look {
	pthread_mutex_t lock;
	pthread_cond_t changed;
	bool begun, done, abandoned;
	const struct v4l2_calls *calls;
	char path[V4L2_PATH_BYTES];
	struct view view;
};

static void release(struct look *look)
{
	pthread_cond_destroy(&look->changed);
	pthread_mutex_destroy(&look->lock);
	free(look);
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
	struct look *look = argument;
	const struct v4l2_calls *calls = look->calls;
	struct view view = {0};
	bool abandoned;
	int fd;

	pthread_mutex_lock(&look->lock);
	look->begun = true;
	pthread_cond_signal(&look->changed);
	pthread_mutex_unlock(&look->lock);
	view.error = fd = calls->open(calls->user, look->path);
	if (fd >= 0) {
		view.error = calls->ioctl(
			calls->user, fd, VIDIOC_QUERYCAP, &view.capability);
		if (!view.error) {
			list_formats(calls, fd, &view);
		}
		calls->close(calls->user, fd);
	}
	pthread_mutex_lock(&look->lock);
	look->view = view;
	look->done = true;
	abandoned = look->abandoned;
	pthread_cond_signal(&look->changed);
	pthread_mutex_unlock(&look->lock);
	if (abandoned) {
		release(look);
	}
	return NULL;
}

static struct timespec soon(void)
{
	struct timespec until;

	clock_gettime(CLOCK_REALTIME, &until);
	until.tv_nsec += (long)PATIENCE_MS * 1000000;
	until.tv_sec += until.tv_nsec / 1000000000;
	until.tv_nsec %= 1000000000;
	return until;
}

/*
 * Takes what the thread found, or leaves it; the look is its then. The time
 * begins with the thread, which a busy machine may keep waiting.
 */
static int await(struct look *look, pthread_t thread, struct view *out)
{
	struct timespec until;
	int error = 0;

	pthread_mutex_lock(&look->lock);
	while (!look->begun) {
		pthread_cond_wait(&look->changed, &look->lock);
	}
	until = soon();
	while (!look->done && !error) {
		error = pthread_cond_timedwait(
			&look->changed, &look->lock, &until);
	}
	*out = look->view;
	look->abandoned = !look->done;
	error = look->done ? 0 : -ETIMEDOUT;
	pthread_mutex_unlock(&look->lock);
	if (error) {
		pthread_detach(thread);
	} else {
		pthread_join(thread, NULL);
		release(look);
	}
	return error;
}

/* 0, or -errno when it cannot be told what the device is. */
static int look_at(
	const struct v4l2_calls *calls, const char *path, struct view *out)
{
	struct look *look = calloc(1, sizeof(*look));
	pthread_t thread;
	int error;

	if (!look) {
		return -ENOMEM;
	}
	look->calls = calls;
	snprintf(look->path, sizeof(look->path), "%s", path);
	pthread_mutex_init(&look->lock, NULL);
	pthread_cond_init(&look->changed, NULL);
	error = pthread_create(&thread, NULL, run, look);
	if (error) {
		release(look);
		return -error;
	}
	error = await(look, thread, out);
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

/* ", RGBP UYVY (MJPG)": in brackets those that need the library. */
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
	int card_room = (int)sizeof(view->capability.card);
	int driver_room = (int)sizeof(view->capability.driver);

	if (!captures(view)) {
		survey_report(survey, SURVEY_UNUSED, path, NULL,
			"%.*s, driver %.*s: captures no video into mapped buffers",
			card_room, card, driver_room, driver);
		return;
	}
	if (!own && !convert_library_is_available()) {
		survey_report(survey, SURVEY_BROKEN, path,
			"sudo apt install libv4lconvert0",
			"%.*s, driver %.*s:%s, which need libv4lconvert",
			card_room, card, driver_room, driver, formats);
		return;
	}
	survey_report(survey, SURVEY_WORKS, path, NULL, "%.*s, driver %.*s:%s",
		card_room, card, driver_room, driver,
		view->format_count ? formats : " lists no formats");
}

static void report_error(const char *path, int error, const struct survey *survey)
{
	char remedy[V4L2_PATH_BYTES + 32];

	snprintf(remedy, sizeof(remedy), "sudo fuser -v %s names who", path);
	if (error == -EACCES || error == -EPERM) {
		survey_report_denied(survey, path);
	} else if (error == -EBUSY) {
		survey_report(survey, SURVEY_TAKEN, path, remedy,
			"another program is using it");
	} else if (error == -ETIMEDOUT) {
		survey_report(survey, SURVEY_BROKEN, path,
			"dmesg | tail tells what its driver waits for; limber plays on while it does",
			"its driver does not answer within %d ms", PATIENCE_MS);
	} else {
		survey_report(survey, SURVEY_BROKEN, path,
			"unplug it and plug it in again; dmesg | tail tells more",
			"%s", strerror(-error));
	}
}

/* Whether there was something to say of that device. */
static bool look_at_number(
	const struct v4l2_calls *calls, int number, const struct survey *survey)
{
	struct view view = {0};
	char path[V4L2_PATH_BYTES], entry[64];
	int error;

	snprintf(path, sizeof(path), "/dev/video%d", number);
	error = calls->exists(calls->user, path) ? look_at(calls, path, &view)
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
		any = look_at_number(calls, i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "/dev/video*",
			"plug one in (sudo modprobe uvcvideo), or use the moving pattern: --camera pattern",
			"no camera");
	}
}
