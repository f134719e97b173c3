/*
 * Culls triangles, sorts their vertices and finds the pixels they may cover.
 *
 * Fill rule: a pixel belongs to the triangle its centre lies in; centres on an
 * edge belong to the triangle right of or below it. Edges are always stepped
 * from their upper end, so both triangles at an edge compute the same numbers.
 */
#include "platform/gl/gl_counts.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/vertex/draw.h"
#include "platform/gl/soft/vertex/number.h"

#include <stddef.h>
#include <string.h>

static void order(const struct vertex **a, const struct vertex **b)
{
	const struct vertex *first = *b, *second = *a;

	if (second->y != first->y ? second->y > first->y : second->x > first->x) {
		*a = first;
		*b = second;
	}
}

/* Finds rows and columns that may be covered; false if there are none. */
static bool find_extent(const struct draw *draw, struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const struct vertex *last = draw->fourth ? draw->fourth : v[2];
	const struct clip_box *box = &draw->box;
	int32_t left = raster_least(v[0]->x, v[1]->x, v[2]->x);
	int32_t most = raster_most(v[0]->x, v[1]->x, v[2]->x);
	int32_t right = last->x > most ? last->x : most;
	int32_t width = right - left, height = last->y - v[0]->y;

	setup->top = raster_centre(v[0]->y);
	setup->middle = raster_centre(v[1]->y);
	setup->bottom = raster_centre(last->y);
	setup->columns = raster_centre(right) - raster_centre(left);
	setup->extent = width > height ? width : height;
	setup->wide = setup->extent > SMALL_EXTENT;
	setup->inside = !setup->wide && setup->top >= box->top &&
		setup->bottom <= box->bottom &&
		raster_centre(left) > box->left &&
		raster_centre(right) < box->right;
	return setup->top < setup->bottom && setup->top < box->bottom &&
		setup->bottom > box->top && setup->columns > 0 &&
		raster_centre(left) < box->right &&
		raster_centre(right) > box->left;
}

void soft_fill_triangle(struct draw *draw, struct vertex *const v[3])
{
	struct setup setup = {
		.v = {v[0], v[1], v[2]}, .provoking = draw->provoking};
	int64_t area = raster_find_area(v[0], v[1], v[2]);

	/* positive areas are clockwise: y runs downwards here */
	setup.back = (area > 0) == draw->front_is_ccw;
	if (area == 0 || (setup.back ? draw->cull_back : draw->cull_front)) {
		return;
	}
	order(&setup.v[0], &setup.v[1]);
	order(&setup.v[1], &setup.v[2]);
	order(&setup.v[0], &setup.v[1]);
	if (!find_extent(draw, &setup)) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		if (!v[i]->shaded && draw->fast_setup.attributes) {
			soft_shade(draw, v[i]);
		}
	}
	setup.area = area < 0 ? (uint64_t)-area : (uint64_t)area;
	draw->fast_setup.fill(draw, &setup);
}

static bool is_packed(const struct draw *draw)
{
	const struct fragment_state *state = &draw->soft->fragment;
	const struct rectangle *r = &state->viewport;
	int top = draw->soft->buffers.target.height - r->y - r->height;

	return r->x >= 0 && top >= 0 && r->x + r->width <= PACKED_PIXELS &&
		top + r->height <= PACKED_PIXELS &&
		!(draw->cull_front && draw->cull_back);
}

/* A pixel's corner in cache_tag.xy's format, in 1/16 pixels. */
static uint32_t pack_pixels(int x, int y)
{
	return (uint32_t)y << 20 | (uint32_t)x << 4;
}

/* Whether colours are not those of the corners: see fill_copies(). */
static bool draws_copies(const struct draw *draw)
{
	return draw->attributes &&
		(draw->soft->fragment.flat || draw->shading.two_side);
}

/*
 * GL_FLAT draws copies of the corners, all in the provoking vertex's colour;
 * the other corners' colours are not computed. Of two-sided lighting, copies of
 * a back face's corners have the back's colours.
 */
static void fill_copies(struct draw *draw, struct setup *setup)
{
	const bool flat = raster_is_flat(draw);
	const bool back = setup->back && draw->shading.two_side;

	for (int i = 0; i < 3; i++) {
		struct vertex *own = (struct vertex *)setup->v[i];
		struct vertex *from = flat ? setup->provoking : own;
		struct vertex *to = &draw->copies[i];

		soft_shade(draw, from);
		if (!flat && !back) {
			continue;
		}
		memcpy(to, own, offsetof(struct vertex, back));
		if (!to->shaded && draw->shade_more) {
			soft_shade_rest(draw, to);
		}
		memcpy(to->attribute, back ? from->back : from->attribute,
			sizeof(from->back));
		setup->v[i] = to;
	}
	draw->fill(draw, setup);
}

/*
 * Drops a triangle that is hidden: before its corners are shaded, if it is
 * small. Where no corner's colour is needed, it is not computed.
 */
static void fill_seen(struct draw *draw, struct setup *setup)
{
	const bool flat = raster_is_flat(draw);
	bool hidden = setup->inside && soft_is_wholly_hidden(draw, setup);
	const bool shaded = !hidden && !(flat && setup->inside);

	for (int i = 0; i < 3 && shaded; i++) {
		soft_shade(draw, (struct vertex *)setup->v[i]);
	}
	if (!setup->inside) {
		soft_raster_set_up(draw, setup);
		hidden = soft_is_wholly_hidden(draw, setup);
	}
	if (!hidden) {
		(draws_copies(draw) ? fill_copies : draw->fill)(draw, setup);
	} else if (draw->soft->counts) {
		draw->soft->counts->skipped += 1.0;
	}
}

void soft_prepare_fast_setup(struct soft *soft, struct draw *draw)
{
	/* Front faces, drawn before opaque back faces, hide most of them. */
	const bool mostly_hidden =
		draw->cull_front && draw->hides && !draw->blended;
	const fill_function first = mostly_hidden ? fill_seen
		: draws_copies(draw)              ? fill_copies
						  : NULL;
	const struct buffers *buffers = &soft->buffers;
	const struct clip_box *box = &draw->box;
	bool clockwise_culled =
		draw->front_is_ccw ? draw->cull_back : draw->cull_front;

	draw->packed = is_packed(draw);
	draw->fast_setup = (struct fast_setup){
		.fill = first ? first : draw->fill,
		.place = draw->place,
		.cache = draw->cache,
		.cull_side = clockwise_culled ? UINT32_MAX : 0,
		.cull_mask = draw->cull_front || draw->cull_back ? 1u << 31 : 0,
		.depth = (uintptr_t)buffers->depth,
		.stride_bytes = 2 * (uintptr_t)buffers->width,
		.pixels = (uintptr_t)buffers->target.data -
			((uintptr_t)buffers->depth
				<< (draw->spans.pixel_log2 - 1)) -
			2,
		.attributes = first ? 0 : draw->attributes,
		.back_flip = draw->front_is_ccw,
	};
	/* By default an empty box: no triangle lies inside. */
	draw->fast_setup.box_low = PACKED_PIXELS * 0x100010u;
	if (draw->packed && box->right - box->left > 2) {
		draw->fast_setup.box_low = pack_pixels(box->left + 1, box->top);
		draw->fast_setup.box_high =
			pack_pixels(box->right - 1, box->bottom);
	}
}
