/*
 * Rows of large triangles with a luminance texture in one colour, opaque or
 * blended by alpha, into RGB565: what floors are. rows.c hands them on.
 *
 * The four texels around a centre lie in one word (struct level, quads), so a
 * bilinear texel is one load, and equal texels are seen at once. A table has
 * the colours that the 256 shades become.
 */
#ifndef PLATFORM_GL_SOFT_FAST_LUMINANCE_H
#define PLATFORM_GL_SOFT_FAST_LUMINANCE_H

#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/raster/rows.h"

/* Whether the state of a draw call is this. */
bool soft_luminance_takes(const struct draw *draw);

/* After soft_raster_set_up(): whether the triangle has one colour, which is taken. */
bool soft_luminance_begin(struct draw *draw);

/* As raster_walk() calls it. */
void soft_luminance_row(struct draw *draw, int y, int left, int right);

/* To the next row: what those take. */
static inline void luminance_next(struct draw *draw)
{
	static const int taken[] = {ALPHA, TEX_S, TEX_S + 1, DEPTH, INVERSE_W};
	struct plane *plane = draw->raster.plane;

	/* Some have no plane, but nobody asks for it then. */
	for (int i = 0; i < 5; i++) {
		plane[taken[i]].start += (uint32_t)plane[taken[i]].dy;
	}
}

/* For ground.c: */

/* Whether it is, but for the depth test. */
bool soft_luminance_takes_texture(const struct draw *draw);

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
