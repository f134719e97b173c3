/*
 * Choosing the format that a V4L2 device delivers.
 */
#ifndef PLATFORM_CAMERA_V4L2_FORMAT_H
#define PLATFORM_CAMERA_V4L2_FORMAT_H

#include "platform/camera/v4l2/device.h"

/* The camera format of a code, or CAMERA_FORMATS if limber cannot read it. */
enum camera_format v4l2_format_of(uint32_t fourcc);

/*
 * The V4L2 code of a name: that of a camera format, such as "uyvy", or the four
 * letters of any code; 0 for other names.
 */
uint32_t v4l2_format_find(const char *name);

/* Writes the four letters of a code. */
void v4l2_format_text(uint32_t fourcc, char text[5]);

/*
 * Sets the requested format of an open device. When none is requested, it sets
 * the cheapest format that limber can read or, if there is none, the first one
 * of the device. Fills the device's answer, format, width and height; format is
 * CAMERA_FORMATS when the library must convert it. Returns 0, or -errno with
 * the device's reason set.
 */
int v4l2_format_negotiate(
	struct v4l2_device *device, const struct v4l2_request *request);

#endif
