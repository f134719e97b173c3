/*
 * Blends two pixels of RGB565, the halves of a word, at a time. Masking the
 * word gives one wide pixel (see pixel.h) of this pixel's red and blue and the
 * other one's green; masking it with its halves swapped gives the rest.
 */
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

static ALWAYS_INLINE void soft_store_two(uint16_t *at, uint32_t two)
{
	memcpy(at, &two, sizeof(two));
}

static ALWAYS_INLINE uint32_t soft_swap_halves(uint32_t word)
{
	return word >> 16 | word << 16;
}

/* (pixel * keep + own) >> 5 of two pixels, own being wide: as it is, swapped. */
static ALWAYS_INLINE uint32_t soft_keep_two(
	uint32_t two, uint32_t keep, uint32_t own, uint32_t own_swapped)
{
	uint32_t a = two & WIDE_MASK, b = soft_swap_halves(two) & WIDE_MASK;

	a = (a * keep + own) >> 5 & WIDE_MASK;
	b = (b * keep + own_swapped) >> 5 & WIDE_MASK;
	return a | soft_swap_halves(b);
}

/* Blends two pixels with two others, to, by share / 32. */
static ALWAYS_INLINE uint32_t soft_mix_two(
	uint32_t two, uint32_t to, uint32_t share)
{
	uint32_t own = (to & WIDE_MASK) * share + WIDE_ROUND;
	uint32_t swapped =
		(soft_swap_halves(to) & WIDE_MASK) * share + WIDE_ROUND;

	return soft_keep_two(two, 32 - share, own, swapped);
}

/* Each pixel becomes (pixel * keep + own) >> 5, wide; own holds the rounding. */
void soft_keep_pixels(uint16_t *pixel, int count, uint32_t keep, uint32_t own);

/* Blends each pixel with one of own, by share / 32. */
void soft_mix_pixels(
	uint16_t *pixel, const uint16_t *own, int count, uint32_t share);

/* Whether count pixels, at least one, are all equal. */
bool soft_is_one_color(const uint16_t *pixel, int count);

/* arm/fill.S or portable/loops.c: sets count pixels to the value. */
void soft_fill_pixels(uint16_t *pixel, int count, uint16_t value);

#endif
