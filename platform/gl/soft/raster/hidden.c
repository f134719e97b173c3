/* Finds triangles that lie behind the depth buffer, before their set-up. */
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
