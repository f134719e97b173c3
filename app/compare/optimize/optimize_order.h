/*
 * Puts triangles into the order in which a vertex cache serves them best,
 * unless they are blended, and vertices into the order in which the triangles
 * first need them.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_ORDER_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_ORDER_H

#include "app/model/gltf/document/gltf_document.h"

#include <stdbool.h>

/*
 * A group is all primitives that have the same attributes and targets, such as
 * the levels of detail of a mesh. A group that shares an accessor with another
 * group, and one with anything but lists of triangles, is fixed: it keeps its
 * order.
 */
struct optimize_group {
	bool fixed;
	int vertex_count; /* in the file */
	int used_count;   /* vertices that a triangle uses */
	uint32_t *source; /* [used_count]: the vertex's number in the file */
	uint32_t *rename; /* [vertex_count]: new number + 1; 0: not used */
};

struct optimize_order {
	const struct gltf_document *document;
	json_t *by_key; /* attributes and targets as text: the group's number */
	int count;
	struct optimize_group *group;
	int *of_vertices,
		*of_list; /* [accessors]: a group's number, or below 0 */
	uint32_t **list;  /* [accessors]: new lists, or NULL */
	bool *blended; /* [accessors]: lists that keep their triangles' order */
	bool *renamed; /* [accessors]: lists that are complete */
};

/*
 * Finds the order of all accessors. Returns 0 or -ENOMEM; the caller calls
 * optimize_order_release() in either case.
 */
int optimize_order_find(
	struct optimize_order *order, const struct gltf_document *document);

void optimize_order_release(struct optimize_order *order);

/* The group whose vertices the accessor belongs to; NULL: keep the order. */
const struct optimize_group *optimize_order_vertices(
	const struct optimize_order *order, int accessor);

/* The new list of triangles; NULL: keep the list. */
const uint32_t *optimize_order_list(
	const struct optimize_order *order, int accessor);

#endif
