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

/* Writes the path of the first device that captures video. */
static bool find_device(struct v4l2_session *session)
{
	for (int i = 0; i < DEVICES_MAX; i++) {
		snprintf(session->path, sizeof(session->path), "/dev/video%d",
			i);
		if (v4l2_device_check(session->calls, session->path) == 0) {
			return true;
		}
	}
	snprintf(session->path, sizeof(session->path), "auto");
	snprintf(session->device.reason, sizeof(session->device.reason),
		"no /dev/video device captures video: plug a camera in");
	return false;
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

bool v4l2_session_open(struct v4l2_session *session)
{
	struct v4l2_request request = session->request;

	if (session->state != V4L2_CLOSED ||
		now_ms(session) < session->retry_at_ms) {
		return true;
	}
	if (request.path[0] == '\0' && !find_device(session)) {
		retry_later(session);
		return false;
	}
	memcpy(request.path, session->path, sizeof(request.path));
	if (v4l2_device_open(&session->device, session->calls, &request) != 0) {
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
