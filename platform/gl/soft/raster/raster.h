/*
 * Setting triangles up and walking their rows.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_RASTER_H
#define PLATFORM_GL_SOFT_RASTER_RASTER_H

#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

enum {
	/*
	 * 1/512 of a texel: what gradients lose to rounding, so that centres
	 * on the border of two texels fall to the same one always.
	 */
	TEXEL_NUDGE = 128,
	/*
	 * Four steps of 255, as rows_color_tolerance() has it, where the
	 * picture has five bits.
	 */
	RASTER_TOLERANCE_565 = 4,
};

/*
 * A triangle on its way to the rows: its vertices by y, those of one row by x,
 * and its rows. arm/list.S fills it, too.
 */
struct setup {
	const struct vertex *v[3];
	struct vertex *provoking; /* whose colour is flat */
	int top, middle, bottom;
	int columns;    /* how many can be covered */
	int32_t extent; /* how wide or high it is, in sixteenths */
	/* not wide, and in draw->box with a pixel to spare at the sides */
	bool inside;
	bool wide; /* extent > SMALL_EXTENT */
	bool back;
	_Alignas(8) uint64_t area; /* twice of it, in 1/256 of pixels */
	bool middle_left;          /* of struct frame */
};

/* One side of the triangle, in 16.16 pixels. */
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

/* The first pixel whose centre is at or beyond this. */
static inline int raster_centre(int32_t sixteenths)
{
	return (sixteenths + 7) >> 4;
}

/* A value at the first corner, and how much more it is at the others. */
struct delta {
	int32_t first, d1, d2;
};

/* How far a triangle is in perspective. */
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
 * Whether running linearly is off by more than what nobody sees, see
 * rows_color_tolerance(), or a quarter of a texel: by up to
 * spread (wmax - wmin) / 4 wmin.
 */
static ALWAYS_INLINE bool raster_bends(
	const struct perspective *perspective, uint32_t most, int tolerance)
{
	return (uint64_t)most * perspective->w_spread >
		(uint64_t)perspective->w_least << (8 + tolerance);
}

/*
 * bend.c: of a small triangle whose w is at most twice as large in one corner
 * as in another, bends texture coordinates instead of dividing them. False
 * where that is off by more than a quarter of a texel. delta are those of
 * attributes, texel is the largest spread in 1/256 of texels.
 */
bool soft_bend(struct draw *draw, const struct setup *setup,
	const struct delta delta[], uint32_t texel);

/* Those that have planes where these move: red, green and blue all together. */
static ALWAYS_INLINE uint32_t raster_color_planes(uint32_t moving)
{
	return moving ? moving | 7u << RED : 0;
}

/* set_up.c: fills draw->raster. */
void soft_raster_set_up(struct draw *draw, struct setup *setup);

/* dx / dy in 16.16, of sixteenths; dy > 0. */
static ALWAYS_INLINE int32_t raster_slope(
	const struct draw *draw, int32_t dx, int32_t dy)
{
	if ((uint32_t)dx + SMALL_EXTENT > 2 * SMALL_EXTENT || dy > SMALL_EXTENT) {
		return soft_slope_q16(dx, dy);
	}
	return mul_high(dx * (1 << 17), draw->inverse_q31[dy]);
}

/*
 * The edge from a down to b, at the centre of the row, by nothing but the edge
 * itself: the triangles on both sides see the same.
 */
static ALWAYS_INLINE struct side raster_side(const struct draw *draw,
	const struct vertex *a, const struct vertex *b, int row)
{
	int32_t dy = b->y - a->y;
	int first = raster_centre(a->y);
	uint32_t x = (uint32_t)a->x << 12;
	int32_t step;

	if (dy <= 0) {
		return (struct side){(int32_t)x, 0};
	}
	step = raster_slope(draw, b->x - a->x, dy);
	/* To the first row's centre, less than a pixel down; then by rows. */
	x += (uint32_t)(step >> 4) * (uint32_t)(first * 16 + 8 - a->y);
	x += (uint32_t)step * (uint32_t)(row - first);
	return (struct side){(int32_t)x, step};
}

static inline uint32_t raster_size(int32_t value)
{
	return value < 0 ? 0u - (uint32_t)value : (uint32_t)value;
}

