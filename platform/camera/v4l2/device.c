#include "platform/camera/v4l2/device.h"

#include "platform/camera/v4l2/format.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int call(
	const struct v4l2_device *device, unsigned long request, void *argument)
{
	return device->calls->ioctl(
		device->calls->user, device->fd, request, argument);
}

static int fail(struct v4l2_device *device, int error, const char *what)
{
	if (error == -EBUSY) {
		snprintf(device->reason, sizeof(device->reason),
			"another program is using it: close that program");
	} else if (error == -ENODEV || error == -ENXIO) {
		snprintf(device->reason, sizeof(device->reason),
			"it was unplugged");
	} else {
		snprintf(device->reason, sizeof(device->reason), "%s (%s)",
			what, strerror(-error));
	}
	return error;
}

/*
 * Returns 0 if the device captures single-planar video into mapped buffers,
 * else -errno.
 */
static int check_capabilities(const struct v4l2_device *device)
{
	struct v4l2_capability capability = {0};
	int error = call(device, VIDIOC_QUERYCAP, &capability);
	uint32_t bits;

	if (error) {
		return error;
	}
	bits = capability.capabilities & V4L2_CAP_DEVICE_CAPS
		? capability.device_caps
		: capability.capabilities;
	return bits & V4L2_CAP_VIDEO_CAPTURE && bits & V4L2_CAP_STREAMING
		? 0
		: -ENOTTY;
}

static int open_path(struct v4l2_device *device, const char *path)
{
	int error;

	device->fd = device->calls->open(device->calls->user, path);
	if (device->fd >= 0) {
		error = check_capabilities(device);
		if (error == -ENOTTY || error == -EINVAL) {
			snprintf(device->reason, sizeof(device->reason),
				"it captures no video into mapped buffers: choose another device");
			return -ENOTTY;
		}
		return error
			? fail(device, error, "it does not tell what it can do")
			: 0;
	}
	if (device->fd == -ENOENT) {
		snprintf(device->reason, sizeof(device->reason),
			"no such device: plug it in");
		return -ENOENT;
	}
	if (device->fd == -EACCES) {
		snprintf(device->reason, sizeof(device->reason),
			"no permission: join the group video");
		return -EACCES;
	}
	return fail(device, device->fd, "it cannot be opened");
}

/*
 * Sets the layout, with the driver's stride or the smallest possible one, and
 * opens the library if it must convert the format.
 */
static int set_layout(struct v4l2_device *device)
{
	int stride = (int)device->answer.fmt.pix.bytesperline;
	char text[5];
	int error;

	if (device->format != CAMERA_FORMATS) {
		device->layout = camera_layout_of(
			device->format, device->width, device->height, stride);
		return 0;
	}
	error = convert_library_open(
		device->calls, device->fd, &device->answer, &device->library);
	if (error) {
		v4l2_format_text(device->answer.fmt.pix.pixelformat, text);
		snprintf(device->reason, sizeof(device->reason),
			"its format %s needs libv4lconvert (%s): install libv4lconvert0",
			text, error == -ENOENT ? "not found" : strerror(-error));
		return -ENOTSUP;
	}
	device->format = CAMERA_RGB24;
	device->layout = camera_layout_of(
		CAMERA_RGB24, device->width, device->height, 0);
	return 0;
}

static int map_buffer(struct v4l2_device *device, int index)
{
	struct v4l2_buffer_map *map = &device->buffer[index];
	struct v4l2_buffer info = {
		.index = (uint32_t)index,
		.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		.memory = V4L2_MEMORY_MMAP,
	};
	int error = call(device, VIDIOC_QUERYBUF, &info);

	if (error) {
		return fail(device, error, "it does not describe its buffers");
	}
	if (!device->library && info.length < (uint32_t)device->layout.size) {
		snprintf(device->reason, sizeof(device->reason),
			"its buffers of %u bytes are too small for %dx%d pixels",
			info.length, device->width, device->height);
		return -EINVAL;
	}
	map->data = device->calls->map(
		device->calls->user, device->fd, info.length, info.m.offset);
	if (!map->data) {
		snprintf(device->reason, sizeof(device->reason),
			"its buffers cannot be mapped");
		return -ENOMEM;
	}
	map->length = info.length;
	if (device->library) {
		map->rgb = calloc(1, (size_t)device->layout.size);
		if (!map->rgb) {
			snprintf(device->reason, sizeof(device->reason),
				"there is not enough memory for its pictures");
			return -ENOMEM;
		}
	}
	return v4l2_device_queue(device, index);
}

static int make_buffers(struct v4l2_device *device)
{
	struct v4l2_requestbuffers request = {
		.count = V4L2_BUFFERS,
		.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		.memory = V4L2_MEMORY_MMAP,
	};
	int error = call(device, VIDIOC_REQBUFS, &request);

	if (error) {
		return fail(device, error, "it provides no buffers");
	}
	if (request.count < 2) {
		snprintf(device->reason, sizeof(device->reason),
			"it has not enough memory for two pictures");
		return -ENOMEM;
	}
	device->buffer_count = request.count < V4L2_BUFFERS ? (int)request.count
							    : V4L2_BUFFERS;
	for (int i = 0; i < device->buffer_count; i++) {
		error = map_buffer(device, i);
		if (error) {
			return error;
		}
	}
	return 0;
}

