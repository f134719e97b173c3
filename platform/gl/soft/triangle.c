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
	for (int i = 0; i < 3; i++) {
		int a = i == 1 ? 1 : 0;

		if (v[a]->y > v[a + 1]->y) {
			const struct vertex *swap = v[a];

			v[a] = v[a + 1];
			v[a + 1] = swap;
		}
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
	setup->wide =
		right - left > SMALL_EXTENT || v[2]->y - v[0]->y > SMALL_EXTENT;
	return setup->top < setup->bottom && setup->top < draw->box.bottom &&
		setup->bottom > draw->box.top &&
		raster_centre(left) < raster_centre(right);
}

void soft_fill_triangle(struct draw *draw, struct vertex *const v[3])
{
	struct setup setup = {
		.v = {v[0], v[1], v[2]},
	};
	int64_t area = (int64_t)(v[1]->x - v[0]->x) * (v[2]->y - v[0]->y) -
		(int64_t)(v[2]->x - v[0]->x) * (v[1]->y - v[0]->y);
	bool clockwise = area > 0; /* y runs downwards here */

	setup.back = clockwise == (draw->soft->fragment.front_face == GL_CCW);
	if (area == 0 || is_culled(draw, setup.back)) {
		return;
	}
	order_by_y(setup.v);
	if (!find_extent(draw, setup.v, &setup)) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		soft_shade(draw, v[i]);
	}
	raster_set_up(draw, &setup);
	draw->fill(draw, &setup);
}
