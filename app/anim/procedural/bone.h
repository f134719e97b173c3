/*
 * Changes to single bones, shared by the procedural effects.
 *
 * The world matrices that a function takes are those that pose_world() last
 * made of the pose. A function that changes a bone does not update them: the
 * caller calls pose_world_from().
 */
#ifndef APP_ANIM_PROCEDURAL_BONE_H
#define APP_ANIM_PROCEDURAL_BONE_H

#include "app/anim/pose.h"

/* The world rotation of the node's parent; the identity if it has none. */
void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4]);

/*
 * Rotates a node by a rotation given in world axes, interpolated by weight,
 * 0..1.
 */
void bone_turn_world(struct pose *pose, const mat4 *world, int node,
	const float turn[4], float weight);

/*
 * Rotates a node so that its world rotation becomes the given one, interpolated
 * by weight, 0..1.
 */
void bone_set_world_rotation(struct pose *pose, const mat4 *world, int node,
	const float rotation[4], float weight);

/*
 * Fills node[] with the count nodes that end at tip, each the parent of the
 * next. False if tip is no node or has too few ancestors.
 */
bool bone_chain(const struct model *model, int tip, int count, int *node);

/*
 * Multiplies a node's scale by a factor for each axis and divides its
 * children's scale by it, so that only the vertices of the node itself grow. A
 * child that is rotated against the node gets the factor of its own axes back,
 * which leaves a little shear.
 */
void bone_swell(struct pose *pose, int node, const float factor[3]);

#endif
