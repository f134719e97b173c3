/* The vertex cache, and triangles of its vertices, by index. */
#ifndef PLATFORM_GL_SOFT_VERTEX_CACHE_H
#define PLATFORM_GL_SOFT_VERTEX_CACHE_H

#include "platform/gl/soft/raster/pixel.h"
#include "platform/gl/soft/vertex/draw.h"

#include <string.h>

enum {
	CACHE_INDICES =
		1 << 16,  /* vertices that indices of 16 bits can number */
	CACHE_LIST = 192, /* indices that are made for a call of soft_list() */
};

/* cache.c: transforms the vertex of an index into a slot of the cache. */
void soft_load_slot(struct draw *draw, uint32_t slot, uint32_t index);

/*
 * unindexed.c: draws GL_TRIANGLES without indices, count vertices from first
 * on; vertices with equal array elements are transformed once. False, with
 * nothing drawn, where there are too few vertices for that to pay, 16 bits
 * cannot number the vertices, or draw->packed is not set.
 */
bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count);

/* The vertices of a draw call: count indices, or count vertices from first on. */
struct source {
	const uint8_t *indices; /* NULL: first, first + 1, ... */
	GLenum type;            /* of indices */
	uint32_t first, count;
};

static ALWAYS_INLINE uint32_t index_at(const struct source *source, uint32_t i)
{
	if (!source->indices) {
		return source->first + i;
	}
	return source->type == GL_UNSIGNED_BYTE
		? source->indices[i]
		: load_16(source->indices + 2 * i);
}

static inline struct vertex *find_vertex(
	struct draw *draw, const struct source *source, uint32_t i)
{
	uint32_t index = index_at(source, i), slot = index % VERTEX_CACHE;
	struct vertex *vertex = &draw->cache[slot];
	uint32_t tag = draw->place[slot].tag;

	if (tag != index && (tag != TAG_OUTSIDE || vertex->index != index)) {
		soft_load_slot(draw, slot, index);
	}
	return vertex;
}

/*
 * cache.c: finds the vertices of a primitive, at[] being numbers in the source.
 * Where two need the same slot of the cache, the last one gets it, and the
 * others are transformed into draw->apart.
 */
void soft_find_vertices(struct draw *draw, const struct source *source,
	const uint32_t *at, int count, struct vertex **out);

/* cache.c: draws the triangle of a source's vertices number a, b and c. */
void soft_draw_triangle(struct draw *draw, const struct source *source,
	uint32_t a, uint32_t b, uint32_t c);

/*
 * arm/list.S or portable/triangles.c: draws GL_TRIANGLES of 16-bit indices at
 * an even address, while draw->packed, as soft_draw_triangle() does one by one;
 * the assembly is faster.
 */
void soft_list(struct draw *draw, const struct source *source);

#endif
