/*
 * Finds an order of triangles that suits a vertex cache, except for blended
 * triangles, and sorts vertices by their first use in these triangles.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_ORDER_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_ORDER_H

#include "app/model/gltf/document/gltf_document.h"

#include <stdbool.h>

/*
 * A group is all primitives that have the same attributes and targets, such as
 * the levels of detail of a mesh. A group is fixed, which means that it keeps
 * its order, if it shares an accessor with another group, or if one of its
 * primitives is not an indexed triangle list.
 */
struct optimize_group {
	bool fixed;
	int vertex_count; /* in the file */
	int used_count;   /* vertices that a triangle uses */
	uint32_t *source; /* [used_count]: the vertex's index in the file */
	uint32_t *rename; /* [vertex_count]: new index + 1; 0: not used */
};

struct optimize_order {
	const struct gltf_document *document;
	json_t *by_key; /* attributes and targets as text: the group */
	int count;
	struct optimize_group *group;
	int *of_vertices,
		*of_list; /* [accessors]: a group's index, or below 0 */
	uint32_t **list;  /* [accessors]: new indices, or NULL */
	bool *blended;    /* [accessors]: the triangles keep their order */
	bool *renamed;    /* [accessors]: list has new vertex numbers */
};

/*
 * Finds the order of all accessors. Returns 0 or -ENOMEM; the caller calls
 * optimize_order_release() in either case.
 */
int optimize_order_find(
	struct optimize_order *order, const struct gltf_document *document);

void optimize_order_release(struct optimize_order *order);

/* The group that a vertex accessor belongs to; NULL: it keeps its order. */
const struct optimize_group *optimize_order_vertices(
	const struct optimize_order *order, int accessor);

/* The new indices of an accessor of indices; NULL: it keeps its own. */
const uint32_t *optimize_order_list(
	const struct optimize_order *order, int accessor);

#endif
