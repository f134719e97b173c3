/*
 * Copies a picture of 480 x 640 pixels to a screen whose pixels have another
 * layout, for the timing model.
 *
 *	make build/arm/bench/screen_rows build/arm1136/model.so
 *	qemu-arm -cpu arm1136 -L build/sysroot \
 *		-plugin build/arm1136/model.so build/arm/bench/screen_rows
 *
 * Each layout is a region; layouts[] has them in the order of their numbers.
 */
#include "platform/display/packing.h"
#include "tests/arm1136/marker.h"

#include <stdio.h>
#include <stdlib.h>

enum {
	WIDTH = 480,
	HEIGHT = 640
};

static const struct {
	enum pixel_format format;
	struct pixel_layout layout;
} layouts[] = {
	{PIXELS_RGB565, {16, {11, 5}, {5, 6}, {0, 5}, {0, 0}, false}},
	{PIXELS_RGBA8888, {32, {0, 8}, {8, 8}, {16, 8}, {0, 0}, false}},
	{PIXELS_RGBA8888, {32, {0, 8}, {8, 8}, {16, 8}, {24, 8}, false}},
	{PIXELS_RGBA8888, {32, {16, 8}, {8, 8}, {0, 8}, {0, 0}, false}},
	{PIXELS_RGBA8888, {32, {16, 8}, {8, 8}, {0, 8}, {24, 8}, false}},
	{PIXELS_RGBA8888, {24, {16, 8}, {8, 8}, {0, 8}, {0, 0}, false}},
	{PIXELS_RGB565, {16, {10, 5}, {5, 5}, {0, 5}, {15, 1}, false}},
};

static struct packing packing;
static uint8_t screen[WIDTH * HEIGHT * 4];

static void prepare(int number)
{
	packing_init(&packing, layouts[number].format, &layouts[number].layout);
}

static void copy(struct pixels *picture, int number)
{
	picture->format = layouts[number].format;
	picture->stride_bytes = WIDTH * pixel_bytes(picture->format);
	packing_copy(&packing, picture, screen, WIDTH * packing.bytes);
}

int main(void)
{
	struct pixels picture = {.width = WIDTH, .height = HEIGHT};

	picture.data = malloc(sizeof(screen));
	if (!picture.data) {
		return 1;
	}
	for (size_t i = 0; i < sizeof(screen); i++) {
		picture.data[i] = (uint8_t)((uint32_t)i * 2654435761u >> 24);
	}
#define REGION(number)                  \
	do {                            \
		prepare(number);        \
		MARKER_BEGIN(number);   \
		copy(&picture, number); \
		MARKER_END(number);     \
	} while (0)
	REGION(0);
	REGION(1);
	REGION(2);
	REGION(3);
	REGION(4);
	REGION(5);
	REGION(6);
	free(picture.data);
	return 0;
}
