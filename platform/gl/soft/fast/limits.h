/* How far attributes of a small triangle run linearly in perspective. */
#ifndef PLATFORM_GL_SOFT_FAST_LIMITS_H
#define PLATFORM_GL_SOFT_FAST_LIMITS_H

#include "platform/gl/soft/raster/raster.h"

/* How much attributes may differ before perspective would show. */
struct limits {
	int32_t color, texel;
};

/* Texels are no smaller than pixels then, and their spread no larger. */
static ALWAYS_INLINE bool is_mipmapped(const struct draw *draw)
{
	return draw->texture[0].used && draw->texture[0].levels > 1;
}

/*
 * Running linearly is off by up to spread (wmax - wmin) / 4 wmin, see
 * raster.c; deltas are at least half of the spread.
 */
static ALWAYS_INLINE struct limits find_limits(
	const struct draw *draw, const struct setup *setup)
{
	int32_t a = setup->v[0]->clip[3], b = setup->v[1]->clip[3];
	int32_t c = setup->v[2]->clip[3];
	int32_t low = a < b ? a : b, high = a < b ? b : a;
	bool mipmapped;
	int near; /* w differs by less than 1 / 2^near of it */

	if (!draw->perspective) {
		return (struct limits){SMALL_DELTA, SMALL_DELTA};
	}
	low = c < low ? c : low;
	high = c > high ? c : high;
	if (high - low <= low >> 6) {
		return (struct limits){
			1 << 16, is_mipmapped(draw) ? SMALL_DELTA : (1 << 13)};
	}
	near = LEADING_ZEROS_32((uint32_t)(high - low)) -
		LEADING_ZEROS_32((uint32_t)low);
	near -= near > 0 && high - low > low >> near;
	if (near <= 0) {
		return (struct limits){0, 0};
	}
	mipmapped = near >= 4 && setup->extent <= 256 && is_mipmapped(draw);
	return (struct limits){
		512 << near, mipmapped ? SMALL_DELTA : 128 << near};
}

static ALWAYS_INLINE bool is_within(int32_t delta, int32_t limit)
{
	return (uint32_t)(delta + limit) <= 2 * (uint32_t)limit;
}

/* From 0 to the two. */
static ALWAYS_INLINE int32_t find_spread(int32_t d1, int32_t d2)
{
	int32_t low = d1 < d2 ? d1 : d2, high = d1 < d2 ? d2 : d1;

	return (high > 0 ? high : 0) - (low < 0 ? low : 0);
}

/* Colours differ by less than 2^16 anyway. */
static ALWAYS_INLINE bool is_color_within(int32_t d1, int32_t d2, int32_t limit)
{
	return limit >= 1 << 16 || find_spread(d1, d2) <= 2 * limit;
}

#endif
