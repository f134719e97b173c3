/*
 * The state of a skeleton at one moment.
 *
 * A pose holds each node's transform relative to its parent and every morph
 * weight. It is what clips are sampled into, what blends and procedural bones
 * change, and what world matrices and palettes are computed from.
 */
#ifndef APP_ANIM_POSE_H
#define APP_ANIM_POSE_H

#include "app/model/model.h"

struct pose {
	const struct model *model; /* whose pose it is; not owned */
	int node_count;
	struct transform *local; /* [node_count], the model's node order */
	bool *animated;          /* [node_count]: a clip set it, so a node's
				    matrix no longer counts */
	int weight_count;
	float *weight; /* [weight_count], see model_node.weight_offset */
};

/* Room in the arena for a pose of this model, at rest. 0 or -ENOMEM. */
int pose_init(struct pose *pose, const struct model *model, struct arena *arena);

/* Puts every node and weight back to the file's rest values. */
void pose_rest(struct pose *pose, const struct model *model);

/* to = from, the contents and not the pointers; both of the same model. */
void pose_copy(struct pose *to, const struct pose *from);

/*
 * One pass from parents to children: world[i] = world[parent] * local[i].
 * root is put before the nodes without a parent (NULL: identity).
 */
void pose_world(const struct pose *pose, const struct model *model, mat4 root,
	mat4 *world);

/*
 * The same for node first and all behind it, after a change to first's local
 * transform or its descendants'. What comes before first is read from world.
 */
void pose_world_from(const struct pose *pose, const struct model *model,
	mat4 root, int first, mat4 *world);

/*
 * The matrices that carry bind-pose vertices to their places: palette[j] =
 * world[joint j] * inverse_bind[j]. The skinned node's own transform does not
 * count (glTF 2.0, 3.7.3.3).
 */
void pose_palette(
	const struct model_skin *skin, const mat4 *world, mat4 *palette);

#endif
