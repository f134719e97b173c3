/*
 * Turning bones in world terms: what the constraints share.
 *
 * World matrices go with a pose: they are what pose_world() last made of it.
 * Functions that change a bone leave the matrices of its descendants for the
 * caller's pose_world_from().
 */
#ifndef APP_ANIM_PROCEDURAL_BONE_H
#define APP_ANIM_PROCEDURAL_BONE_H

#include "app/anim/pose.h"

/* The rotation of the node's parent in the world; identity without one. */
void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4]);

/*
 * Turns a node's local rotation by a rotation given in world axes, slerped by
 * weight.
 */
void bone_turn_world(struct pose *pose, const mat4 *world, int node,
	const float turn[4], float weight);

/* Turns a node so that its world rotation becomes that, slerped by weight. */
void bone_set_world_rotation(struct pose *pose, const mat4 *world, int node,
	const float rotation[4], float weight);

/* How far a matrix scales, by its first column; for even scales. */
float matrix_scale(const mat4 *matrix);

/*
 * Limits the angle between a unit rotation and a base to limit_rad, keeping
 * the axis. True when it had to.
 */
bool quat_limit(float q[4], const float base[4], float limit_rad);

#endif
