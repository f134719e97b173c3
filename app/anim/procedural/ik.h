/*
 * Inverse kinematics: bones that put their end on a point in the world.
 *
 * Both solvers change local rotations of a pose, starting from what is there,
 * so that they follow the animation where it already does well. world are the
 * pose's matrices before the change; those of the first bone and everything
 * behind it are out of date afterwards: pose_world_from(). Unreachable and
 * degenerate targets give the nearest pose and never a NaN.
 */
#ifndef APP_ANIM_PROCEDURAL_IK_H
#define APP_ANIM_PROCEDURAL_IK_H

#include "app/anim/pose.h"

/* An arm or a leg: shoulder, elbow and hand, each below the one before. */
struct ik_limb {
	int upper, lower, tip;
	float weight; /* 0: as animated, 1: on the target */
};

/*
 * Solves exactly. The joint in the middle bends towards the pole, a point in
 * the world; NULL: the way it is bent now. Returns how far the tip stays from
 * the target at weight 1.
 */
float ik_limb_solve(const struct ik_limb *limb, const float target[3],
	const float pole[3], const mat4 *world, struct pose *pose);

enum {
	IK_CHAIN_MAX = 16
};

/* A tail, a spine, an arm with its collar bone. */
struct ik_chain {
	int count;              /* nodes, the tip included; 2..IK_CHAIN_MAX */
	int node[IK_CHAIN_MAX]; /* each the parent of the next */
	float limit_rad[IK_CHAIN_MAX]; /* how far each may turn from its rest
					  rotation; 0 or less: freely */
	int iterations;                /* at most */
	float tolerance;               /* good enough, in the world's unit */
	float weight;
};

/*
 * The chain of count nodes that ends at tip, without limits, at most 32
 * iterations, tolerance 0.0005, weight 1. 0, or -EINVAL when tip has too few
 * ancestors or count is out of range.
 */
int ik_chain_init(
	struct ik_chain *chain, const struct model *model, int tip, int count);

/*
 * Solves by FABRIK (forward and backward reaching), which bends all joints a
 * little, with the limits applied on the way. Returns how far the tip stays
 * from the target at weight 1.
 */
float ik_chain_solve(const struct ik_chain *chain, const float target[3],
	const mat4 *world, struct pose *pose);

#endif
