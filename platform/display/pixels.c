#include "platform/display/pixels.h"

#include "platform/base/compiler.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

int pixels_alloc(struct pixels *out, int width, int height,
	enum pixel_format format, const struct log *log)
{
	uint8_t *data;

	if (width < 1 || width > PIXELS_SIZE_MAX || height < 1 ||
		height > PIXELS_SIZE_MAX) {
		log_error(log, "--size %dx%d: choose a size from 1x1 to %dx%d",
			width, height, PIXELS_SIZE_MAX, PIXELS_SIZE_MAX);
		return -EINVAL;
	}
	/* At most 4 * 8192 * 8192 = 2^28 bytes. */
	data = calloc((size_t)height, (size_t)(width * pixel_bytes(format)));
	if (!data) {
		log_error(log,
			"there is not enough memory for a picture of %dx%d pixels",
			width, height);
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

void pixels_copy(const struct pixels *to, const struct pixels *from)
{
	size_t row = (size_t)from->width * (size_t)pixel_bytes(from->format);

	for (int y = 0; y < from->height; y++) {
		memcpy(to->data + (size_t)y * (size_t)to->stride_bytes,
			from->data + (size_t)y * (size_t)from->stride_bytes,
			row);
	}
}

bool pixel_format_parse(const char *text, enum pixel_format *out)
{
	static const char *const names[] = {
		[PIXELS_RGB565] = "rgb565",
		[PIXELS_RGBA8888] = "rgba8888",
	};

	for (int i = 0; i < (int)ARRAY_COUNT(names); i++) {
		if (strcmp(text, names[i]) == 0) {
			*out = (enum pixel_format)i;
			return true;
		}
	}
	return false;
}
