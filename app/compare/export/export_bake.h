/*
 * Converts the two kinds of baked candidates to glTF. export.c writes the
 * files.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_BAKE_H
#define APP_COMPARE_EXPORT_EXPORT_BAKE_H

#include "app/compare/candidate_rigid.h"
#include "app/compare/export/glb.h"

/*
 * Adds one node, whose mesh has the first key frame as base and the others as
 * targets, and a clip that blends from each key to the next.
 */
void export_morph(struct glb *glb, const struct reference *reference,
	const int *key, int key_count);

/*
 * Adds the nodes and the clip; each part is a child of the node that moves it.
 */
void export_rigid(struct glb *glb, const struct rigid_bake *rigid);

/*
 * Adds the texture coordinates and colours of vertex_count vertices. source[v]
 * is the vertex of the primitive that v was made from; NULL means v.
 */
void export_attributes(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int vertex_count,
	const int *source);

/* Sets an attribute to the number of its accessor. */
void export_attribute(json_t *attributes, const char *name, int accessor);

/* Adds materials, textures and images, with the numbers that the model uses. */
void export_materials(struct glb *glb, const struct model *model);

#endif
