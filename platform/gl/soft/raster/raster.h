/*
 * Set-up of triangles: edges, planes, level of detail; the fill functions.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_RASTER_H
#define PLATFORM_GL_SOFT_RASTER_RASTER_H

#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

enum {
	/*
	 * 1/512 of a texel, added to coordinates: more than gradients lose to
	 * rounding, so pixel centres on a texel's border always get that texel.
	 */
	TEXEL_NUDGE = 128,
};

/*
 * A triangle that is seen: its vertices, sorted by y and, where y is equal, by
 * x, and the pixels that it may cover. arm/list.S fills this, too.
 */
struct setup {
	const struct vertex *v[3];
	struct vertex *provoking; /* whose colour GL_FLAT uses */
	int top, middle, bottom;  /* first row at or below v[0], v[1], v[2] */
	int columns;              /* number of columns that it may cover */
	int32_t extent; /* the larger of width and height, in 1/16 pixels */
	/* not wide, and in draw->box, with a column at both sides */
	bool inside;
	bool wide; /* extent > SMALL_EXTENT */
	bool back;
	_Alignas(8) uint64_t area; /* twice the area, in 1/256 of pixels */
	bool middle_left;          /* as in struct frame */
};

/* An edge of the triangle, in 16.16 pixels: x in a row, and its step a row. */
struct side {
	int32_t x, step;
};

static inline int32_t raster_least(int32_t a, int32_t b, int32_t c)
{
	int32_t ab = a < b ? a : b;

	return ab < c ? ab : c;
}

static inline int32_t raster_most(int32_t a, int32_t b, int32_t c)
{
	int32_t ab = a > b ? a : b;

	return ab > c ? ab : c;
}

/* The first column (row) whose centre is at or right of (below) a coordinate. */
static inline int raster_centre(int32_t sixteenths)
{
	return (sixteenths + 7) >> 4;
}

/* Twice the signed area, in 1/256 of pixels; rarely needs more than 32 bits. */
static inline int64_t raster_find_area(
	const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
	return (int64_t)(b->x - a->x) * (c->y - a->y) -
		(int64_t)(c->x - a->x) * (b->y - a->y);
}

/* The part of a box that lies in draw->box. */
static inline struct clip_box raster_clip(
	const struct draw *draw, struct clip_box box)
{
	const struct clip_box *by = &draw->box;

	return (struct clip_box){box.left > by->left ? box.left : by->left,
		box.top > by->top ? box.top : by->top,
		box.right < by->right ? box.right : by->right,
		box.bottom < by->bottom ? box.bottom : by->bottom};
}

/* A value at v[0], and its differences to there at v[1] and v[2]. */
struct delta {
	int32_t first, d1, d2;
};

/* A triangle's largest w minus its least one, and the least one. */
struct perspective {
	uint32_t w_spread, w_least;
};

static ALWAYS_INLINE struct perspective raster_find_perspective(
	const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const int32_t a = v[0]->clip[3], b = v[1]->clip[3], c = v[2]->clip[3];
	const int32_t least = raster_least(a, b, c);

	return (struct perspective){
		(uint32_t)(raster_most(a, b, c) - least), (uint32_t)least};
}

/*
 * Whether a value that differs by most within the triangle needs perspective
 * correction. Linear interpolation is off by up to most (wmax - wmin) / 4 wmin;
 * allowed are 2^(6 + tolerance): 0 is a quarter of a texel, of 256 units.
 */
static ALWAYS_INLINE bool raster_bends(
	const struct perspective *perspective, uint32_t most, int tolerance)
{
	return (uint64_t)most * perspective->w_spread >
		(uint64_t)perspective->w_least << (8 + tolerance);
}

/*
 * bend.c: of a small triangle whose largest w is at most twice its least one,
 * interpolates texture coordinates by polynomials instead of a division. False
 * where they would be off by more than a quarter of a texel. delta is indexed
 * by attribute; texel is the largest difference of one, in 1/256 of texels.
 */
bool soft_bend(struct draw *draw, const struct setup *setup,
	const struct delta delta[], uint32_t texel);

/* set_up.c: whether w moves colours or fog by rows_color_tolerance(). */
bool soft_colors_bend(const struct draw *draw, const struct setup *setup);

/*
 * set_up.c: the polygon offset for a depth plane's dx and dy, in the plane's
 * format: GL ES 1.1 section 3.5.5, limited so that no depth wraps around.
 */
int32_t soft_find_offset(const struct draw *draw, const struct setup *setup,
	int32_t dx, int32_t dy);

/* set_up.c: fills draw->raster: planes and what is constant. */
void soft_raster_set_up(struct draw *draw, struct setup *setup);

