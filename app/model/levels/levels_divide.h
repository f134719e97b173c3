/*
 * A copy of a primitive without normals whose triangles have vertices of their
 * own, with the normals of their planes, to make levels from: simplify.c merges
 * those that may share a normal.
 */
#ifndef APP_MODEL_LEVELS_LEVELS_DIVIDE_H
#define APP_MODEL_LEVELS_LEVELS_DIVIDE_H

#include "app/model/model.h"

struct levels_divided {
	struct model_primitive primitive; /* without targets of its own */
	/*
	 * [primitive.vertex_count]: the whole primitive's vertex, which is its
	 * index
	 */
	const uint32_t *source;
	const bool *shared; /* [primitive.vertex_count] */
};

/*
 * Divides a primitive. shared[vertex_count] is copied, too. The arena owns the
 * arrays. Returns 0 or -ENOMEM.
 */
int levels_divide(const struct model_primitive *whole, const bool *shared,
	struct arena *arena, struct levels_divided *out);

/*
 * Converts a list over the divided vertices to one over those of the whole
 * primitive, and sets model_lod.corner, in the arena. Returns
 * 0 or -ENOMEM.
 */
int levels_join(const struct levels_divided *divided, struct model_lod *lod,
	struct arena *arena);

#endif
