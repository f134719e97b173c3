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
 * has none.
 */
void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4]);

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
