#include "platform/gl/soft/vertex/primitive.h"

void soft_load_slot(struct draw *draw, uint32_t slot, uint32_t index)
{
	load_slot(draw, slot, index, draw->packed);
}

void soft_find_vertices(struct draw *draw, const struct source *source,
	const uint32_t *at, int count, struct vertex **out)
{
	for (int i = 0; i < count; i++) {
		out[i] = find_vertex(draw, source, at[i]);
		for (int j = 0; j < i; j++) {
			if (out[j] == out[i] &&
				index_at(source, at[j]) !=
					index_at(source, at[i])) {
				out[j] = &draw->apart[j];
				soft_transform(
					draw, index_at(source, at[j]), out[j]);
			}
		}
	}
}
