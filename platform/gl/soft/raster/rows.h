/* Values at single columns of a row: perspective division, level of detail. */
#ifndef PLATFORM_GL_SOFT_RASTER_ROWS_H
#define PLATFORM_GL_SOFT_RASTER_ROWS_H

#include "platform/gl/soft/raster/raster.h"

/*
 * A column of a row: q, which is the plane of 1 / w, with its reciprocal, by
 * which attributes are divided.
 */
struct point {
	int32_t q, inverse; /* inverse is 2^62 / (q << zeros) */
	int zeros;
};

/* Whether an attribute's plane interpolates its product with 1 / w. */
static ALWAYS_INLINE bool rows_is_divided(const struct raster *raster, int name)
{
	return name >= TEX_S ? raster->perspective : raster->colors_divided;
}

/* A polynomial's value, and a linear step to its value count pixels further. */
struct bent {
	int32_t value, step;
};

/*
 * At column x of a row, counted from the triangle's first one. start is the
 * plane's value at the row's column 0.
 */
static ALWAYS_INLINE struct bent rows_find_bent(const struct raster *raster,
	int name, uint32_t start, int row, int x, int count)
{
	const struct bend *bend = &raster->bend[name];
	const uint32_t y = (uint32_t)row, xx = (uint32_t)bend->xx;
	uint32_t slope = (uint32_t)raster->plane[name].dx +
		(uint32_t)bend->xy * y + xx * (uint32_t)x;

	start += (uint32_t)bend->yy * y * y;
	return (struct bent){(int32_t)(start + slope * (uint32_t)x),
		(int32_t)(slope + xx * (uint32_t)(x + count))};
}

/*
 * The tolerance of raster_bends() for colours: how far a colour may be off if
 * it is interpolated linearly. That is a step of 255, or four steps in RGB565,
 * as log2(4 steps).
 */
static ALWAYS_INLINE int rows_color_tolerance(const struct draw *draw)
{
	return draw->soft->format == PIXELS_RGB565 ? 4 : 2;
}

/*
 * Whether colours are linear in a triangle; known at once if w differs by at
 * most 1/32, or 1/128. tolerance is rows_color_tolerance().
 */
static ALWAYS_INLINE bool rows_are_linear(
	const struct draw *draw, const struct setup *setup, int tolerance)
{
	int32_t w = setup->v[0]->clip[3];
	int32_t d1 = setup->v[1]->clip[3] - w, d2 = setup->v[2]->clip[3] - w;

	d1 = d1 < 0 ? -d1 : d1;
	d2 = d2 < 0 ? -d2 : d2;
	return !draw->perspective || d1 + d2 <= w >> (9 - tolerance) ||
		!soft_colors_bend(draw, setup);
}

/*
 * Where texture coordinates are divided, a triangle's first visible row finds
 * its level of detail, and then each row of the picture that is a multiple of
 * this, so that neighbouring triangles change levels in the same rows.
 */
enum {
	ROWS_OF_LEVEL = 4,
};

/* Limits of colours, 8.16: 1/4 at either end for the rounding of steps. */
enum {
	ROWS_LEAST_COLOR = 0x4000,
	ROWS_MOST_COLOR = 0xFFBFFF,
};

static ALWAYS_INLINE void rows_find_divisor(int32_t q, struct point *out)
{
	out->q = q > 0 ? q : 1;
	out->zeros = LEADING_ZEROS_32((uint32_t)out->q);
	out->inverse = reciprocal((uint32_t)out->q << out->zeros);
}

/* numerator / q * 2^up. */
static ALWAYS_INLINE int32_t rows_divide(
	const struct point *point, int32_t numerator, int up)
{
	int down = 30 - point->zeros - up; /* of the product's upper half */
	int64_t product;

	if (down >= 0) {
		return mul_high(numerator, point->inverse) >> down;
	}
	product = (int64_t)numerator * point->inverse;
	return (int32_t)((uint64_t)product << (-down > 31 ? 31 : -down) >> 32);
}

/* The step from one value to another; inverse is 2^31 / number of steps. */
static ALWAYS_INLINE int32_t rows_find_step(
	int32_t from, int32_t to, int32_t inverse)
{
	return mul_high((int32_t)((uint32_t)to - (uint32_t)from), inverse) * 2;
}

/*
 * How many pixels apart a row's exact divisions are: 16 to 64. error is that of a
 * row of so many steps divided at its ends alone; half a texel is allowed * 2.
 */
static ALWAYS_INLINE int rows_find_spacing(
	uint64_t error, uint64_t allowed, int steps)
{
	int spacing = 64;

	error >>= 12;
	allowed = (allowed >> 11) * (uint32_t)(steps * steps);
	if (error * (24 * 24) > allowed) {
		return PERSPECTIVE_STEP;
	}
	while (error * (uint32_t)(spacing * spacing) > allowed) {
		spacing -= PERSPECTIVE_STEP / 2;
	}
	return spacing;
}

/*
 * The longest run, in pixels, whose texels fit SOFT_RUN_TEXELS, for coordinates
 * that change by these steps a pixel, 16.16. With mipmaps texels always fit.
 */
static ALWAYS_INLINE int rows_find_run_pixels(
	const struct draw *draw, int32_t s_step, int32_t t_step)
{
	const uint32_t most = (SOFT_RUN_TEXELS - 2) * 65536u / SOFT_RUN_PIXELS;

	return draw->texture[0].levels > 1 ||
			((uint32_t)s_step + most <= 2 * most &&
				(uint32_t)t_step + most <= 2 * most)
		? draw->spans.longest
		: SOFT_RUN_PIXELS / 2;
}

/* Finds a triangle's levels of detail, raster.lod, where nothing is divided. */
void soft_rows_find_affine_lod(struct draw *draw);

/* The level of detail at a point of a triangle in perspective. */
int soft_rows_find_lod(const struct raster *raster, const struct point *point,
	int unit, struct texels texels);

/* Whether a filter is bilinear within a level. */
bool soft_rows_is_linear(GLenum filter);

/* Whether a used texture has mipmaps, or a minifying filter of its own. */
bool soft_rows_want_lod(const struct texture_input *input);

/* Whether a texture's minifying filter mixes two levels. */
bool soft_rows_mixes_levels(const struct texture_input *input);

/* Whether the minifying filter applies at a level of detail, 8 fraction bits. */
bool soft_rows_is_small(const struct texture_input *input, int lod);

#endif
