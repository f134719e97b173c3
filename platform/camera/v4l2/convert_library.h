/*
 * libv4lconvert, which converts the formats that limber cannot read itself,
 * such as JPEG and Bayer, to RGB24. It is opened at run time; without it these
 * formats are refused.
 */
#ifndef PLATFORM_CAMERA_V4L2_CONVERT_LIBRARY_H
#define PLATFORM_CAMERA_V4L2_CONVERT_LIBRARY_H

#include <stdbool.h>
#include <stdint.h>

#include <linux/videodev2.h>

#include "platform/camera/v4l2/v4l2_calls.h"

struct convert_library;

/* Whether the library is installed. */
bool convert_library_is_available(void);

/*
 * Creates a converter for an open device. format is the device's answer to
 * VIDIOC_S_FMT; the result is RGB24 of the same size without padding. Returns
 * 0, -ENOENT when the library is missing, -EINVAL when the library does not
 * support the device, or -ENOMEM.
 */
int convert_library_open(const struct v4l2_calls *calls, int fd,
	const struct v4l2_format *format, struct convert_library **out);

/* Converts a picture to width * height * 3 bytes. Returns 0 or -EIO. */
int convert_library_run(struct convert_library *library, const uint8_t *data,
	uint32_t size, uint8_t *rgb, int rgb_size);

/* NULL is fine. */
void convert_library_close(struct convert_library *library);

#endif
