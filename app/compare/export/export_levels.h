/*
 * Levels of detail in an exported file, as MSFT_lod: each level is a mesh that
 * shares all but its indices with the full mesh, and a node that shows this
 * mesh (app/model/gltf/README.md).
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_LEVELS_H
#define APP_COMPARE_EXPORT_EXPORT_LEVELS_H

#include "app/compare/export/glb.h"
#include "app/model/model.h"

/* The triangle lists of one primitive. */
struct export_lists {
	int index_count; /* of the full triangle list */
	int lod_count;
	const struct model_lod *lod;
	float scale;   /* from units of lod[].error_m to units of the file */
	bool mirrored; /* the file needs the opposite winding */
};

/*
 * Adds triangle indices of 16 or 32 bits, with reversed winding if mirrored.
 * Returns the accessor's index or -1.
 */
int export_triangles(
	struct glb *glb, const uint32_t *index, int count, bool mirrored);

/*
 * Appends to meshes the level meshes of meshes[mesh], once all full meshes are
 * in it, and appends a description of each to levels, for export_level_nodes().
 * lists has an element for each primitive of the mesh. A level that saves less
 * than a fifth of the triangles is left out. If more levels remain than the
 * loader reads, those that save least are left out, too.
 */
void export_level_meshes(struct glb *glb, json_t *meshes, int mesh,
	const struct export_lists *lists, json_t *levels);

/*
 * Appends a node for each level of each node's mesh. It is a copy of the node
 * without its children, so all other members of the nodes must be set.
 */
void export_level_nodes(struct glb *glb, json_t *nodes, const json_t *meshes,
	const json_t *levels);

#endif
