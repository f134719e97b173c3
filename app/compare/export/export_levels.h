/*
 * Levels of detail in an exported file, as MSFT_lod: meshes that share all but
 * their indices with the full mesh, and a node for each (app/model/gltf/README.md).
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_LEVELS_H
#define APP_COMPARE_EXPORT_EXPORT_LEVELS_H

#include "app/compare/export/glb.h"
#include "app/model/model.h"

/* The triangle lists of one primitive. */
struct export_lists {
	int index_count; /* of the full list */
	int lod_count;
	const struct model_lod *lod;
	float scale;   /* from the unit of its errors to that of the file */
	bool mirrored; /* triangles are turned round in the file */
};

/*
 * Adds a list of triangles, turned round if mirrored, with 16 or 32 bits an
 * index. Returns the accessor's number or -1.
 */
int export_triangles(
	struct glb *glb, const uint32_t *index, int count, bool mirrored);

/*
 * Appends the level meshes of the mesh with this number, behind all full
 * meshes, and what is known of them to levels, for export_level_nodes(). lists
 * has an element for each of its primitives. A level that saves less than a
 * fifth of the triangles is left out, and of more than the loader reads those
 * that save least.
 */
void export_level_meshes(struct glb *glb, json_t *meshes, int mesh,
	const struct export_lists *lists, json_t *levels);

/*
 * Appends a node for each level of each node's mesh, once all else of the nodes
 * that a level shares is set. Children are no part of it.
 */
void export_level_nodes(struct glb *glb, json_t *nodes, const json_t *meshes,
	const json_t *levels);

#endif
