/*
 * Triangles of vertices that are in the cache and on the screen: culls one and
 * sets it up in one place. arm/list.S does the same for lists with indices.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/primitive.h"

/* The slots of a triangle's corners in the cache. */
struct corners {
	uint32_t a, b, c;
};

/*
 * Rows, columns and size of corners as struct cache_tag has them. False where
 * no centre is covered; *all is whether all of the triangle is in the box.
 */
static ALWAYS_INLINE bool find_extent(const struct fast_setup *fast_setup,
	const uint32_t xy[3], struct setup *setup, bool *all)
{
	uint32_t least = least_halves(least_halves(xy[0], xy[1]), xy[2]);
	uint32_t most = most_halves(most_halves(xy[0], xy[1]), xy[2]);
	uint32_t size = most - least, round = 0x70007, whole = 0xFFF0FFF0;
	uint32_t centres, out;

	/* else each becomes two of an instruction */
	OPAQUE(round);
	OPAQUE(whole);
	least = (least + round) & whole;
	most = (most + round) & whole;
	centres = most - least;
	if (centres >> 16 == 0 || centres << 16 == 0) {
		return false;
	}
	setup->columns = (int)(centres << 16 >> 20);
	setup->top = (int)(least >> 20);
	setup->bottom = (int)(most >> 20);
	setup->extent = (int32_t)(size >> 16 > (size & 0xFFFF) ? size >> 16
							       : size & 0xFFFF);
	out = subtract_halves(least, fast_setup->box_low) |
		subtract_halves(fast_setup->box_high, most);
	*all = ((out | out << 16) >> 31) == 0 && setup->extent <= SMALL_EXTENT;
	return true;
}

/* The corners by y. */
static ALWAYS_INLINE void sort_corners(struct vertex *cache,
	const struct corners *slot, const uint32_t xy[3], struct setup *setup)
{
	int ab = xy[0] > xy[1], ac = xy[0] > xy[2], bc = xy[1] > xy[2];

	setup->xy[ab + ac] = xy[0];
	setup->xy[1 - ab + bc] = xy[1];
	setup->xy[2 - ac - bc] = xy[2];
	setup->v[ab + ac] = cache + slot->a;
	setup->v[1 - ab + bc] = cache + slot->b;
	setup->v[2 - ac - bc] = cache + slot->c;
	setup->middle = (int)((setup->xy[1] + (7 << 16)) >> 20);
}

static ALWAYS_INLINE void shade_corner(
	const struct draw *draw, struct vertex *vertex)
{
	if (!vertex->shaded) {
		soft_shade_vertex(draw, vertex, vertex->index);
	}
}

static ALWAYS_INLINE void shade_corners(const struct draw *draw,
	struct vertex *cache, const struct corners *slot)
{
	struct vertex *a = cache + slot->a, *b = cache + slot->b;
	struct vertex *c = cache + slot->c;

	if (!(a->shaded & b->shaded & c->shaded)) {
		shade_corner(draw, a);
		shade_corner(draw, b);
		shade_corner(draw, c);
	}
}

void soft_draw_slots_other(struct draw *draw, uint32_t a, uint32_t b, uint32_t c)
{
	struct vertex *v[3] = {
		draw->cache + a, draw->cache + b, draw->cache + c};

	draw_transformed(draw, v);
}

/* Twice the area, in sixteenths squared, positive where it is clockwise. */
static ALWAYS_INLINE int32_t twice_area(const uint32_t xy[3])
{
	return cross_halves(
		subtract_halves(xy[1], xy[0]), subtract_halves(xy[2], xy[0]));
}

static ALWAYS_INLINE void draw_seen(struct draw *draw,
	const struct corners *slot, const uint32_t xy[3], int32_t twice)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;
	struct setup setup;
	bool all;

	if (!find_extent(fast_setup, xy, &setup, &all)) {
		return;
	}
	if (!all) {
		soft_draw_slots_other(draw, slot->a, slot->b, slot->c);
		return;
	}
	sort_corners(fast_setup->cache, slot, xy, &setup);
	draw->provoking = fast_setup->cache + slot->c;
	setup.inside = true;
	setup.wide = false;
	setup.fast_setup = true;
	setup.back = ((uint32_t)twice >> 31) ^ fast_setup->back_flip;
	setup.area = (uint32_t)(twice < 0 ? -twice : twice);
	if (fast_setup->attributes) {
		shade_corners(draw, fast_setup->cache, slot);
	}
	fast_setup->fill(draw, &setup);
}

void soft_draw_slots(struct draw *draw, uint32_t a, uint32_t b, uint32_t c)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;
	const struct corners slot = {a, b, c};
	const struct cache_tag *place = fast_setup->place;
	const uint32_t xy[3] = {place[a].xy, place[b].xy, place[c].xy};
	int32_t twice = twice_area(xy);

	if (twice != 0 &&
		(((uint32_t)twice ^ fast_setup->cull_side) &
			fast_setup->cull_mask) == 0) {
		draw_seen(draw, &slot, xy, twice);
	}
}
