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

/* numerator / q times 2^up. */
static inline int32_t rows_divide(
	const struct point *point, int64_t numerator, int up)
{
	int64_t product = numerator * point->inverse;
	int down = 62 - point->zeros - up;

	if (down >= 0) {
		return (int32_t)(product >> (down > 63 ? 63 : down));
	}
	return (int32_t)((uint64_t)product << (-down > 63 ? 63 : -down));
}

void rows_find_point(const struct draw *draw, int x, struct point *out);

/* The levels of detail there, into span->lod; linear ones have no point. */
void rows_find_lod(
	const struct draw *draw, const struct point *point, struct span *span);

#endif
