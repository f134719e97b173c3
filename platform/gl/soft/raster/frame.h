/*
 * Gradients of small triangles, in 32 bits: those of at most SMALL_EXTENT, of
 * values that differ by less than SMALL_DELTA. set_up.c has those of others.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_FRAME_H
#define PLATFORM_GL_SOFT_RASTER_FRAME_H

#include "platform/gl/soft/raster/raster.h"

/*
 * Sets frame: inverse is 2^62 / (area << zeros); or 0 for triangles of less
 * than half a pixel, which get no gradients because these would only be noise.
 */
static ALWAYS_INLINE void frame_begin(const struct setup *setup,
	int32_t inverse, int zeros, bool middle_left, struct frame *frame)
{
	const struct vertex *a = setup->v[0], *b = setup->v[1], *c = setup->v[2];

	inverse = middle_left ? -inverse : inverse;
	frame->x1 = b->x - a->x;
	frame->less_y1 = a->y - b->y;
	frame->less_x2 = a->x - c->x;
	frame->y2 = c->y - a->y;
	frame->inverse_area = inverse;
	frame->inverse = zeros > 18 ? inverse : inverse >> (18 - zeros);
	frame->zeros = zeros;
	frame->shift = zeros > 18 ? zeros - 18 : 0;
	frame->off_x = 8 - (a->x & 15);
	frame->off_y = (8 - a->y) & 15;
	frame->column = a->x >> 4;
	frame->middle_left = middle_left;
}

/* Whether a small triangle's middle vertex lies left of its long edge. */
static ALWAYS_INLINE bool frame_is_middle_left(const struct setup *setup)
{
	const struct vertex *a = setup->v[0], *b = setup->v[1], *c = setup->v[2];

	return (b->x - a->x) * (c->y - a->y) < (c->x - a->x) * (b->y - a->y);
}

/* Finds the frame of a small triangle. */
static ALWAYS_INLINE void frame_find(
	const struct setup *setup, struct frame *out)
{
	uint32_t area = (uint32_t)setup->area;
	int zeros = LEADING_ZEROS_32(area);

	frame_begin(setup, area < 256 ? 0 : reciprocal(area << zeros), zeros,
		frame_is_middle_left(setup), out);
}

/*
 * The plane of a value that is first at v[0] and differs by d1 and d2 at v[1] and
 * v[2]; it has 8 bits of fraction more than the value, and starts in frame.column.
 */
static ALWAYS_INLINE struct plane frame_find_near(
	const struct frame *f, int32_t first, int32_t d1, int32_t d2)
{
	const int32_t right = d1 * f->y2 + d2 * f->less_y1;
	const int32_t down = d2 * f->x1 + d1 * f->less_x2;
	const uint32_t dx = (uint32_t)mul_high(right, f->inverse) << f->shift;
	const uint32_t dy = (uint32_t)mul_high(down, f->inverse) << f->shift;

	return (struct plane){((uint32_t)first << 8) +
			(uint32_t)((int32_t)dx >> 4) * (uint32_t)f->off_x +
			(uint32_t)((int32_t)dy >> 4) * (uint32_t)f->off_y,
		(int32_t)dx, (int32_t)dy};
}

/* The same plane from column 0 on. */
static ALWAYS_INLINE struct plane frame_find_plane(
	const struct frame *f, const struct delta *delta)
{
	struct plane plane =
		frame_find_near(f, delta->first, delta->d1, delta->d2);

	plane.start -= (uint32_t)plane.dx * (uint32_t)f->column;
	return plane;
}

/* Differences of a value at the three corners. */
static ALWAYS_INLINE struct delta frame_find_delta(
	int32_t a, int32_t b, int32_t c)
{
	return (struct delta){a, (int32_t)((uint32_t)b - (uint32_t)a),
		(int32_t)((uint32_t)c - (uint32_t)a)};
}

static ALWAYS_INLINE struct delta frame_find_attribute(
	const struct setup *setup, int name)
{
	const struct vertex *const *v = setup->v;

	return frame_find_delta(v[0]->attribute[name], v[1]->attribute[name],
		v[2]->attribute[name]);
}

