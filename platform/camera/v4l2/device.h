/*
 * One V4L2 device while it is open: negotiated, mapped, streaming.
 *
 * Written for any driver that captures into mapped buffers, and for the
 * i.MX31 vendor kernel's, which enumerates nothing, rounds sizes down to
 * multiples of 8, has three buffers at most, wants two of them before it
 * streams and leaves times and numbers of pictures unset. Nothing here looks
 * at those, and nothing waits but v4l2_device_dequeue().
 */
#ifndef PLATFORM_CAMERA_V4L2_DEVICE_H
#define PLATFORM_CAMERA_V4L2_DEVICE_H

#include "platform/camera/camera.h"
#include "platform/camera/v4l2/convert_library.h"
#include "platform/camera/v4l2/v4l2_calls.h"

#include <linux/videodev2.h>

enum {
	V4L2_BUFFERS = 3,
	V4L2_PATH_BYTES = 128,
	V4L2_REASON_BYTES = 256
};

/* What a device is wanted for. */
struct v4l2_request {
	char path[V4L2_PATH_BYTES];
	int width, height;
	uint32_t fourcc; /* 0: choose */
};

struct v4l2_buffer_map {
	uint8_t *data;
	size_t length;
	uint8_t *rgb; /* converted, where the library is needed */
	bool queued;  /* the driver has it */
};

struct v4l2_device {
	const struct v4l2_calls *calls;
	int fd; /* -1: closed */
	struct v4l2_format answer;
	enum camera_format format; /* of what images hold */
	int width, height;
	struct camera_layout layout;
	struct convert_library *library; /* or NULL */
	int buffer_count;
	struct v4l2_buffer_map buffer[V4L2_BUFFERS];
	bool streaming;
	char reason[V4L2_REASON_BYTES]; /* why something failed, a sentence */
};

/*
 * Opens, negotiates and streams. 0, or -errno with device->reason set and
 * nothing left open.
 */
int v4l2_device_open(struct v4l2_device *device, const struct v4l2_calls *calls,
	const struct v4l2_request *request);

/*
 * Waits up to timeout_ms (a driver that ignores O_NONBLOCK longer) for the
 * oldest picture. Its buffer's index, or -EAGAIN when there is none or it was
 * damaged, or another -errno, with device->reason set, when the device is of
 * no more use.
 */
int v4l2_device_dequeue(struct v4l2_device *device, int timeout_ms);

/* Gives a buffer to the driver. 0 or -errno with the reason. */
int v4l2_device_queue(struct v4l2_device *device, int index);

/* How many buffers the driver has. */
int v4l2_device_queued(const struct v4l2_device *device);

/* The picture in a dequeued buffer. */
struct camera_image v4l2_device_image(
	const struct v4l2_device *device, int index);

/* Stops and closes; a device that is closed is fine. */
void v4l2_device_close(struct v4l2_device *device);

/* Whether it captures into mapped buffers; -errno, silently, when not. */
int v4l2_device_check(const struct v4l2_calls *calls, const char *path);

#endif
