#include "platform/gl/soft/draw.h"

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	transform_c(draw, index, out);
}

bool soft_light_by_beams(
	const struct beams *light, uint32_t index, struct vertex *vertex)
{
	return light_by_beams_c(light, index, vertex);
}
