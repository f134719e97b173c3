/* What is true at single columns of the row under way. */
#ifndef PLATFORM_GL_SOFT_ROWS_H
#define PLATFORM_GL_SOFT_ROWS_H

#include "platform/gl/soft/raster.h"

/*
 * The attributes that move, divided by q where the triangle is in perspective;
 * and q itself, with its reciprocal.
 */
struct point {
	int32_t q, inverse;
	int zeros;
	int32_t value[ATTRIBUTES];
};

void rows_find_point(const struct draw *draw, int x, struct point *out);

/* The levels of detail there, into span->lod; linear ones have no point. */
void rows_find_lod(
	const struct draw *draw, const struct point *point, struct span *span);

#endif
