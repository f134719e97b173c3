/*
 * A V4L2 device that may fail at any time: it is opened again after it was
 * unplugged, busy or silent, each time after a longer wait up to a limit.
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
	V4L2_CLOSED, /* v4l2_session_open() opens it at retry_at_ms */
	V4L2_OPEN,   /* streaming, no picture yet */
	V4L2_ALIVE,  /* streaming, at least one picture was delivered */
	V4L2_FAILED, /* call v4l2_session_close() */
};

struct v4l2_session {
	const struct v4l2_calls *calls;
	struct v4l2_request request; /* path "": the first camera that works */
	char path[V4L2_PATH_BYTES];  /* of the device opened last */
	/* Which /dev/videoN was opened last, and which is tried first. */
	int number, first;
	struct v4l2_device device;
	enum v4l2_state state;
	int64_t retry_at_ms; /* when to open it again */
	int retry_ms;        /* how long to wait after the next failure */
	int64_t heard_ms;    /* time of the last picture, or of the start */
};

/* Initializes a closed session that can be opened at once. */
void v4l2_session_init(struct v4l2_session *session,
	const struct v4l2_calls *calls, const struct v4l2_request *request);

/*
 * Opens a closed session if it is time for that. Returns false when opening
 * failed; device.reason then says why.
 */
bool v4l2_session_open(struct v4l2_session *session);

/*
 * Waits up to timeout_ms for a picture. Returns its buffer's index, or -1 when
 * there is none. When the device has failed or was silent for too long, the
 * state becomes V4L2_FAILED and device.reason says why.
 */
int v4l2_session_dequeue(struct v4l2_session *session, int timeout_ms);

/* Gives a buffer to the driver. The state may become V4L2_FAILED. */
void v4l2_session_queue(struct v4l2_session *session, int index);

/*
 * Closes the device and sets the time to open it again. No picture may be in
 * use.
 */
void v4l2_session_close(struct v4l2_session *session);

#endif
