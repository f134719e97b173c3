/* Finds triangles that lie behind the depth buffer, before their set-up. */
#include "platform/gl/soft/raster/frame.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/raster.h"

enum {
	COLUMNS_MOST = 32, /* wider triangles are not tested */
};

/* The largest of count depths; count is at least two. */
static ALWAYS_INLINE int32_t find_farthest(const uint16_t *depth, int count)
{
	const uint16_t *last = depth + count - 2;
	uint32_t most = soft_load_two(last);

	for (; depth < last; depth += 2) {
		most = most_halves(most, soft_load_two(depth));
	}
	return (int32_t)(most >> 16 > (most & 0xFFFF) ? most >> 16
						      : most & 0xFFFF);
}

static NEVER_INLINE bool is_behind_all(
	const uint16_t *depth, int width, int rows, int columns, int32_t z)
{
	for (; rows > 0; rows--, depth += width) {
		if (find_farthest(depth, columns) >= z) {
			return false;
		}
	}
	return true;
}

bool soft_is_hidden(const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const int width = draw->soft->buffers.width;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	const uint16_t *depth = draw->soft->buffers.depth + left;
	int columns = setup->columns, rows = setup->bottom - setup->top;
	int32_t z;

	if (!draw->hides || columns > COLUMNS_MOST || columns < 2 ||
		!raster_is_in_box(draw, setup)) {
		return false;
	}
	/* Rounding moves a plane's depths by less than one unit. */
	z = (raster_least(v[0]->z, v[1]->z, v[2]->z) >> 2) - 1;
	depth += setup->top * width;
	/* Most visible triangles are visible in the middle: test that first. */
	return depth[(rows >> 1) * width + (columns >> 1)] < z &&
		is_behind_all(depth, width, rows, columns, z);
}

/* The rows of a triangle that are searched for a pixel in front. */
struct search {
	const struct draw *draw;
	const uint16_t *depth;   /* column 0 of the next row */
	uint32_t z, right, down; /* there, 16.16; its steps */
	bool found;
	struct band_edges edges;
};

static ALWAYS_INLINE void search(struct search *search, bool clipped)
{
	const struct clip_box box = search->draw->box;
	const int width = search->draw->soft->buffers.width;
	const uint32_t right = search->right, down = search->down;
	struct band_edges edges = search->edges;
	const uint16_t *row = search->depth;
	uint32_t start = search->z;

	for (; edges.rows > 0 && !search->found; band_next_row(&edges)) {
		int left = band_column(&edges, BAND_LEFT);
		int end = band_column(&edges, BAND_RIGHT);
		const uint16_t *depth;
		uint32_t z;

		if (clipped) {
			left = left > box.left ? left : box.left;
			end = end < box.right ? end : box.right;
		}
		depth = row + left;
		z = start + right * (uint32_t)left;
		for (; depth < row + end; z += right) {
			if (z >> 16 <= *depth++) {
				search->found = true;
				return;
			}
		}
		start += down;
		row += width;
	}
	search->edges = edges;
	search->depth = row;
	search->z = start;
}

static void search_inside(void *rows)
{
	search(rows, false);
}

static void search_clipped(void *rows)
{
	search(rows, true);
}

bool soft_is_wholly_hidden(const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const struct delta delta = frame_find_delta(v[0]->z, v[1]->z, v[2]->z);
	const int top = raster_first_row(draw, setup);
	struct plane plane = draw->raster.plane[DEPTH];
	struct search rows = {.draw = draw};
	struct frame frame;

	if (setup->inside) {
		frame_find(setup, &frame);
		plane = frame_find_plane(&frame, &delta);
	}
	rows.depth = draw->soft->buffers.depth + top * draw->soft->buffers.width;
	rows.right = (uint32_t)plane.dx << 6;
	rows.down = (uint32_t)plane.dy << 6;
	rows.z = (plane.start << 6) + rows.down * (uint32_t)(top - setup->top);
	/* LESS hides equal depths, too */
	rows.z += draw->spans.equal_passes ? 0 : 1 << 16;
	if (setup->inside) {
		frame_draw_bands(draw, setup, true, frame.middle_left,
			&rows.edges, search_inside, &rows);
	} else {
		frame_draw_bands(draw, setup, false, setup->middle_left,
			&rows.edges, search_clipped, &rows);
	}
	return !rows.found;
}
