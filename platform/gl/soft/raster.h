/*
 * Setting triangles up and walking their rows.
 */
#ifndef PLATFORM_GL_SOFT_RASTER_H
#define PLATFORM_GL_SOFT_RASTER_H

#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/number.h"

enum {
	/*
	 * Up to so many sixteenths of a pixel, and with attributes that differ
	 * by less than SMALL_DELTA, products of the set-up fit 32 bits.
	 */
	SMALL_EXTENT = 2047,
	SMALL_DELTA = 1 << 18,
};

/* A triangle on its way to the rows: its vertices by y, and its rows. */
struct setup {
	const struct vertex *v[3];
	bool back, wide;
	bool middle_left; /* the middle vertex lies left of the long edge */
	int top, middle, bottom;
	/* from v[0], in sixteenths */
	int32_t x1, y1, x2, y2;
	/* 2^62 over the area (shifted up by zeros), with its sign */
	int32_t inverse_area;
	int area_zeros; /* of 64 bits */
};

/* One side of the triangle, in 16.16 pixels. */
struct side {
	int32_t x, step;
};

/* The first pixel whose centre is at or beyond this. */
static inline int raster_centre(int32_t sixteenths)
{
	return (sixteenths + 7) >> 4;
}

static inline int raster_column(int32_t x_q16)
{
	return (x_q16 + 0x7FFF) >> 16;
}

/* raster.c: fills draw->raster. */
void raster_set_up(struct draw *draw, struct setup *setup);

/* The edge from a down to b, at the centre of the row. */
struct side raster_side(const struct vertex *a, const struct vertex *b, int row);

/* Moves all planes in use down by so many rows. */
void raster_skip_rows(struct draw *draw, int rows);

/* A plane's value at column x of the row under way. */
static inline uint32_t plane_at(const struct raster *raster, int plane, int x)
{
	const struct plane *p = &raster->plane[plane];

	return p->start + (uint32_t)p->dx * (uint32_t)(x - raster->x0);
}

/* rows.c: any state, through the stages of fragment.c. */
void rows_fill(struct draw *draw, const struct setup *setup);

/*
 * Calls row(draw, y, left, right) for each row with pixels, inside of
 * draw->box; next(draw) moves the planes on.
 */
static ALWAYS_INLINE void raster_walk(struct draw *draw,
	const struct setup *setup,
	void (*row)(struct draw *draw, int y, int left, int right),
	void (*next)(struct draw *draw))
{
	const struct clip_box box = draw->box;
	int y = setup->top, end = setup->bottom, turn = setup->middle;
	struct side whole = {0}, part = {0};

	end = end < box.bottom ? end : box.bottom;
	if (y < box.top) {
		raster_skip_rows(draw, box.top - y);
		y = box.top;
	}
	whole = raster_side(setup->v[0], setup->v[2], y);
	if (y < turn) {
		part = raster_side(setup->v[0], setup->v[1], y);
	}
	turn = turn > y ? turn : y;
	for (; y < end; y++) {
		int left, right;

		if (y == turn) {
			part = raster_side(setup->v[1], setup->v[2], y);
		}
		left = raster_column(setup->middle_left ? part.x : whole.x);
		right = raster_column(setup->middle_left ? whole.x : part.x);
		left = left > box.left ? left : box.left;
		right = right < box.right ? right : box.right;
		if (left < right) {
			row(draw, y, left, right);
		}
		next(draw);
		whole.x += whole.step;
		part.x += part.step;
	}
}

#endif
