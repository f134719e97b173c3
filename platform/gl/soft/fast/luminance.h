/*
 * Rows of large triangles with a luminance texture in one colour, opaque or
 * blended by alpha, into RGB565.
 *
 * The four texels around a centre lie in one word (struct level, quads), so a
 * bilinear texel is one load, and equal texels are seen at once. A table has
 * the colours that the 256 shades become.
 */
#ifndef PLATFORM_GL_SOFT_FAST_LUMINANCE_H
#define PLATFORM_GL_SOFT_FAST_LUMINANCE_H

#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"

/* For gray.c: */

/* How many pixels may run linearly from there. */
int soft_luminance_find_length(
	const struct draw *draw, const struct point *from);

/*
 * Mixes what is shaded aside into the picture, by alpha of 8.16; words lie in
 * one as they do in the other.
 */
void soft_luminance_blend(uint16_t *pixel, const uint16_t *shaded, int all,
	uint32_t alpha, int32_t alpha_right);

/* A step of so many that lead over all of it. */
int32_t soft_luminance_share_out(
	const struct draw *draw, int32_t all, int steps);

#endif
