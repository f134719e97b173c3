/* Pixels of RGB565 and RGBA8888, one at a time. */
#ifndef PLATFORM_GL_SOFT_RASTER_PIXEL_H
#define PLATFORM_GL_SOFT_RASTER_PIXEL_H

#include <string.h>

#include "platform/gl/soft/soft.h"

static inline uint16_t pack_565(int red, int green, int blue)
{
	return (uint16_t)((red * 249 + 1014) >> 11 << 11 |
		(green * 253 + 505) >> 10 << 5 | (blue * 249 + 1014) >> 11);
}

/* Expands five and six bits to eight: all ones become 255. */
static inline void unpack_565(uint16_t pixel, uint8_t out[3])
{
	int red = pixel >> 11, green = pixel >> 5 & 63, blue = pixel & 31;

	out[0] = (uint8_t)(red << 3 | red >> 2);
	out[1] = (uint8_t)(green << 2 | green >> 4);
	out[2] = (uint8_t)(blue << 3 | blue >> 2);
}

/*
 * A wide pixel is RGB565 with green moved up by 16 bits: five bits of room
 * above each field, so that one multiplication scales all three by n / 32.
 */
enum {
	WIDE_MASK = 0x07E0F81F,
	WIDE_ROUND = 0x02008010, /* 1/2 for every field, before >> 5 */
};

static inline uint32_t widen(uint32_t pixel)
{
	return (pixel | pixel << 16) & WIDE_MASK;
}

static inline uint16_t narrow(uint32_t wide)
{
	return (uint16_t)(wide | wide >> 16);
}

/* Blends wide pixels: a + (b - a) * share / 32. */
static inline uint32_t mix_wide(uint32_t a, uint32_t b, uint32_t share)
{
	return (a * 32 + (b - a) * share + WIDE_ROUND) >> 5 & WIDE_MASK;
}

/*
 * A pixel of colours of 8.16: 31/32 or 63/64 of them and half a step have the
 * nearest of 0 to 31 or 0 to 63 in their upper bits.
 */
static inline uint16_t color_565(uint32_t r, uint32_t g, uint32_t b)
{
	r += (1 << 18) - (r >> 5);
	g += (1 << 17) - (g >> 6);
	b += (1 << 18) - (b >> 5);
	return (uint16_t)(r >> 19 << 11 | g >> 18 << 5 | b >> 19);
}

/* A pixel in both halves of a word. */
static inline uint32_t twice_565(uint32_t pixel)
{
	return pixel | pixel << 16;
}

static inline uint16_t load_16(const uint8_t *at)
{
	uint16_t value;

	memcpy(&value, at, sizeof(value));
	return value;
}

static inline uint32_t load_32(const uint8_t *at)
{
	uint32_t value;

	memcpy(&value, at, sizeof(value));
	return value;
}

static inline void store_16(uint8_t *at, uint16_t value)
{
	memcpy(at, &value, sizeof(value));
}

/* RGB565 has no alpha: it reads as 255. */
static inline void load_pixel(
	enum pixel_format format, const uint8_t *at, uint8_t rgba[4])
{
	if (format == PIXELS_RGB565) {
		unpack_565(load_16(at), rgba);
		rgba[3] = 255;
	} else {
		memcpy(rgba, at, 4);
	}
}

static inline uint8_t *pixel_at(const struct pixels *target, int x, int y)
{
	return target->data + (ptrdiff_t)y * target->stride_bytes +
		x * pixel_bytes(target->format);
}

#endif
