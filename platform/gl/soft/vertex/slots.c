/*
 * Triangles of vertices that are in the cache and on the screen: sets one up in
 * one place. arm/list.S does the same for lists with indices.
 */
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/primitive.h"

struct corner {
	uint32_t xy; /* as struct cache_tag has it */
	struct vertex *vertex;
};

/*
 * Rows, columns and size of corners as struct cache_tag has them. False where
 * no centre is covered; *all is whether all of the triangle is in the box.
 */
static ALWAYS_INLINE bool find_extent(const struct fast_setup *fast_setup,
	uint32_t a, uint32_t b, uint32_t c, struct setup *setup, bool *all)
{
	uint32_t least = least_halves(least_halves(a, b), c);
	uint32_t most = most_halves(most_halves(a, b), c);
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

static ALWAYS_INLINE struct corner find_corner(
	const struct fast_setup *fast_setup, const struct cache_tag *tag)
{
	return (struct corner){
		tag->xy, fast_setup->cache + (tag - fast_setup->place)};
}

static ALWAYS_INLINE void order(struct corner *a, struct corner *b)
{
	if (a->xy > b->xy) {
		const struct corner first = *b;

		*b = *a;
		*a = first;
	}
}

/* Corners by y. */
static ALWAYS_INLINE void set_corners(
	struct setup *setup, struct corner a, struct corner b, struct corner c)
{
	order(&a, &b);
	order(&b, &c);
	order(&a, &b);
	setup->xy[0] = a.xy;
	setup->xy[1] = b.xy;
	setup->xy[2] = c.xy;
	setup->v[0] = a.vertex;
	setup->v[1] = b.vertex;
	setup->v[2] = c.vertex;
	setup->middle = (int)((b.xy + (7 << 16)) >> 20);
}

static ALWAYS_INLINE void shade_corner(
	const struct draw *draw, struct vertex *vertex)
{
	if (!vertex->shaded) {
		soft_shade_vertex(draw, vertex, vertex->index);
	}
}

void soft_draw_slots_other(struct draw *draw, uint32_t a, uint32_t b, uint32_t c)
{
	struct vertex *v[3] = {
		draw->cache + a, draw->cache + b, draw->cache + c};

	draw_transformed(draw, v);
}

void soft_draw_tagged(struct draw *draw, const struct cache_tag *at_a,
	const struct cache_tag *at_b, const struct cache_tag *at_c,
	int32_t twice_area)
{
	const struct fast_setup *fast_setup = &draw->fast_setup;
	const struct corner a = find_corner(fast_setup, at_a);
	const struct corner b = find_corner(fast_setup, at_b);
	const struct corner c = find_corner(fast_setup, at_c);
	struct setup setup;
	bool all;

	if (!find_extent(fast_setup, a.xy, b.xy, c.xy, &setup, &all)) {
		return;
	}
	if (!all) {
		draw_transformed(draw,
			(struct vertex *[]){a.vertex, b.vertex, c.vertex});
		return;
	}
	set_corners(&setup, a, b, c);
	draw->provoking = c.vertex;
	setup.inside = true;
	setup.wide = false;
	setup.fast_setup = true;
	setup.back = ((uint32_t)twice_area >> 31) ^ fast_setup->back_flip;
	setup.area = raster_size(twice_area);
	if (fast_setup->attributes) {
		shade_corner(draw, a.vertex);
		shade_corner(draw, b.vertex);
		shade_corner(draw, c.vertex);
	}
	fast_setup->fill(draw, &setup);
}
