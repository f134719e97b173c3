/*
 * Lines that are one pixel wide, without a texture: a pixel for each column, or
 * for each row of steep lines, as GL ES 1.1 section 3.4.1 has it. The span
 * functions draw them; in other states line.c makes two triangles of each.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_THIN_LINE_H
#define PLATFORM_GL_SOFT_RASTER_THIN_LINE_H

#include <stdbool.h>

#include "platform/gl/gl.h"

struct draw;
struct vertex;

/* Whether they are, in a draw call whose spans are prepared. */
bool soft_lines_are_thin(const struct draw *draw, GLenum mode);

/* A thin line between two shaded vertices at different places. */
void soft_draw_thin_line(
	struct draw *draw, const struct vertex *a, const struct vertex *b);

#endif
