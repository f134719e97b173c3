#include "platform/camera/v4l2/session.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

enum {
	DEVICES_MAX = 64
};

void v4l2_session_init(struct v4l2_session *session,
	const struct v4l2_calls *calls, const struct v4l2_request *request)
{
	*session = (struct v4l2_session){
		.calls = calls,
		.request = *request,
		.retry_ms = V4L2_RETRY_FIRST_MS,
		.retry_at_ms = INT64_MIN,
		.device = {.fd = -1},
	};
	snprintf(session->path, sizeof(session->path), "%s", request->path);
}

static int64_t now_ms(const struct v4l2_session *session)
{
	return session->calls->now_ms(session->calls->user);
}

static void retry_later(struct v4l2_session *session)
{
	session->state = V4L2_CLOSED;
	session->retry_at_ms = now_ms(session) + session->retry_ms;
	session->retry_ms *= 2;
	if (session->retry_ms > V4L2_RETRY_LAST_MS) {
		session->retry_ms = V4L2_RETRY_LAST_MS;
	}
}

static int open_path(struct v4l2_session *session)
{
	struct v4l2_request request = session->request;

	memcpy(request.path, session->path, sizeof(request.path));
	return v4l2_device_open(&session->device, session->calls, &request);
}

static bool is_no_camera(int error)
{
	return error == -ENOENT || error == -ENODEV || error == -ENXIO ||
		error == -ENOTTY;
}

/*
 * Opens the first camera that can be used: others may be taken or have formats
 * that limber cannot read. If there is none, the path and the reason are those
 * of the first camera. One that never delivered a picture, such as a capture
 * card without a signal, is tried last.
 */
static int open_any(struct v4l2_session *session)
{
	char path[V4L2_PATH_BYTES] = "auto";
	char reason[V4L2_REASON_BYTES] =
		"no /dev/video device captures video: plug a camera in";
	int first_error = 0;

	for (int i = 0; i < DEVICES_MAX; i++) {
		int error;

		session->number = (session->first + i) % DEVICES_MAX;
		snprintf(session->path, sizeof(session->path), "/dev/video%d",
			session->number);
		error = open_path(session);
		if (!error) {
			return 0;
		}
		if (!first_error && !is_no_camera(error)) {
			memcpy(path, session->path, sizeof(path));
			memcpy(reason, session->device.reason, sizeof(reason));
			first_error = error;
		}
	}
	memcpy(session->path, path, sizeof(path));
	memcpy(session->device.reason, reason, sizeof(reason));
	return first_error ? first_error : -ENOENT;
}

bool v4l2_session_open(struct v4l2_session *session)
{
	int error;

	if (session->state != V4L2_CLOSED ||
		now_ms(session) < session->retry_at_ms) {
		return true;
	}
	error = session->request.path[0] ? open_path(session)
					 : open_any(session);
	if (error) {
		retry_later(session);
		return false;
	}
	session->state = V4L2_OPEN;
	session->heard_ms = now_ms(session);
	return true;
}

int v4l2_session_dequeue(struct v4l2_session *session, int timeout_ms)
{
	int index = v4l2_device_dequeue(&session->device, timeout_ms);

	if (index >= 0) {
		session->state = V4L2_ALIVE;
		session->heard_ms = now_ms(session);
		session->retry_ms = V4L2_RETRY_FIRST_MS;
		return index;
	}
	if (index != -EAGAIN) {
		session->state = V4L2_FAILED;
	} else if (now_ms(session) - session->heard_ms >= V4L2_SILENCE_MS) {
		snprintf(session->device.reason, sizeof(session->device.reason),
			"no picture for %d s", V4L2_SILENCE_MS / 1000);
		session->first = session->state == V4L2_OPEN
			? (session->number + 1) % DEVICES_MAX
			: session->number;
		session->state = V4L2_FAILED;
	}
	return -1;
}

void v4l2_session_queue(struct v4l2_session *session, int index)
{
	if (v4l2_device_queue(&session->device, index) != 0) {
		session->state = V4L2_FAILED;
	}
}

void v4l2_session_close(struct v4l2_session *session)
{
	v4l2_device_close(&session->device);
	retry_later(session);
}
