#include "platform/gl/soft/draw.h"

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	transform_c(draw, index, out);
}
