/*
 * A picture in memory, which displays hand out and GL drivers draw into.
 */
#ifndef PLATFORM_DISPLAY_PIXELS_H
#define PLATFORM_DISPLAY_PIXELS_H

#include <stdbool.h>
#include <stdint.h>

#include "platform/base/log.h"

enum pixel_format {
	PIXELS_RGB565,   /* uint16_t in the machine's byte order */
	PIXELS_RGBA8888, /* bytes R G B A */
};

struct pixels {
	uint8_t *data; /* top row first; not owned */
	int width, height;
	int stride_bytes;
	enum pixel_format format;
};

enum {
	PIXELS_SIZE_MAX = 8192
};

/* Copies the rows of a picture of the same size and format. */
void pixels_copy(const struct pixels *to, const struct pixels *from);

/* Reads "rgb565" or "rgba8888". Returns false for anything else. */
bool pixel_format_parse(const char *text, enum pixel_format *out);

/* The size of a pixel in bytes. */
static inline int pixel_bytes(enum pixel_format format)
{
	return format == PIXELS_RGB565 ? 2 : 4;
}

/*
 * Allocates a zeroed picture without padding between its rows. The caller
 * frees out->data. Returns 0, or after logging an error -EINVAL for a size
 * outside 1..PIXELS_SIZE_MAX, or -ENOMEM.
 */
int pixels_alloc(struct pixels *out, int width, int height,
	enum pixel_format format, const struct log *log);

#endif
