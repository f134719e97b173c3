/*
 * Rows of large triangles with a luminance texture that repeats, in one colour
 * or in shades of gray that vary, opaque or blended by alpha, into RGB565.
 * Depth is tested LESS, or not at all.
 *
 * The four texels around a centre lie in one word (tiles.h), and pixels in a
 * patch of equal texels are found at once. Tables have the colours that
 * luminance becomes.
 */
#ifndef PLATFORM_GL_SOFT_FAST_LUMINANCE_H
#define PLATFORM_GL_SOFT_FAST_LUMINANCE_H

#include "platform/gl/soft/raster/raster.h"

/* Once: the tables of luminance and of grays. */
void soft_luminance_init(struct draw *draw);

/*
 * Tests depth LESS, and writes it, until one fails; how many passed. z is 16.16.
 */
int soft_luminance_test_depth(
	uint16_t *depth, int count, uint32_t z, uint32_t z_right);

/* Writes depth without a test. */
void soft_luminance_write_depth(
	uint16_t *depth, int count, uint32_t z, uint32_t z_right);

#endif