static int start(struct v4l2_device *device)
{
	int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;
	int error = call(device, VIDIOC_STREAMON, &type);

	if (error) {
		return fail(device, error, "it does not start streaming");
	}
	device->streaming = true;
	return 0;
}

int v4l2_device_open(struct v4l2_device *device, const struct v4l2_calls *calls,
	const struct v4l2_request *request)
{
	int error;

	*device = (struct v4l2_device){.calls = calls};
	error = open_path(device, request->path);
	if (!error) {
		error = v4l2_format_negotiate(device, request);
	}
	if (!error) {
		error = set_layout(device);
	}
	if (!error) {
		error = make_buffers(device);
	}
	if (!error) {
		error = start(device);
	}
	if (error) {
		v4l2_device_close(device);
	}
	return error;
}

/*
 * Whether a picture is incomplete and must be dropped; the last complete one
 * stays in use.
 */
static bool is_damaged(
	const struct v4l2_device *device, const struct v4l2_buffer *buffer)
{
	if (buffer->flags & V4L2_BUF_FLAG_ERROR) {
		return true;
	}
	/* A driver that claims more than its buffer holds is not trusted. */
	if (buffer->bytesused > device->buffer[buffer->index].length) {
		return true;
	}
	/* Some drivers leave bytesused at 0. */
	return !device->library && buffer->bytesused != 0 &&
		buffer->bytesused < (uint32_t)device->layout.size;
}

/* Errors after which the device can still deliver pictures. */
static bool is_temporary(int error)
{
	return error == -EAGAIN || error == -ETIME || error == -EIO ||
		error == -ETIMEDOUT;
}

int v4l2_device_dequeue(struct v4l2_device *device, int timeout_ms)
{
	struct v4l2_buffer buffer = {
		.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		.memory = V4L2_MEMORY_MMAP,
	};
	struct v4l2_buffer_map *map;
	int index,
		result = device->calls->wait(
			device->calls->user, device->fd, timeout_ms);

	if (result == 0) {
		return -EAGAIN;
	}
	if (result < 0) {
		return fail(device, result, "limber cannot wait for a picture");
	}
	result = call(device, VIDIOC_DQBUF, &buffer);
	if (result) {
		return is_temporary(result)
			? -EAGAIN
			: fail(device, result, "it delivers no picture");
	}
	index = (int)buffer.index;
	if (index < 0 || index >= device->buffer_count ||
		!device->buffer[index].queued) {
		return fail(device, -EINVAL,
			"it returned a buffer that it does not have");
	}
	map = &device->buffer[index];
	map->queued = false;
	if (!is_damaged(device, &buffer) &&
		(!device->library ||
			convert_library_run(device->library, map->data,
				buffer.bytesused, map->rgb,
				device->layout.size) == 0)) {
		return index;
	}
	result = v4l2_device_queue(device, index);
	return result ? result : -EAGAIN;
}

int v4l2_device_queue(struct v4l2_device *device, int index)
{
	struct v4l2_buffer buffer = {
		.index = (uint32_t)index,
		.type = V4L2_BUF_TYPE_VIDEO_CAPTURE,
		.memory = V4L2_MEMORY_MMAP,
	};
	int error = call(device, VIDIOC_QBUF, &buffer);

	if (error) {
		return fail(device, error, "it accepts no buffer");
	}
	device->buffer[index].queued = true;
	return 0;
}

int v4l2_device_queued(const struct v4l2_device *device)
{
	int count = 0;

	for (int i = 0; i < device->buffer_count; i++) {
		count += device->buffer[i].queued;
	}
	return count;
}

struct camera_image v4l2_device_image(
	const struct v4l2_device *device, int index)
{
	const struct v4l2_buffer_map *map = &device->buffer[index];

	return camera_image_at(device->format, device->width, device->height,
		&device->layout, map->rgb ? map->rgb : map->data);
}

void v4l2_device_close(struct v4l2_device *device)
{
	int type = V4L2_BUF_TYPE_VIDEO_CAPTURE;

	if (device->streaming) {
		call(device, VIDIOC_STREAMOFF, &type);
		device->streaming = false;
	}
	for (int i = 0; i < V4L2_BUFFERS; i++) {
		struct v4l2_buffer_map *map = &device->buffer[i];

		if (map->data) {
			device->calls->unmap(
				device->calls->user, map->data, map->length);
		}
		free(map->rgb);
		*map = (struct v4l2_buffer_map){0};
	}
	device->buffer_count = 0;
	convert_library_close(device->library);
	device->library = NULL;
	if (device->fd >= 0) {
		device->calls->close(device->calls->user, device->fd);
	}
	device->fd = -1;
}
