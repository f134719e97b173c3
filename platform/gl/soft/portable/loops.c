/* Small loops, for processors that the assembly in arm/ is not for. */
#include "platform/gl/soft/raster/mix.h"
#include "platform/gl/soft/vertex/number.h"

void soft_fill_pixels(uint16_t *at, int count, uint16_t value)
{
	const uint32_t pair = value * 0x10001u;

	for (; count >= 8; count -= 8, at += 8) {
		memcpy(at, &pair, 4);
		memcpy(at + 2, &pair, 4);
		memcpy(at + 4, &pair, 4);
		memcpy(at + 6, &pair, 4);
	}
	for (; count > 0; count--) {
		*at++ = value;
	}
}

uint32_t soft_largest_aligned_float(
	const uint8_t *at, int stride_bytes, uint32_t count)
{
	return soft_largest_float(at, stride_bytes, count, 3);
}
