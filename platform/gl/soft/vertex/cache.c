/* The vertex cache: loading its slots, and drawing triangles one by one. */
#include "platform/gl/soft/vertex/cache.h"

void soft_load_slot(struct draw *draw, uint32_t slot, uint32_t index)
{
	struct vertex *vertex = draw->fast_setup.cache + slot;
	struct cache_tag *place = draw->fast_setup.place + slot;

	soft_transform(draw, index, vertex);
	place->tag = vertex->outcode ? TAG_OUTSIDE : index;
	place->xy = vertex_xy(vertex);
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

void soft_draw_triangle(struct draw *draw, const struct source *source,
	uint32_t a, uint32_t b, uint32_t c)
{
	struct vertex *v[3];
	unsigned out;

	soft_find_vertices(draw, source, (uint32_t[]){a, b, c}, 3, v);
	if (v[0]->outcode & v[1]->outcode & v[2]->outcode) {
		return;
	}
	out = v[0]->outcode | v[1]->outcode | v[2]->outcode;
	draw->provoking = v[2];
	if (out) {
		soft_clip_triangle(draw, v);
	} else {
		soft_fill_triangle(draw, v);
	}
}