/* The largest minus the least of the values 0, d1 and d2. */
static ALWAYS_INLINE uint32_t frame_find_spread(int32_t d1, int32_t d2)
{
	int32_t low = d1 < d2 ? d1 : d2, high = d1 < d2 ? d2 : d1;

	return (uint32_t)((high > 0 ? high : 0) - (low < 0 ? low : 0));
}

/*
 * The edge from a down to b in its first row, as raster_side() finds it, but
 * with 0x7FFF added as struct band_edges has it. inverse_q31 is struct draw's.
 */
static ALWAYS_INLINE struct side frame_find_side(const int32_t *inverse_q31,
	const struct vertex *a, const struct vertex *b)
{
	int32_t dy = b->y - a->y;
	int32_t step = mul_high((b->x - a->x) * (1 << 17), inverse_q31[dy]);

	return (struct side){
		a->x * (1 << 12) + (step >> 4) * ((8 - a->y) & 15) + 0x7FFF,
		step};
}

static ALWAYS_INLINE void frame_set_edge(const struct draw *draw,
	struct band_edges *edges, int which, const struct vertex *from,
	const struct vertex *to, int row, bool inside, const int32_t *inverse)
{
	struct side side = inside ? frame_find_side(inverse, from, to)
				  : raster_side(draw, from, to, row);

	edges->at[which] = (uint32_t)side.x + (inside ? 0 : 0x7FFF);
	edges->step[which] = (uint32_t)side.step;
}

/*
 * Draws the triangle as two bands, above and below its middle vertex, or the
 * parallelogram that draw->fourth completes as three, as far as they lie in
 * draw->box: sets the edges and calls function for each of them. inside: a
 * triangle that is small and lies in draw->box.
 */
static ALWAYS_INLINE void frame_draw_bands(const struct draw *draw,
	const struct setup *setup, bool inside, bool middle_left,
	struct band_edges *edges, void (*function)(void *band), void *band)
{
	const struct vertex *const *v = setup->v;
	const struct vertex *last =
		!inside && draw->fourth ? draw->fourth : v[2];
	const int32_t *inverse = draw->inverse_q31;
	const int part = middle_left ? BAND_LEFT : BAND_RIGHT;
	const int top = inside ? setup->top : raster_first_row(draw, setup);
	const int bottom = inside || setup->bottom < draw->box.bottom
		? setup->bottom
		: draw->box.bottom;
	const int turn =
		inside ? setup->middle : clamp_int(setup->middle, top, bottom);
	const int end = last == v[2]
		? bottom
		: clamp_int(raster_centre(v[2]->y), turn, bottom);

	OPAQUE(inverse); /* else compilers find it from draw for each edge */
	frame_set_edge(draw, edges, !part, v[0], v[2], top, inside, inverse);
	if (turn > top) {
		frame_set_edge(
			draw, edges, part, v[0], v[1], top, inside, inverse);
		edges->rows = turn - top;
		function(band);
	}
	if (bottom > turn) {
		frame_set_edge(
			draw, edges, part, v[1], last, turn, inside, inverse);
		edges->rows = end - turn;
		function(band);
	}
	if (bottom > end) {
		frame_set_edge(
			draw, edges, !part, v[2], last, end, inside, inverse);
		edges->rows = bottom - end;
		function(band);
	}
}

/* A triangle's texture coordinate, in 1/256 of the base level's texels. */
struct frame_texels {
	struct delta delta;
	int32_t low, high; /* at any corner */
};

static ALWAYS_INLINE struct frame_texels frame_find_texels(
	const struct setup *setup, int name, int log2, bool repeats)
{
	const struct vertex *const *v = setup->v;
	uint32_t first = (uint32_t)v[0]->attribute[name];
	uint32_t base = repeats ? first & ~0xFFFFu : 0;
	int32_t a = (int32_t)(first - base);
	int32_t b = (int32_t)((uint32_t)v[1]->attribute[name] - base);
	int32_t c = (int32_t)((uint32_t)v[2]->attribute[name] - base);

	if (log2 <= 8) {
		a >>= 8 - log2;
		b >>= 8 - log2;
		c >>= 8 - log2;
	} else {
		a = shift_by(a, log2 - 8);
		b = shift_by(b, log2 - 8);
		c = shift_by(c, log2 - 8);
	}
	return (struct frame_texels){frame_find_delta(a, b, c),
		raster_least(a, b, c), raster_most(a, b, c)};
}

#endif
