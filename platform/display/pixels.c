#include "platform/display/pixels.h"

#include <errno.h>
#include <stdlib.h>

int pixels_alloc(struct pixels *out, int width, int height,
	enum pixel_format format, const struct log *log)
{
	uint8_t *data;

	if (width < 1 || width > PIXELS_SIZE_MAX || height < 1 ||
		height > PIXELS_SIZE_MAX) {
		log_error(log, "--size %dx%d: choose from 1x1 to %dx%d", width,
			height, PIXELS_SIZE_MAX, PIXELS_SIZE_MAX);
		return -EINVAL;
	}
	/* 4 * 8192 * 8192 = 2^28 */
	data = calloc((size_t)height, (size_t)(width * pixel_bytes(format)));
	if (!data) {
		log_error(log, "--size %dx%d: out of memory", width, height);
		return -ENOMEM;
	}
	*out = (struct pixels){
		.data = data,
		.width = width,
		.height = height,
		.stride_bytes = width * pixel_bytes(format),
		.format = format,
	};
	return 0;
}
