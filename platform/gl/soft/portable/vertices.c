#include "platform/gl/soft/vertex/draw.h"

void soft_transform(const struct draw *draw, uint32_t index, struct vertex *out)
{
	soft_transform_c(draw, index, out);
}

bool soft_draw_dedup(struct draw *draw, const uint8_t *at, size_t stride_bytes,
	int words, uint32_t first, uint32_t count)
{
	(void)draw;
	(void)at;
	(void)stride_bytes;
	(void)words;
	(void)first;
	(void)count;
	return false;
}
