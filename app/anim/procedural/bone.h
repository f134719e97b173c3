/*
 * Changes to single bones, which the procedural effects share.
 *
 * world[node_count] are the matrices that pose_world() made from the pose. A
 * function that changes a bone does not update them: the caller calls
 * pose_world_from().
 */
#ifndef APP_ANIM_PROCEDURAL_BONE_H
#define APP_ANIM_PROCEDURAL_BONE_H

#include "app/anim/pose.h"

/*
 * Writes the world rotation of the node's parent, or the identity if the node
 * has none. If the parent mirrors, its matrix is this rotation after a mirror
 * of z (matrix_rotation()).
 */
void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4]);

/* Whether the matrix of the node's parent mirrors. */
bool bone_is_mirrored(const struct pose *pose, const mat4 *world, int node);

/*
 * Below a parent that mirrors, converts a local rotation to the one that has
 * the same effect after the parent's rotation alone, or back: both are the same
 * conversion. Otherwise the rotation stays.
 */
static inline void bone_mirror_rotation(bool mirrored, float rotation[4])
{
	if (mirrored) {
		rotation[0] = -rotation[0];
		rotation[1] = -rotation[1];
	}
}

/*
 * Converts a direction in the world to a node's own axes; its length stays.
 * Node -1 is the world itself.
 */
void bone_to_axes(
	const mat4 *world, int node, const float direction[3], float out[3]);

/*
 * Applies a rotation in world axes to a node. weight, 0..1, interpolates
 * between the present rotation and the result.
 */
void bone_turn_world(struct pose *pose, const mat4 *world, int node,
	const float turn[4], float weight);

/*
 * Rotates a node so that its world rotation becomes the given one. weight,
 * 0..1, interpolates between the present rotation and the result.
 */
void bone_set_world_rotation(struct pose *pose, const mat4 *world, int node,
	const float rotation[4], float weight);

/*
 * Fills node[count] with tip and its ancestors, each the parent of the next;
 * tip comes last. Returns false if tip is no node or has too few ancestors.
 */
bool bone_chain(const struct model *model, int tip, int count, int *node);

/*
 * Multiplies a node's scale by a factor for each axis and divides its
 * children's scale by it, so that only the vertices of the node itself grow. If
 * a child is rotated against the node, each axis of the child is divided by
 * what the factors stretch it by, which leaves a little shear.
 */
void bone_swell(struct pose *pose, int node, const float factor[3]);

#endif
