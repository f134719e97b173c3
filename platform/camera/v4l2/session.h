/*
 * A V4L2 device as it comes and goes: opened again after it was unplugged,
 * busy or silent, later each time up to a limit.
 */
#ifndef PLATFORM_CAMERA_V4L2_SESSION_H
#define PLATFORM_CAMERA_V4L2_SESSION_H

#include "platform/camera/v4l2/device.h"

enum {
	V4L2_RETRY_FIRST_MS = 250,
	V4L2_RETRY_LAST_MS = 2000,
	V4L2_SILENCE_MS = 2000
};

enum v4l2_state {
	V4L2_CLOSED, /* to be opened when the time comes */
	V4L2_OPEN,   /* streaming, no picture yet */
	V4L2_ALIVE,  /* pictures came */
	V4L2_FAILED, /* to be closed, see v4l2_session_close() */
};

struct v4l2_session {
	const struct v4l2_calls *calls;
	struct v4l2_request request; /* an empty path: the first that captures */
	char path[V4L2_PATH_BYTES];  /* of what was tried last */
	struct v4l2_device device;
	enum v4l2_state state;
	int64_t retry_at_ms; /* while closed */
	int retry_ms;        /* the wait after the next failure */
	int64_t heard_ms;    /* last picture, or start */
};

void v4l2_session_init(struct v4l2_session *session,
	const struct v4l2_calls *calls, const struct v4l2_request *request);

/* Opens it if it is time. True unless it failed now, device.reason says why. */
bool v4l2_session_open(struct v4l2_session *session);

/*
 * Waits up to timeout_ms for a picture of an open session: its buffer's index,
 * or -1 for none. When the device has failed or been silent for too long the
 * state is V4L2_FAILED and device.reason says why.
 */
int v4l2_session_dequeue(struct v4l2_session *session, int timeout_ms);

/* Gives a buffer back; may fail the session likewise. */
void v4l2_session_queue(struct v4l2_session *session, int index);

/* Closes it, to be opened again after a while. Nobody looks at its pictures. */
void v4l2_session_close(struct v4l2_session *session);

#endif
