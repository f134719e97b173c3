/* Chooses which triangles and vertices of a large primitive form a part. */
#ifndef APP_MODEL_SPLIT_SPLIT_TRIANGLES_H
#define APP_MODEL_SPLIT_SPLIT_TRIANGLES_H

#include "app/model/model.h"

struct split_part {
	struct split_part *next;
	int vertex_count, repeated_count; /* see struct model_primitive */
	uint32_t *vertex;                 /* [vertex_count]: numbers in the
					     primitive */
	int index_count;
	uint32_t *index; /* each below vertex_count; in the primitive's order */
};

/*
 * Sets *out to a linked list of parts in the arena, each of at most
 * vertices_max vertices. Together they have each triangle of the primitive once
 * and each vertex at least once. Vertices that no triangle uses come last, in
 * parts without triangles. vertices_max is at least 3. Returns 0 or -ENOMEM.
 */
int split_triangles(const struct model_primitive *primitive, int vertices_max,
	struct arena *arena, struct split_part **out);

#endif
