/*
 * Rows of triangles with a luminance texture in shades of gray that vary, depth
 * LESS, opaque or blended by alpha, into RGB565. As
 * luminance.h, whose rows have one colour and need no test.
 */
#ifndef PLATFORM_GL_SOFT_FAST_GRAY_H
#define PLATFORM_GL_SOFT_FAST_GRAY_H

#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/shade.h"

/* Once: the table of grays. */
void soft_gray_init(struct draw *draw);

/*
 * Draws a run whose shade varies, in blocks of four pixels where texels are
 * wide enough for that, else one by one.
 */
void soft_gray_shade(const struct shade_run *run);

/*
 * Tests depth LESS, and writes it, until one fails; how many passed. z has 10
 * bits of fraction.
 */
int soft_gray_depth(uint16_t *depth, int count, uint32_t z, uint32_t z_right);

#endif
