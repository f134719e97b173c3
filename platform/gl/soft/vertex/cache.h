/* From vertices of the cache to primitives: what the kinds of lists share. */
#ifndef PLATFORM_GL_SOFT_VERTEX_CACHE_H
#define PLATFORM_GL_SOFT_VERTEX_CACHE_H

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/draw.h"

#include <string.h>

/* cache.c: the vertex of an index into a slot of the cache. */
void soft_load_slot(struct draw *draw, uint32_t slot, uint32_t index);

/*
 * unindexed.c: triangles without indices, count vertices from first on; finds
 * those that come again by what they are made of. False, with nothing drawn,
 * where arrays do not lie together, are not words to compare, or are so long
 * that 16 bits do not number their vertices.
 */
bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count);

/* Where the vertices of a call come from. */
struct source {
	const uint8_t *indices; /* NULL: from first on */
	GLenum type;
	uint32_t first, count;
};

static ALWAYS_INLINE uint32_t index_at(const struct source *source, uint32_t i)
{
	uint16_t index;

	if (!source->indices) {
		return source->first + i;
	}
	if (source->type == GL_UNSIGNED_BYTE) {
		return source->indices[i];
	}
	memcpy(&index, source->indices + 2 * i, sizeof(index));
	return index;
}

static ALWAYS_INLINE struct vertex *find_by_index(
	struct draw *draw, uint32_t index)
{
	uint32_t slot = index % VERTEX_CACHE;
	struct vertex *vertex = &draw->cache[slot];
	uint32_t tag = draw->place[slot].tag;

	if (tag != index && (tag != TAG_OUTSIDE || vertex->index != index)) {
		soft_load_slot(draw, slot, index);
	}
	return vertex;
}

static inline struct vertex *find_vertex(
	struct draw *draw, const struct source *source, uint32_t i)
{
	return find_by_index(draw, index_at(source, i));
}

/*
 * cache.c: vertices of one primitive whose indices share a slot of the cache:
 * all but the last move to places of their own.
 */
void soft_find_vertices(struct draw *draw, const struct source *source,
	const uint32_t *at, int count, struct vertex **out);

/* cache.c: the triangle of three of a source's vertices, where it is seen. */
void soft_draw_triangle(struct draw *draw, const struct source *source,
	uint32_t a, uint32_t b, uint32_t c);

/*
 * arm/list.S or portable/triangles.c: triangles by 16-bit indices at an even
 * address, while draw->packed; does what soft_draw_triangle() does, in assembly
 * faster.
 */
void soft_list(struct draw *draw, const struct source *source);

#endif
