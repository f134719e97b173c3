/*
 * Inverse kinematics: rotates bones so that their end reaches a point in the
 * world.
 *
 * Both solvers change local rotations of a pose and start from the present
 * ones, so that the result stays close to the animation. world has the pose's
 * matrices from before the call; those of the first bone and its descendants
 * are out of date after it, and the caller calls pose_world_from(). Unreachable
 * and degenerate targets give the nearest pose and never a NaN.
 */
#ifndef APP_ANIM_PROCEDURAL_IK_H
#define APP_ANIM_PROCEDURAL_IK_H

#include "app/anim/pose.h"

/* An arm or a leg. Each node is a descendant of the one before. */
struct ik_limb {
	int upper, lower, tip; /* shoulder, elbow and hand */
	float weight;          /* 0: as animated, 1: on the target */
};

/*
 * Solves exactly, by the law of cosines. The middle joint bends towards pole, a
 * point in the world; with NULL it keeps the direction of its bend. Returns the
 * distance that weight 1 leaves between tip and target, in the world's unit.
 */
float ik_limb_solve(const struct ik_limb *limb, const float target[3],
	const float pole[3], const mat4 *world, struct pose *pose);

enum {
	IK_CHAIN_MAX = 16
};

/* A chain of any length: a tail, a spine, an arm with its collar bone. */
struct ik_chain {
	int count;                     /* number of nodes with the tip;
					2..IK_CHAIN_MAX */
	int node[IK_CHAIN_MAX];        /* each the parent of the next */
	float limit_rad[IK_CHAIN_MAX]; /* the largest angle from the rest
					  rotation; 0 or less: no limit */
	int iterations;                /* the largest number of them */
	float tolerance; /* the distance at which it stops, in the world's unit */
	float weight;    /* 0: as animated, 1: on the target */
};

/*
 * Makes the chain of count nodes that ends at tip: no limits, 32 iterations,
 * tolerance 0.0005, weight 1. Returns 0, or -EINVAL if tip has too few
 * ancestors or count is out of range.
 */
int ik_chain_init(
	struct ik_chain *chain, const struct model *model, int tip, int count);

/*
 * Solves by FABRIK (Aristidou and Lasenby, 2011), which spreads the bend over
 * all joints, and applies the limits in each iteration. Returns the distance
 * that weight 1 leaves between tip and target, in the world's unit.
 */
float ik_chain_solve(const struct ik_chain *chain, const float target[3],
	const mat4 *world, struct pose *pose);

#endif
