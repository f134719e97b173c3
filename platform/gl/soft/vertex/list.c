/*
 * Lists of triangles by 16-bit indices: finds, culls and sets up a triangle in
 * one loop as long as all of its vertices are in the cache and on the screen.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/primitive.h"

/* The slots of a triangle's corners in the cache. */
struct corners {
	uint32_t a, b, c;
};

static ALWAYS_INLINE bool are_there(const struct cache_tag *place,
	const struct corners *slot, const uint16_t index[3])
{
	return place[slot->a].tag == index[0] &&
		place[slot->b].tag == index[1] && place[slot->c].tag == index[2];
}

/* A vertex into its slot, unless it is there, outside of the clip volume. */
static NEVER_INLINE void load_corner(
	struct draw *draw, uint32_t slot, uint32_t index)
{
	if (draw->fast_setup.place[slot].tag != TAG_OUTSIDE ||
		draw->fast_setup.cache[slot].index != index) {
		load_slot(draw, slot, index, true);
	}
}

/* False where one lies outside, or two share a slot. */
static ALWAYS_INLINE bool load_corners(
	struct draw *draw, const struct corners *slot, const uint16_t index[3])
{
	const struct cache_tag *place = draw->place;

	if (place[slot->a].tag != index[0]) {
		load_corner(draw, slot->a, index[0]);
	}
	if (place[slot->b].tag != index[1]) {
		load_corner(draw, slot->b, index[1]);
	}
	if (place[slot->c].tag != index[2]) {
		load_corner(draw, slot->c, index[2]);
	}
	return are_there(place, slot, index);
}

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

/* Its index is that of the list, or the vertex' own where there is none. */
static ALWAYS_INLINE void shade_corner(
	const struct draw *draw, struct vertex *vertex, const uint16_t *index)
{
	if (!vertex->shaded) {
		soft_shade_vertex(draw, vertex, index ? *index : vertex->index);
	}
}

static ALWAYS_INLINE void shade_corners(const struct draw *draw,
	struct vertex *cache, const struct corners *slot, const uint16_t *index)
{
	struct vertex *a = cache + slot->a, *b = cache + slot->b;
	struct vertex *c = cache + slot->c;

	if (!(a->shaded & b->shaded & c->shaded)) {
		shade_corner(draw, a, index);
		shade_corner(draw, b, index ? index + 1 : NULL);
		shade_corner(draw, c, index ? index + 2 : NULL);
	}
}

static NEVER_INLINE void draw_slots_other(
	struct draw *draw, uint32_t a, uint32_t b, uint32_t c)
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

/* Of a list with indices, or NULL. */
static ALWAYS_INLINE void draw_seen(struct draw *draw,
	const struct corners *slot, const uint16_t *index, const uint32_t xy[3],
	int32_t twice)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;
	struct setup setup;
	bool all;

	if (!find_extent(fast_setup, xy, &setup, &all)) {
		return;
	}
	if (!all) {
		draw_slots_other(draw, slot->a, slot->b, slot->c);
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
		shade_corners(draw, fast_setup->cache, slot, index);
	}
	fast_setup->fill(draw, &setup);
}

void soft_list(struct draw *draw, const struct source *source)
{
	const uint16_t *first = (const uint16_t *)(const void *)source->indices;
	const uint16_t *index = first, *end = index + source->count / 3 * 3;
	const struct cache_tag *place = draw->place;
	const uint32_t side = draw->fast_setup.cull_side;
	const uint32_t mask = draw->fast_setup.cull_mask;

	for (; index != end; index += 3) {
		const struct corners slot = {index[0] % VERTEX_CACHE,
			index[1] % VERTEX_CACHE, index[2] % VERTEX_CACHE};
		uint32_t xy[3];
		int32_t twice;

		if (!are_there(place, &slot, index) &&
			!load_corners(draw, &slot, index)) {
			uint32_t at = (uint32_t)(index - first);

			soft_draw_triangle(draw, source, at, at + 1, at + 2);
			continue;
		}
		xy[0] = place[slot.a].xy;
		xy[1] = place[slot.b].xy;
		xy[2] = place[slot.c].xy;
		twice = twice_area(xy);
		if (twice != 0 && (((uint32_t)twice ^ side) & mask) == 0) {
			draw_seen(draw, &slot, index, xy, twice);
		}
	}
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
		draw_seen(draw, &slot, NULL, xy, twice);
	}
}
