/*
 * Rows of triangles with a luminance texture in shades of gray that vary, depth
 * LESS, opaque or blended by alpha, into RGB565: what uneven ground is. As
 * luminance.h, whose rows have one colour and need no test.
 */
#ifndef PLATFORM_GL_SOFT_FAST_GROUND_H
#define PLATFORM_GL_SOFT_FAST_GROUND_H

#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/shade.h"

/* Once: the table of grays. */
void soft_ground_init(struct draw *draw);

/* Whether the state of a draw call is this. */
bool soft_ground_takes(const struct draw *draw);

/* After soft_raster_set_up(): whether the triangle is gray, which is taken. */
bool soft_ground_begin(struct draw *draw);

/* As raster_walk() calls it. */
void soft_ground_row(struct draw *draw, int y, int left, int right);

/* To the next row: what those take. */
static inline void ground_next(struct draw *draw)
{
	static const int taken[] = {
		RED, ALPHA, TEX_S, TEX_S + 1, DEPTH, INVERSE_W};
	struct plane *plane = draw->raster.plane;

	/* Some have no plane, but nobody asks for it then. */
	for (int i = 0; i < 6; i++) {
		plane[taken[i]].start += (uint32_t)plane[taken[i]].dy;
	}
}

/*
 * Draws a run whose shade varies, in blocks of four pixels where texels are
 * wide enough for that, else one by one.
 */
void soft_ground_shade(const struct shade_run *run);

/*
 * Tests depth LESS, and writes it, until one fails; how many passed. z has 10
 * bits of fraction.
 */
int soft_ground_depth(uint16_t *depth, int count, uint32_t z, uint32_t z_right);

#endif
