/* The transformation in C, for processors that arm/vertex.S is not for. */
#include "platform/gl/soft/vertex/draw.h"

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	soft_transform_c(draw, index, out);
}
