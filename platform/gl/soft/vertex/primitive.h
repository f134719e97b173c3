/* From vertices of the cache to primitives: what the kinds of lists share. */
#ifndef PLATFORM_GL_SOFT_VERTEX_PRIMITIVE_H
#define PLATFORM_GL_SOFT_VERTEX_PRIMITIVE_H

#include "platform/gl/soft/vertex/draw.h"

#include <string.h>

/* draw.c: the vertex of an index into a slot of the cache. */
void soft_load_slot(struct draw *draw, uint32_t slot, uint32_t index);

/*
 * unindexed.c: triangles without indices, count vertices from first on; finds
 * those that come again by what they are made of. False where arrays are not
 * words to compare: draws nothing then.
 */
bool soft_draw_unindexed(struct draw *draw, uint32_t first, uint32_t count);

/* A triangle of transformed vertices, as far as it is in the clip volume. */
static ALWAYS_INLINE void draw_transformed(
	struct draw *draw, struct vertex *const v[3])
{
	unsigned out;

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

static ALWAYS_INLINE uint32_t load_word(const uint8_t *at)
{
	uint32_t word;

	memcpy(&word, at, sizeof(word));
	return word;
}

#endif
