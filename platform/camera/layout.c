#include "platform/camera/camera.h"

#include <string.h>

static const char *const names[CAMERA_FORMATS] = {
	[CAMERA_RGB565] = "rgb565",
	[CAMERA_UYVY] = "uyvy",
	[CAMERA_YUYV] = "yuyv",
	[CAMERA_NV12] = "nv12",
	[CAMERA_YUV420] = "yuv420",
	[CAMERA_RGB24] = "rgb24",
	[CAMERA_BGR24] = "bgr24",
};

enum camera_format camera_format_find(const char *name)
{
	int format = 0;

	while (format < CAMERA_FORMATS && strcmp(name, names[format]) != 0) {
		format++;
	}
	return (enum camera_format)format;
}

/* The bytes of a row of the first plane, without padding. */
static int row_bytes(enum camera_format format, int width)
{
	switch (format) {
	case CAMERA_RGB565:
		return width * 2;
	case CAMERA_UYVY:
	case CAMERA_YUYV:
		return (width + 1) / 2 * 4;
	case CAMERA_RGB24:
	case CAMERA_BGR24:
		return width * 3;
	default:
		return width;
	}
}

struct camera_layout camera_layout_of(enum camera_format format, int width,
	int height, int least_stride_bytes)
{
	struct camera_layout layout = {0};
	int row = row_bytes(format, width);
	int half_rows = (height + 1) / 2;
	int stride = row > least_stride_bytes ? row : least_stride_bytes;

	layout.stride_bytes[0] = stride;
	layout.size = stride * height;
	if (format == CAMERA_NV12) {
		layout.stride_bytes[1] = (stride + 1) / 2 * 2;
		layout.offset[1] = layout.size;
		layout.size += layout.stride_bytes[1] * half_rows;
	} else if (format == CAMERA_YUV420) {
		for (int i = 1; i < CAMERA_PLANES; i++) {
			layout.stride_bytes[i] = (stride + 1) / 2;
			layout.offset[i] = layout.size;
			layout.size += layout.stride_bytes[i] * half_rows;
		}
	}
	return layout;
}

struct camera_image camera_image_at(enum camera_format format, int width,
	int height, const struct camera_layout *layout, const uint8_t *data)
{
	struct camera_image image = {
		.format = format, .width = width, .height = height};

	for (int i = 0; i < CAMERA_PLANES; i++) {
		image.plane[i] = data + layout->offset[i];
		image.stride_bytes[i] = layout->stride_bytes[i];
	}
	return image;
}
