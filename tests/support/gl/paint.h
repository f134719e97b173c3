/*
 * Sets pixels of a display, in whatever format it has.
 */
#ifndef TESTS_SUPPORT_GL_PAINT_H
#define TESTS_SUPPORT_GL_PAINT_H

#include "platform/display/pixels.h"

/* Channels are 0..255; RGB565 keeps their upper bits. */
void paint_pixel(const struct pixels *pixels, int x, int y, int red, int green,
	int blue);
void paint_all(const struct pixels *pixels, int red, int green, int blue);

#endif
