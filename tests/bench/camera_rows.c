/*
 * Converts a camera picture of 320 x 240 pixels to RGB565, once from each
 * format, for the timing model.
 *
 *	make build/arm/bench/camera_rows build/arm1136/model.so
 *	qemu-arm -cpu arm1136 -L build/sysroot \
 *		-plugin build/arm1136/model.so build/arm/bench/camera_rows
 *
 * Divide by 76800 for the cost of a pixel. A region has the number of its
 * format; region 10 scales 640 x 480 down by a half.
 */
#include "platform/camera/convert.h"
#include "tests/arm1136/marker.h"

#include <stdio.h>
#include <stdlib.h>

enum {
	WIDTH = 320,
	HEIGHT = 240
};

static struct camera_scaler scaler;
static uint16_t out[WIDTH * HEIGHT];

static void convert(const struct camera_image *image)
{
	struct camera_part part = {0, 0, image->width, image->height};

	camera_convert(&scaler, image, &part, WIDTH, HEIGHT, out, WIDTH);
}

int main(void)
{
	uint8_t *data = malloc(4 * WIDTH * HEIGHT * 3);
	struct camera_image image[CAMERA_FORMATS], large;
	struct camera_layout layout;

	if (!data) {
		return 1;
	}
	for (int i = 0; i < 4 * WIDTH * HEIGHT * 3; i++) {
		data[i] = (uint8_t)((uint32_t)i * 2654435761u >> 24);
	}
	for (int i = 0; i < CAMERA_FORMATS; i++) {
		enum camera_format format = (enum camera_format)i;

		layout = camera_layout_of(format, WIDTH, HEIGHT, 0);
		image[i] = camera_image_at(format, WIDTH, HEIGHT, &layout, data);
	}
	layout = camera_layout_of(CAMERA_UYVY, 2 * WIDTH, 2 * HEIGHT, 0);
	large = camera_image_at(
		CAMERA_UYVY, 2 * WIDTH, 2 * HEIGHT, &layout, data);
#define REGION(number, picture)       \
	do {                          \
		MARKER_BEGIN(number); \
		convert(picture);     \
		MARKER_END(number);   \
	} while (0)
	REGION(0, &image[CAMERA_RGB565]);
	REGION(1, &image[CAMERA_UYVY]);
	REGION(2, &image[CAMERA_YUYV]);
	REGION(3, &image[CAMERA_NV12]);
	REGION(4, &image[CAMERA_YUV420]);
	REGION(5, &image[CAMERA_RGB24]);
	REGION(10, &large);
	free(data);
	return 0;
}
