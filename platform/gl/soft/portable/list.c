#include "platform/gl/soft/vertex/draw.h"

void soft_list(struct draw *draw, const void *indices, uint32_t count)
{
	soft_list_c(draw, indices, count);
}
