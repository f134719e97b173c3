/* The largest magnitude of many floats; arm/largest_float.S is faster. */
#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/draw.h"

uint32_t soft_largest_float(
	const uint8_t *at, int stride_bytes, uint32_t count, int size)
{
	uint32_t most = 0;

	for (; count > 0; count--, at += stride_bytes) {
		for (int i = 0; i < size; i++) {
			uint32_t own = load_32(at + 4 * i) << 1;

			most = own > most ? own : most;
		}
	}
	return most;
}
