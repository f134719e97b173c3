/* For machines without the assembly of arm/: C alone. */
#include "platform/gl/soft/vertex/draw.h"

uint32_t soft_largest_aligned_float(
	const uint8_t *at, int stride_bytes, uint32_t count)
{
	return soft_largest_float(at, stride_bytes, count);
}