/* The first row that the box shows. */
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

static ALWAYS_INLINE void raster_set_edge(const struct draw *draw,
	struct band_edges *edges, int which, const struct vertex *from,
	const struct vertex *to, int row)
{
	struct side side = raster_side(draw, from, to, row);

	edges->at[which] = (uint32_t)side.x + 0x7FFF;
	edges->step[which] = (uint32_t)side.step;
}

/*
 * Draws a band from raster_first_row() to the middle corner and another from
 * there on, as far as the box shows them.
 */
static ALWAYS_INLINE void raster_draw_bands(const struct draw *draw,
	const struct setup *setup, bool middle_left, struct band_edges *edges,
	void (*function)(void *band), void *band)
{
	const struct vertex *const *v = setup->v;
	int top = raster_first_row(draw, setup);
	int bottom = setup->bottom < draw->box.bottom ? setup->bottom
						      : draw->box.bottom;
	int turn = setup->middle < top   ? top
		: setup->middle > bottom ? bottom
					 : setup->middle;
	int part = middle_left ? BAND_LEFT : BAND_RIGHT;

	raster_set_edge(draw, edges, !part, v[0], v[2], top);
	if (turn > top) {
		raster_set_edge(draw, edges, part, v[0], v[1], top);
		edges->rows = turn - top;
		function(band);
	}
	if (bottom > turn) {
		raster_set_edge(draw, edges, part, v[1],
			draw->fourth ? draw->fourth : v[2], turn);
		edges->rows = bottom - turn;
		function(band);
	}
}

/* log2 of 16.16 with 8 bits of fraction; the mantissa stands for its log. */
static inline int raster_log2_q8(uint32_t value_q16)
{
	int zeros = LEADING_ZEROS_32(value_q16 | 1);

	return ((15 - zeros) * 256) + (int)(value_q16 << zeros >> 23 & 255);
}

/* How long a vector is, from the sizes of both parts: within 7 %. */
static inline uint32_t raster_length(uint32_t a, uint32_t b)
{
	return a > b ? a + (b >> 2) + (b >> 3) : b + (a >> 2) + (a >> 3);
}

/* The level of detail of the longer of two ways: a pixel across, or down. */
static ALWAYS_INLINE int raster_find_lod(
	int32_t s_right, int32_t t_right, int32_t s_down, int32_t t_down)
{
	uint32_t right =
		raster_length(raster_size(s_right), raster_size(t_right));
	uint32_t down = raster_length(raster_size(s_down), raster_size(t_down));

	return raster_log2_q8(right > down ? right : down);
}

/* A plane's value at column x of the row under way. */
static inline uint32_t plane_at(const struct raster *raster, int plane, int x)
{
	const struct plane *p = &raster->plane[plane];

	return p->start + (uint32_t)p->dx * (uint32_t)x;
}

/*
 * hidden.c: whether a small triangle lies behind all of the depths around it,
 * so that no depth or pixel changes.
 */
bool soft_is_hidden(const struct draw *draw, const struct setup *setup);

/* span/walk.c: any state. */
void soft_rows_fill(struct draw *draw, struct setup *setup);
/* The paths of fast/, each in a file of its name; fast/paths.c chooses. */
void soft_fill_luminance(struct draw *draw, struct setup *setup);
void soft_fill_textured(struct draw *draw, struct setup *setup);

/* fill_texture.c: its begin is called once a draw call. */
void soft_fill_textured_begin(struct draw *draw);

/* fill_narrow.c: what it does not take is soft_rows_fill()'s. */
void soft_fill_narrow(struct draw *draw, struct setup *setup);
/* Whether colours run linearly, to a step of 255. */
bool soft_fill_is_linear(const struct draw *draw, const struct setup *setup);

/* fill_flat.c: see there; begin is called once a draw call. */
void soft_fill_flat_begin(struct draw *draw);
void soft_fill_flat(struct draw *draw, struct setup *setup);

/*
 * fill_glyph.c: two triangles, v[0] v[1] v[2] and
 * v[2] v[1] v[3]. False, with nothing drawn, where they are no upright
 * rectangle that it can draw as one.
 */
bool soft_fill_rectangle(struct draw *draw, struct vertex *const v[4]);

#endif
