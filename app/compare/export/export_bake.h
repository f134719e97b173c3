/*
 * Converts the rows of a comparison to glTF: key frames, rigid parts, and
 * skins. export.c writes the files. Errors of writing are kept in glb->error.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_BAKE_H
#define APP_COMPARE_EXPORT_EXPORT_BAKE_H

#include "app/compare/candidate/candidate_rigid.h"
#include "app/compare/comparison.h"
#include "app/compare/export/glb.h"

/*
 * Adds one node, whose mesh has the key frames of all clips as morph targets,
 * and for each clip an animation that blends from each of its keys to the next.
 * It poses one key at a time. Returns 0, or -errno after logging an error;
 * errors of glb stay in glb->error.
 */
int export_morph(struct glb *glb, const struct comparison *comparison,
	const struct comparison_row *row, const struct log *log);

/* Adds the nodes and all clips. A node that moves parts has a mesh of them. */
void export_rigid(struct glb *glb, const struct rigid_bake *rigid,
	const struct comparison *comparison);

/*
 * Adds the model with at most max_influences a vertex (0: all), and with or
 * without its morph targets.
 */
void export_skin(struct glb *glb, const struct comparison *comparison,
	int max_influences, bool targets);

/*
 * Puts the nodes of the scene below one that moves them to where the model is in
 * its file, if that is far from the origin. Call it when all nodes were added.
 */
void export_origin(struct glb *glb, const struct model *model);

/*
 * Adds the model's nodes. mesh[node] is the index of the node's mesh, or -1; if
 * skins is true, nodes keep their skins, and if targets is true, the weights of
 * their targets at rest. Adds the scene with its root nodes, and the nodes of
 * levels (export_levels.h), so the meshes must have been added. If skins is
 * false, all roots are in the scene, because meshes hang on joints then, whose
 * roots need not be in the model's scene.
 */
void export_nodes(struct glb *glb, const struct model *model, const int *mesh,
	bool skins, bool targets, const json_t *levels);

/* Adds the comparison's clips; weights of targets only if targets is true. */
void export_clips(
	struct glb *glb, const struct comparison *comparison, bool targets);

/*
 * Adds the texture coordinates and colours of vertex_count vertices. source[v]
 * is the primitive's vertex that vertex v copies; NULL means v itself.
 */
void export_attributes(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int vertex_count,
	const int *source);

/*
 * Adds triangle indices of 16 or 32 bits. Returns the accessor or -1. Without
 * any index it adds a triangle of one vertex, as glTF has no empty lists.
 */
int export_indices(struct glb *glb, const uint32_t *index, int count);

/* Sets an attribute to the index of its accessor. */
void export_attribute(json_t *attributes, const char *name, int accessor);

/* Adds materials, textures and images, in the order of the model. */
void export_materials(struct glb *glb, const struct model *model);

#endif
