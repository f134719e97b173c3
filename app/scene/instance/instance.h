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
 * -EINTR (base/interrupt.h), or -ENOMEM after logging an error. Release it with
 * instance_destroy().
 */
int instance_create(const struct model *model, const struct kernel *kernel,
	const struct log *log, struct instance **out);

/*
 * The same for an instance that is only drawn: updates do not pose skinned
 * vertices that no chosen level of detail uses. Bounds are those of posed
 * vertices, and the caller must not read others. After lod_choose(),
 * instance_is_stale() says whether another update is needed.
 */
int instance_create_for_drawing(const struct model *model,
	const struct kernel *kernel, const struct log *log,
	struct instance **out);

struct instance_options {
	bool drawn_vertices_only; /* as instance_create_for_drawing() does */
	/*
	 * The unit_scale of another instance of the model; 0 if it is not
	 * known. All clips of a model without a size at rest are posed to find
	 * it, so a caller that creates an instance for each clip finds it once.
	 */
	float unit_scale;
};

/* As instance_create(), with options. */
int instance_create_with(const struct model *model, const struct kernel *kernel,
	const struct instance_options *options, const struct log *log,
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
 * Returns true if the last update left out vertices that would be drawn now,
 * because a finer level of detail was chosen since. This happens only after
 * instance_create_for_drawing().
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

/* Returns true if the pose reverses the winding of a drawable's triangles. */
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
