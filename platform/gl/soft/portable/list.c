/* For machines without the assembly of arm/: one by one. */
#include "platform/gl/soft/vertex/primitive.h"

void soft_list(struct draw *draw, const struct source *source)
{
	for (uint32_t i = 0; i + 2 < source->count; i += 3) {
		soft_draw_triangle(draw, source, i, i + 1, i + 2);
	}
}
