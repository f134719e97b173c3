/*
 * Creates and updates instances; instance_data.h describes their data.
 *
 * instance_create() allocates all memory; posing and drawing allocate none.
 */
#ifndef APP_SCENE_INSTANCE_INSTANCE_H
#define APP_SCENE_INSTANCE_INSTANCE_H

#include "app/scene/instance/instance_data.h"

/*
 * Creates an instance in the rest pose. The model must outlive it. Returns 0,
 * or -ENOMEM after logging an error. Release it with instance_destroy().
 */
int instance_create(const struct model *model, const struct kernel *kernel,
	const struct log *log, struct instance **out);

/*
 * The same for an instance that is only drawn: updates leave out skinned
 * vertices that the drawables' lods do not draw. So nothing but the chosen
 * lists may be read: no bounds, no single vertices. After lod_choose() see
 * instance_is_stale().
 */
int instance_create_for_drawing(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out);

/* Frees the instance; NULL is allowed. */
void instance_destroy(struct instance *instance);

/* Returns true if a drawable's last pose did not fit 16 bits. */
bool instance_overflowed(const struct instance *instance);

/*
 * Does a frame's work: computes world matrices, palettes and output vertices
 * from the pose. Allocates nothing.
 */
void instance_update(struct instance *instance);

/*
 * Whether the last update left out vertices that are drawn by now, because
 * the instance is only drawn and a finer level was chosen since.
 */
bool instance_is_stale(const struct instance *instance);

/*
 * Makes a float drawable that is not skinned show the caller's vertices:
 * positions in local units times vertex_scale, and normals if the primitive has
 * them, in the primitive's order. The arrays are not copied; they are read at
 * each draw.
 */
void instance_use_vertices(
	struct drawable *drawable, float (*position)[3], float (*normal)[3]);

/* Computes only the world matrices from the pose. */
void instance_update_nodes(struct instance *instance);

/* Returns the origin of a node after the last update, in scene units. */
void instance_node_position(
	const struct instance *instance, int node, float out[3]);

/*
 * Returns the matrix from a rigid drawable's drawable_position() to scene units.
 */
void instance_drawable_matrix(const struct instance *instance,
	const struct drawable *drawable, mat4 out);

/* Whether a drawable's triangles wind the other way than in the file. */
bool instance_is_mirrored(
	const struct instance *instance, const struct drawable *drawable);

/*
 * Returns the posed position of the primitive's vertex in world space, in the
 * model's units.
 */
void instance_world_vertex(const struct instance *instance,
	const struct drawable *drawable, int vertex, float out[3]);

/* Returns the name of the instance's technique, such as "Skeletal". */
const char *instance_technique(const struct instance *instance);

#endif
