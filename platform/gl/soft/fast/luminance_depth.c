/* Depths of a row of tiles. */
#include "platform/gl/soft/fast/tile_row.h"
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/raster/raster.h"
#include "platform/gl/soft/span/halves.h"

/*
 * The same depth for all pixels of a row if rounding alone makes them differ,
 * as in level planes.
 */
void soft_luminance_write_depth(
	uint16_t *depth, int count, uint32_t z, uint32_t z_right)
{
	if ((uint64_t)raster_size((int32_t)z_right) * (uint32_t)count < 1 << 16) {
		z += (uint32_t)((int32_t)z_right * count / 2);
		soft_fill_pixels(depth, count, (uint16_t)(z >> 16));
		return;
	}
	if ((uintptr_t)depth % sizeof(uint32_t) != 0) {
		*depth++ = (uint16_t)(z >> 16);
		z += z_right;
		count--;
	}
	/* Four words a turn, as the loop's own work counts. */
	for (; count >= 8; count -= 8) {
		for (int i = 0; i < 4; i++, depth += 2) {
			uint32_t next = z + z_right;

			soft_store_two(depth, UPPER_HALVES(next, z));
			z = next + z_right;
		}
	}
	for (; count > 0; count--) {
		*depth++ = (uint16_t)(z >> 16);
		z += z_right;
	}
}

int soft_luminance_test_depth(
	uint16_t *depth, int count, uint32_t z, uint32_t z_right)
{
	int i = 0;

	for (; i < count - 1; i += 2) {
		if (z >> 16 >= depth[i]) {
			return i;
		}
		depth[i] = (uint16_t)(z >> 16);
		z += z_right;
		if (z >> 16 >= depth[i + 1]) {
			return i + 1;
		}
		depth[i + 1] = (uint16_t)(z >> 16);
		z += z_right;
	}
	if (i < count && z >> 16 < depth[i]) {
		depth[i] = (uint16_t)(z >> 16);
		i++;
	}
	return i;
}
