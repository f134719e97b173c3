/* Loops over pixels of RGB565, the halves of words, and over 16-bit depths. */
#ifndef PLATFORM_GL_SOFT_RASTER_MIX_H
#define PLATFORM_GL_SOFT_RASTER_MIX_H

#include <stdbool.h>
#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/soft/raster/pixel.h"

static ALWAYS_INLINE uint32_t soft_load_two(const uint16_t *at)
{
	return load_32((const uint8_t *)at);
}

/* Blends each pixel with one of own, or with a colour, by share / 32. */
void soft_mix_pixels(
	uint16_t *pixel, const uint16_t *own, int count, uint32_t share);
void soft_mix_color(uint16_t *pixel, uint16_t color, int count, uint32_t share);

/* Whether count pixels, at least one, are all equal. */
bool soft_is_one_color(const uint16_t *pixel, int count);

/* arm/fill.S or portable/loops.c: sets count pixels to the value. */
void soft_fill_pixels(uint16_t *pixel, int count, uint16_t value);

#endif
