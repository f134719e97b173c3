/*
 * libv4lconvert for the formats that limber does not read itself: JPEG, Bayer
 * and so on become RGB24. Opened at run time; without it these formats are
 * refused.
 */
#ifndef PLATFORM_CAMERA_V4L2_CONVERT_LIBRARY_H
#define PLATFORM_CAMERA_V4L2_CONVERT_LIBRARY_H

#include <stdbool.h>
#include <stdint.h>

#include <linux/videodev2.h>

#include "platform/camera/v4l2/v4l2_calls.h"

struct convert_library;

/* Whether the library is there. */
bool convert_library_is_available(void);

/*
 * A converter from what the open device delivers, format being its answer to
 * VIDIOC_S_FMT, to RGB24 of the same size without gaps. 0, -ENOENT when the
 * library is missing, -EINVAL when it does not want the device, or -ENOMEM.
 */
int convert_library_open(const struct v4l2_calls *calls, int fd,
	const struct v4l2_format *format, struct convert_library **out);

/* One picture into width * height * 3 bytes; 0 or -EIO. */
int convert_library_run(struct convert_library *library, const uint8_t *data,
	uint32_t size, uint8_t *rgb, int rgb_size);

/* NULL is fine. */
void convert_library_close(struct convert_library *library);

#endif
