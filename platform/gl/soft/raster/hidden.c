/* Triangles that lie behind what is there, before anything is set up for them. */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/raster.h"

enum {
	COLUMNS_MOST = 32, /* of triangles that are looked at */
};

/* The largest of so many depths, of at least two. */
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

bool soft_is_hidden(const struct draw *draw, const struct setup *setup)
{
	const struct vertex *const *v = setup->v;
	const struct clip_box *box = &draw->box;
	const int width = draw->soft->buffers.width;
	int left = raster_centre(raster_least(v[0]->x, v[1]->x, v[2]->x));
	const uint16_t *depth = draw->soft->buffers.depth + left;
	int middle = (setup->top + setup->bottom) / 2, columns = setup->columns;
	int32_t z;

	if (!draw->hides || columns > COLUMNS_MOST || columns < 2 ||
		left < box->left || left + columns > box->right ||
		setup->top < box->top || setup->bottom > box->bottom) {
		return false;
	}
	/* Planes lose less than a unit to rounding. */
	z = raster_least(v[0]->z, v[1]->z, v[2]->z) / 4 - 1;
	/* Most that are seen are seen in the middle. */
	if (depth[middle * width + columns / 2] >= z) {
		return false;
	}
	depth += setup->top * width;
	for (int y = setup->top; y < setup->bottom; y++, depth += width) {
		if (find_farthest(depth, columns) >= z) {
			return false;
		}
	}
	return true;
}
