#include "tests/support/gl/paint.h"

#include <string.h>

void paint_pixel(
	const struct pixels *pixels, int x, int y, int red, int green, int blue)
{
	uint8_t *at = pixels->data + y * pixels->stride_bytes +
		x * pixel_bytes(pixels->format);

	if (pixels->format == PIXELS_RGB565) {
		uint16_t pixel =
			(uint16_t)(red >> 3 << 11 | green >> 2 << 5 | blue >> 3);

		memcpy(at, &pixel, 2);
	} else {
		memcpy(at,
			(const uint8_t[]){
				(uint8_t)red, (uint8_t)green, (uint8_t)blue, 0},
			4);
	}
}

void paint_all(const struct pixels *pixels, int red, int green, int blue)
{
	for (int y = 0; y < pixels->height; y++) {
		for (int x = 0; x < pixels->width; x++) {
			paint_pixel(pixels, x, y, red, green, blue);
		}
	}
}
