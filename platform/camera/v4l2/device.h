/*
 * An open V4L2 device: its format, its mapped buffers and its stream.
 *
 * It works with any driver that captures into mapped buffers, including that of
 * the i.MX31 vendor kernel. This driver lists no formats, rounds sizes down to
 * multiples of 8, has at most three buffers, needs two of them to stream, and
 * sets no time stamps and sequence numbers. Only v4l2_device_dequeue() waits.
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

/* What the user asks for. */
struct v4l2_request {
	char path[V4L2_PATH_BYTES];
	int width, height;
	uint32_t fourcc; /* 0 to choose one */
};

struct v4l2_buffer_map {
	uint8_t *data;
	size_t length;
	uint8_t *rgb; /* the converted picture when the library is used */
	bool queued;  /* the driver has the buffer */
};

struct v4l2_device {
	const struct v4l2_calls *calls;
	int fd;                    /* -1: closed */
	struct v4l2_format answer; /* the device's answer to VIDIOC_S_FMT */
	enum camera_format format; /* of v4l2_device_image() */
	int width, height;
	struct camera_layout layout;
	struct convert_library *library; /* NULL when it is not needed */
	int buffer_count;
	struct v4l2_buffer_map buffer[V4L2_BUFFERS];
	bool streaming;
	char reason[V4L2_REASON_BYTES]; /* why the last call failed */
};

/*
 * Opens the device, sets its format, maps its buffers and starts streaming.
 * Returns 0, or -errno with device->reason set and nothing left open: -ENOTTY
 * if it captures no video into mapped buffers.
 */
int v4l2_device_open(struct v4l2_device *device, const struct v4l2_calls *calls,
	const struct v4l2_request *request);

/*
 * Waits up to timeout_ms for the oldest picture, or longer if the driver
 * ignores O_NONBLOCK. Returns the index of its buffer, -EAGAIN when there is no
 * picture or it was damaged, or another -errno with device->reason set when the
 * device has failed.
 */
int v4l2_device_dequeue(struct v4l2_device *device, int timeout_ms);

/* Gives a buffer to the driver. Returns 0, or -errno with the reason set. */
int v4l2_device_queue(struct v4l2_device *device, int index);

/* The number of buffers that the driver has. */
int v4l2_device_queued(const struct v4l2_device *device);

/* Returns the picture in a dequeued buffer. */
struct camera_image v4l2_device_image(
	const struct v4l2_device *device, int index);

/* Stops streaming and closes the device. A closed device is fine. */
void v4l2_device_close(struct v4l2_device *device);

#endif
