/*
 * Lines that are one pixel wide, without a texture: a pixel for each column, or
 * for each row of steep lines, as GL ES 1.1 section 3.4.1 has it; and points of
 * one pixel. In states that no function here draws, line.c makes two triangles
 * of each.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_THIN_LINE_H
#define PLATFORM_GL_SOFT_RASTER_THIN_LINE_H

#include <stddef.h>

#include "platform/gl/gl.h"
#include "platform/gl/soft/span/run.h"

struct vertex;

/*
 * Pixels of a line under way (Bresenham's algorithm): each step leads one pixel
 * along; whenever error, which grows by add, reaches full, it is less by full
 * and the step leads one pixel across besides.
 */
struct soft_thin_line {
	uint16_t *depth;
	uint8_t *pixel;
	ptrdiff_t depth_along, depth_across; /* depths */
	ptrdiff_t pixel_along, pixel_across; /* bytes */
	uint32_t error, add, full;
	uint32_t compares; /* the low bits of the depth function */
	bool writes_depth;
};

/* Draws the next pixels, at least one; run->row and the steps are set. */
typedef void (*soft_thin_line_function)(
	struct soft_thin_line *line, const struct soft_run *run, int count);

/*
 * The function that draws the lines or points of a draw call whose spans are
 * prepared; NULL for triangles, and for what is made of triangles.
 */
soft_thin_line_function soft_choose_thin_line(
	const struct draw *draw, GLenum mode);

/* A line of draw->thin_line between two shaded vertices at different places. */
void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);
/* A point of draw->thin_line at a shaded vertex. */
void soft_draw_thin_point(struct draw *draw, const struct vertex *v);

#endif
