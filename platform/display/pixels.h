/*
 * A picture in memory: what displays hand out and GL drivers draw into.
 */
#ifndef PLATFORM_DISPLAY_PIXELS_H
#define PLATFORM_DISPLAY_PIXELS_H

#include <stdint.h>

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

static inline int pixel_bytes(enum pixel_format format)
{
	return format == PIXELS_RGB565 ? 2 : 4;
}

#endif
