/* What is true at single columns of the row under way. */
#ifndef PLATFORM_GL_SOFT_RASTER_ROWS_H
#define PLATFORM_GL_SOFT_RASTER_ROWS_H

#include "platform/gl/soft/raster/raster.h"

/*
 * The attributes that move, divided by q where the triangle is in perspective;
 * and q itself, with its reciprocal.
 */
struct point {
	int32_t q, inverse;
	int zeros;
	int32_t value[ATTRIBUTES];
};

/* Whether an attribute's plane is of its product with 1 / w. */
static ALWAYS_INLINE bool rows_is_divided(const struct raster *raster, int name)
{
	return name >= TEX_S ? raster->perspective : raster->colors_divided;
}

/* A value, and its step to where it leads count pixels from there. */
struct bent {
	int32_t value, step;
};

/*
 * Of a row that counts from the triangle's first one, at whose column 0 the
 * plane is what start says.
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
 * How far a colour may be off where it runs linearly though it should bend: a
 * step of 255, or four of them where the picture has five bits; as the
 * logarithm of that and 4, which is what 16.16 is compared with.
 */
static ALWAYS_INLINE int rows_color_tolerance(const struct draw *draw)
{
	return draw->soft->format == PIXELS_RGB565 ? RASTER_TOLERANCE_565 : 2;
}

/*
 * In perspective the first row of a triangle that is drawn chooses its level of
 * detail, and then each whose number in the picture is a multiple of this, so
 * that triangles side by side change it together.
 */
enum {
	ROWS_OF_LEVEL = 4,
};

/* A quarter of 1/255 to spare at either end for what steps lose. */
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

/* numerator / q times 2^up. */
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

/* A step between two values, where inverse is 2^31 over the number of steps. */
static ALWAYS_INLINE int32_t rows_find_step(
	int32_t from, int32_t to, int32_t inverse)
{
	return mul_high((int32_t)((uint32_t)to - (uint32_t)from), inverse) * 2;
}

/*
 * How many pixels apart exact divisions are, of a row of so many steps: the error
 * is that of none between its ends, and twice what is allowed is half a texel.
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
 * The most pixels of a run whose coordinates change so much a pixel: its texels
 * have to fit SOFT_RUN_TEXELS, as those of levels do.
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

/* The levels of detail of a triangle that is linear all over. */
void soft_rows_find_affine_lod(const struct draw *draw, struct span *span);

/*
 * In perspective: the second texture's coordinates along the span's pixels, and
 * its level of detail, of a row so many below the one that planes are at.
 */
void soft_rows_find_second(const struct draw *draw, int row, struct span *span);

/* The most that one of them changes between two columns. */
uint32_t soft_rows_find_second_change(
	const struct draw *draw, int row, int left, int right);

/* Whether a filter mixes the texels of a level. */
bool soft_rows_is_linear(GLenum filter);

/* Whether levels, or the minifying filter, make a used texture look different. */
bool soft_rows_want_lod(const struct texture_input *input);

/* Whether a level of detail, as struct span has it, asks for that filter. */
bool soft_rows_is_small(const struct texture_input *input, int lod);

/* The levels of detail there, into span->lod; linear ones have no point. */
void soft_rows_find_lod(
	const struct draw *draw, const struct point *point, struct span *span);

#endif
