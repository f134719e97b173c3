/*
 * Which format a V4L2 device is to deliver.
 */
#ifndef PLATFORM_CAMERA_V4L2_FORMAT_H
#define PLATFORM_CAMERA_V4L2_FORMAT_H

#include "platform/camera/v4l2/device.h"

/* The format that limber reads itself, or CAMERA_FORMATS. */
enum camera_format v4l2_format_of(uint32_t fourcc);

/* A camera_format's name or a code of four letters; 0 for neither. */
uint32_t v4l2_format_find(const char *name);

/* The code's letters. */
void v4l2_format_text(uint32_t fourcc, char text[5]);

/*
 * Sets the wished format or, without a request, the cheapest that limber reads,
 * or else the first that the device has. Fills answer, format, width and
 * height; format is CAMERA_FORMATS for one that needs converting. 0, or
 * -errno with the reason.
 */
int v4l2_format_negotiate(
	struct v4l2_device *device, const struct v4l2_request *request);

#endif