/*
 * The edge from a down to b at the row's centre. It depends on the edge alone,
 * so that triangles on both sides of it cover all pixels, and none twice.
 */
static ALWAYS_INLINE struct side raster_side(const struct draw *draw,
	const struct vertex *a, const struct vertex *b, int row)
{
	int32_t dx = b->x - a->x, dy = b->y - a->y;
	int first = raster_centre(a->y);
	uint32_t x = (uint32_t)a->x << 12;
	int32_t step; /* dx / dy */

	if (dy <= 0) {
		return (struct side){(int32_t)x, 0};
	}
	step = (uint32_t)dx + SMALL_EXTENT > 2 * SMALL_EXTENT ||
			dy > SMALL_EXTENT
		? soft_slope_q16(dx, dy)
		: mul_high(dx * (1 << 17), draw->inverse_q31[dy]);
	/* from a to the first row's centre, less than a pixel; then by rows */
	x += (uint32_t)(step >> 4) * (uint32_t)(first * 16 + 8 - a->y);
	x += (uint32_t)step * (uint32_t)(row - first);
	return (struct side){(int32_t)x, step};
}

/* GL_FLAT, and there are colours or other attributes. */
static inline bool raster_is_flat(const struct draw *draw)
{
	return draw->soft->fragment.flat && draw->attributes;
}

static inline uint32_t raster_size(int32_t value)
{
	return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

/* The first of the triangle's rows inside draw->box. */
static inline int raster_first_row(
	const struct draw *draw, const struct setup *setup)
{
	return setup->top < draw->box.top ? draw->box.top : setup->top;
}

static ALWAYS_INLINE bool raster_is_in_box(
	const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const struct clip_box *box = &draw->box;
	int left;

	if (setup->inside) {
		return true;
	}
	left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	return left >= box->left && left + setup->columns <= box->right &&
		setup->top >= box->top && setup->bottom <= box->bottom;
}

/* log2 of a 16.16 number, with 8 bits of fraction, linear between powers of 2. */
static inline int raster_log2_q8(uint32_t value_q16)
{
	int zeros = LEADING_ZEROS_32(value_q16 | 1);

	return ((15 - zeros) * 256) + (int)(value_q16 << zeros >> 23 & 255);
}

/* A vector's length, within 7%, from the magnitudes of its components. */
static inline uint32_t raster_length(uint32_t a, uint32_t b)
{
	return a > b ? a + (b >> 2) + (b >> 3) : b + (a >> 2) + (a >> 3);
}

/* The level of detail of the larger step in the texture, a pixel right or down. */
static ALWAYS_INLINE int raster_find_lod(
	int32_t s_right, int32_t t_right, int32_t s_down, int32_t t_down)
{
	uint32_t right =
		raster_length(raster_size(s_right), raster_size(t_right));
	uint32_t down = raster_length(raster_size(s_down), raster_size(t_down));

	return raster_log2_q8(right > down ? right : down);
}

/*
 * hidden.c: whether a small triangle lies behind all depths of its bounding
 * box, so that no depth or pixel changes. May return false where it does.
 */
bool soft_is_hidden(const struct draw *draw, const struct setup *setup);

/*
 * hidden.c: the same of any triangle, by each of its own pixels. One that is
 * not setup->inside has been set up, by soft_raster_set_up().
 */
bool soft_is_wholly_hidden(const struct draw *draw, const struct setup *setup);

/* span/walk.c: draws a triangle in any state. */
void soft_rows_fill(struct draw *draw, struct setup *setup);
/* fast/luminance.c, fast/fill_texture.c: see there; paths.c chooses them. */
void soft_fill_luminance(struct draw *draw, struct setup *setup);
void soft_fill_textured(struct draw *draw, struct setup *setup);

/*
 * fill_small.c: draws a small triangle without a texture in any state; false,
 * with nothing drawn, if it cannot.
 */
bool soft_fill_small(struct draw *draw, struct setup *setup);

/* fill_narrow.c: leaves triangles that it cannot draw to soft_rows_fill(). */
void soft_fill_narrow(struct draw *draw, struct setup *setup);
/* The same with polygon offset. */
void soft_fill_narrow_offset(struct draw *draw, struct setup *setup);

/* fill_flat.c: begin prepares draw->flat, once a draw call. */
void soft_fill_flat(struct draw *draw, struct setup *setup);

/*
 * fill_glyph.c: draws the triangles v[0] v[1] v[2] and v[2] v[1] v[3]. False,
 * with nothing drawn, if they are no upright rectangle that it can draw.
 */
bool soft_fill_rectangle(struct draw *draw, struct vertex *const v[4]);

#endif
