/*
 * The two bakes as glTF: what export.c writes to files.
 */
#ifndef APP_COMPARE_EXPORT_EXPORT_BAKE_H
#define APP_COMPARE_EXPORT_EXPORT_BAKE_H

#include "app/compare/candidate.h"
#include "app/compare/export/glb.h"

/*
 * One node with the first key frame as base and the others as targets, and a
 * clip that fades from each to the next.
 */
void export_morph(struct glb *glb, const struct reference *reference,
	const int *key, int key_count);

/* The model's nodes and clip, with a rigid part below each that carries one. */
void export_rigid(struct glb *glb, const struct rigid *rigid);

/*
 * The look of a part: attributes of vertex_count vertices, source[v] (NULL: v)
 * being the number of each in the primitive.
 */
void export_attributes(struct glb *glb, json_t *attributes,
	const struct model_primitive *primitive, int vertex_count,
	const int *source);

/* The array's number under that name. */
void export_attribute(json_t *attributes, const char *name, int accessor);

#endif
