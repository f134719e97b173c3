/*
 * Triangles: what is seen of them, how their attributes run, and their rows.
 *
 * A pixel belongs to the triangle its centre lies in; centres on an edge
 * belong to the triangle right of or below it. Edges are stepped from their
 * upper end always, so both triangles at an edge see the same numbers.
 */
#include "platform/gl/soft/draw.h"
#include "platform/gl/soft/number.h"
#include "platform/gl/soft/raster.h"

static bool is_culled(const struct draw *draw, bool back)
{
	return back ? draw->cull_back : draw->cull_front;
}

static void order_by_y(const struct vertex *v[3])
{
	const struct vertex *a = v[0], *b = v[1], *c = v[2];

	if (a->y > b->y) {
		v[0] = b;
		v[1] = a;
		a = v[0];
		b = v[1];
	}
	if (b->y > c->y) {
		bool first = a->y > c->y;

		v[2] = b;
		v[1] = first ? a : c;
		v[0] = first ? c : a;
	}
}

static int32_t least(int32_t a, int32_t b, int32_t c)
{
	int32_t ab = a < b ? a : b;

	return ab < c ? ab : c;
}

static int32_t most(int32_t a, int32_t b, int32_t c)
{
	int32_t ab = a > b ? a : b;

	return ab > c ? ab : c;
}

/* The rows and columns whose centres can be covered; false if none. */
static bool find_extent(const struct draw *draw,
	const struct vertex *const v[3], struct setup *setup)
{
	int32_t left = least(v[0]->x, v[1]->x, v[2]->x);
	int32_t right = most(v[0]->x, v[1]->x, v[2]->x);

	setup->top = raster_centre(v[0]->y);
	setup->middle = raster_centre(v[1]->y);
	setup->bottom = raster_centre(v[2]->y);
	setup->extent = right - left > v[2]->y - v[0]->y ? right - left
							 : v[2]->y - v[0]->y;
	setup->wide = setup->extent > SMALL_EXTENT;
	setup->inside = draw->same_stride && setup->top >= draw->box.top &&
		setup->bottom <= draw->box.bottom &&
		raster_centre(left) > draw->box.left &&
		raster_centre(right) < draw->box.right;
	return setup->top < setup->bottom && setup->top < draw->box.bottom &&
		setup->bottom > draw->box.top &&
		raster_centre(left) < raster_centre(right);
}

/* Twice the area in sixteenths squared; rarely more than 32 bits. */
static int64_t find_area(
	const struct vertex *a, const struct vertex *b, const struct vertex *c)
{
	return (int64_t)(b->x - a->x) * (c->y - a->y) -
		(int64_t)(c->x - a->x) * (b->y - a->y);
}

void soft_fill_triangle(struct draw *draw, struct vertex *const v[3])
{
	struct setup setup;
	int64_t area = find_area(v[0], v[1], v[2]);
	bool clockwise = area > 0; /* y runs downwards here */

	setup.back = clockwise == draw->front_is_ccw;
	if (area == 0 || is_culled(draw, setup.back)) {
		return;
	}
	setup.v[0] = v[0];
	setup.v[1] = v[1];
	setup.v[2] = v[2];
	order_by_y(setup.v);
	if (!find_extent(draw, setup.v, &setup)) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		if (!v[i]->shaded && draw->attributes) {
			soft_shade(draw, v[i]);
		}
	}
	setup.area = area < 0 ? (uint64_t)-area : (uint64_t)area;
	draw->fill(draw, &setup);
}
