/*
 * The pose of a skeleton at one moment.
 *
 * A pose holds each node's transform relative to its parent and every morph
 * weight. Clips are sampled into it, blends and procedural bones change it, and
 * world matrices and palettes are computed from it.
 */
#ifndef APP_ANIM_POSE_H
#define APP_ANIM_POSE_H

#include "app/model/model.h"

#include <string.h>

struct pose {
	const struct model *model; /* not owned */
	int node_count;
	int root_end;   /* all nodes from this index on have a parent */
	int matrix_end; /* no node from this index on has a matrix */
	struct transform *local; /* [node_count], in the order of model.node */
	bool *animated;          /* [node_count]: whether local[] was changed,
				    so that the node's matrix in the file is
				    ignored */
	int weight_count;
	float *weight;     /* [weight_count], see model_node.weight_offset */
	size_t size_bytes; /* of all three arrays, one block that begins at
			      local */
};

/* Makes a pose at rest, with arrays in the arena. Returns 0 or -ENOMEM. */
int pose_init(struct pose *pose, const struct model *model, struct arena *arena);

/* Resets every node and weight to the file's rest values. */
void pose_rest(struct pose *pose, const struct model *model);

/* Copies the contents of a pose to another one of the same model. */
static inline void pose_copy(struct pose *to, const struct pose *from)
{
	memcpy(to->local, from->local, from->size_bytes);
}

/*
 * Computes world[i] = world[parent] * local[i] for all nodes, parents first.
 * Nodes without a parent use root instead of world[parent] (NULL: the
 * identity).
 */
void pose_world(const struct pose *pose, const struct model *model, mat4 root,
	mat4 *world);

/*
 * The same for the nodes with index first and above, after a change to the
 * local transforms of first or its descendants. The matrices below first must
 * be up to date.
 */
void pose_world_from(const struct pose *pose, const struct model *model,
	mat4 root, int first, mat4 *world);

/*
 * The matrices that transform vertices from the bind pose to the world:
 * palette[j] = world[joint j] * inverse_bind[j]. The transform of the node that
 * has the skin is ignored (glTF 2.0, 3.7.3.3).
 */
void pose_palette(
	const struct model_skin *skin, const mat4 *world, mat4 *palette);

#endif
