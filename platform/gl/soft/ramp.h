/*
 * How attributes run across small triangles: what raster.c does for all, in 32
 * bits and without a step in memory.
 */
#ifndef PLATFORM_GL_SOFT_RAMP_H
#define PLATFORM_GL_SOFT_RAMP_H

#include "platform/gl/soft/raster.h"

/* An attribute across a small triangle. */
struct ramp {
	uint32_t at; /* at column 0 of the row under way */
	int32_t dx, dy;
};

/* What all gradients of a triangle share; see raster_find_area(). */
struct scale {
	const struct setup *setup;
	int32_t inverse;
	int shift;
	int32_t off_x, off_y; /* to the centre of column 0 of the first row */
	int column;
};

static ALWAYS_INLINE struct scale find_scale(const struct setup *setup)
{
	const struct vertex *v = setup->v[0];
	int shift = setup->area_zeros - 50;
	int column = v->x >> 4;

	return (struct scale){
		.setup = setup,
		.inverse = shift < 0 ? setup->inverse_area >> -shift
				     : setup->inverse_area,
		.shift = shift < 0 ? 0 : shift,
		.off_x = column * 16 + 8 - v->x,
		.off_y = setup->top * 16 + 8 - v->y,
		.column = column,
	};
}

/* Deltas below SMALL_DELTA: products fit 32 bits. */
static ALWAYS_INLINE struct ramp find_ramp(
	const struct scale *scale, int32_t first, int32_t d1, int32_t d2)
{
	const struct setup *setup = scale->setup;
	int32_t across = d1 * setup->y2 - d2 * setup->y1;
	int32_t down = d2 * setup->x1 - d1 * setup->x2;
	uint32_t dx = (uint32_t)mul_high(across, scale->inverse) << scale->shift;
	uint32_t dy = (uint32_t)mul_high(down, scale->inverse) << scale->shift;
	uint32_t at = ((uint32_t)first << 8) +
		(uint32_t)((int32_t)dx >> 4) * (uint32_t)scale->off_x +
		(uint32_t)((int32_t)dy >> 4) * (uint32_t)scale->off_y;

	return (struct ramp){
		at - dx * (uint32_t)scale->column, (int32_t)dx, (int32_t)dy};
}

static ALWAYS_INLINE uint32_t ramp_at(const struct ramp *ramp, int x)
{
	return ramp->at + (uint32_t)ramp->dx * (uint32_t)x;
}

static ALWAYS_INLINE void ramp_down(struct ramp *ramp, int rows)
{
	ramp->at += (uint32_t)ramp->dy * (uint32_t)rows;
}

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

/* False when the triangle has to go the general way. */
static ALWAYS_INLINE bool find_color_ramp(const struct scale *scale, int name,
	int32_t limit, int32_t round, struct ramp *out)
{
	const struct setup *setup = scale->setup;
	int32_t first = setup->v[0]->attribute[name];
	int32_t d1 = setup->v[1]->attribute[name] - first;
	int32_t d2 = setup->v[2]->attribute[name] - first;

	*out = find_ramp(scale, first + round, d1, d2);
	return is_color_within(d1, d2, limit);
}

/* As gather() in raster.c, of a texture that repeats. */
static ALWAYS_INLINE bool find_texel_ramp(const struct scale *scale, int name,
	int log2, int32_t limit, struct ramp *out)
{
	const struct setup *setup = scale->setup;
	uint32_t first = (uint32_t)setup->v[0]->attribute[name];
	uint32_t base = first & ~0xFFFFu;
	int32_t a = shift_by((int32_t)(first - base), log2 - 8);
	int32_t d1 = shift_by(
		(int32_t)((uint32_t)setup->v[1]->attribute[name] - first),
		log2 - 8);
	int32_t d2 = shift_by(
		(int32_t)((uint32_t)setup->v[2]->attribute[name] - first),
		log2 - 8);

	if (!is_within(d1, limit) || !is_within(d2, limit)) {
		return false;
	}
	*out = find_ramp(scale, a, d1, d2);
	out->at += TEXEL_NUDGE;
	return true;
}

#endif
