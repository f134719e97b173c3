/*
 * Rows of large triangles with a luminance texture in one colour, opaque or
 * blended by alpha, into RGB565: what floors are. rows.c hands them on.
 *
 * The four texels around a centre lie in one word (struct level, quads), so a
 * bilinear texel is one load, and equal texels are seen at once. A table has
 * the colours that the 256 shades become.
 */
#ifndef PLATFORM_GL_SOFT_LUMINANCE_H
#define PLATFORM_GL_SOFT_LUMINANCE_H

#include "platform/gl/soft/raster.h"

/* Pixels of a row; texels of one level. */
struct shade_run {
	uint16_t *pixel;
	uint16_t *depth; /* NULL: none is written */
	int count;
	const uint32_t *quads;
	int width_log2, height_log2; /* both more than 0 */
	/*
	 * Of the first centre's upper left texel: 2^32 are all of the texture,
	 * so that it repeats by itself.
	 */
	uint32_t s, t;
	int32_t s_right, t_right;
	uint32_t z;
	int32_t z_right;
	uint32_t alpha; /* 8.16 and the half of 1/32 */
	int32_t alpha_right;
	const uint32_t *shade; /* 256 wide colours */
};

/* Whether the state of a draw call is this. */
bool luminance_takes(const struct draw *draw);

/* After raster_set_up(): whether the triangle has one colour, which is taken. */
bool luminance_begin(struct draw *draw);

/* As raster_walk() calls it. */
void luminance_row(struct draw *draw, int y, int left, int right);

#endif
