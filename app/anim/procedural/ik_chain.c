#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/anim/procedural/ik.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

/* An attempt at a solution: rotations and the positions that they give. */
struct solver {
	int bones;
	const struct ik_chain *chain;
	const struct pose *pose;
	float root[4];                /* world rotation of the first parent */
	bool mirrored;                /* the first parent mirrors */
	float local[IK_CHAIN_MAX][4]; /* local rotations as
					 bone_mirror_rotation() makes them */
	float bone[IK_CHAIN_MAX][3];  /* vector to the next joint, in the bone's
					 own axes */
	float length[IK_CHAIN_MAX];
	float total;
	float joint[IK_CHAIN_MAX][3];   /* positions in the world */
	float reached[IK_CHAIN_MAX][3]; /* positions after FABRIK's backward
					   pass */
};

int ik_chain_init(
	struct ik_chain *chain, const struct model *model, int tip, int count)
{
	*chain = (struct ik_chain){
		.count = count,
		.iterations = 32,
		.tolerance = 0.0005f,
		.weight = 1,
	};
	return count >= 2 && count <= IK_CHAIN_MAX &&
			bone_chain(model, tip, count, chain->node)
		? 0
		: -EINVAL;
}

static void begin(struct solver *solver, const struct ik_chain *chain,
	const mat4 *world, const struct pose *pose)
{
	solver->bones = chain->count - 1;
	solver->chain = chain;
	solver->pose = pose;
	solver->total = 0;
	bone_parent_rotation(pose, world, chain->node[0], solver->root);
	solver->mirrored = bone_is_mirrored(pose, world, chain->node[0]);
	for (int i = 0; i < chain->count; i++) {
		memcpy(solver->joint[i], world[chain->node[i]][3],
			sizeof(solver->joint[i]));
		memcpy(solver->local[i], pose->local[chain->node[i]].rotation,
			sizeof(solver->local[i]));
		bone_mirror_rotation(solver->mirrored, solver->local[i]);
	}
	for (int i = 0; i < solver->bones; i++) {
		float rotation[4];

		bone_parent_rotation(pose, world, chain->node[i + 1], rotation);
		quat_conjugate(rotation, rotation);
		vec_subtract(solver->joint[i + 1], solver->joint[i],
			solver->bone[i]);
		quat_rotate(rotation, solver->bone[i], solver->bone[i]);
		solver->length[i] = vec_length(solver->bone[i]);
		solver->total += solver->length[i];
	}
}

static float distance_left(const struct solver *solver, const float target[3])
{
	float offset[3];

	vec_subtract(target, solver->joint[solver->bones], offset);
	return vec_length(offset);
}

/* FABRIK's backward pass: from the target to the root. */
static void reach_backward(struct solver *solver, const float target[3])
{
	memcpy(solver->reached[solver->bones], target, sizeof(float[3]));
	for (int i = solver->bones - 1; i >= 0; i--) {
		float offset[3];

		vec_subtract(solver->joint[i], solver->reached[i + 1], offset);
		vec_normalize(offset);
		vec_add_scaled(solver->reached[i + 1], offset,
			solver->length[i], solver->reached[i]);
	}
}

/* Sets a joint's rotation, given in world axes, within its limit. */
static void set_joint(struct solver *solver, int i, const float parent[4],
	const float world[4])
{
	float *local = solver->local[i];
	float limit_rad = solver->chain->limit_rad[i];
	int node = solver->chain->node[i];
	float back[4], rest[4];

	quat_conjugate(parent, back);
	quat_multiply(back, world, local);
	quat_normalize(local);
	if (limit_rad > 0) {
		memcpy(rest, solver->pose->model->node[node].rest.rotation,
			sizeof(rest));
		bone_mirror_rotation(solver->mirrored, rest);
		quat_limit(local, rest, limit_rad);
	}
}

/*
 * Computes this joint's world rotation and the next joint's position, given the
 * world rotation of the parent.
 */
static void place_next(
	struct solver *solver, int i, const float parent[4], float world[4])
{
	float bone[3];

	quat_multiply(parent, solver->local[i], world);
	quat_normalize(world);
	quat_rotate(world, solver->bone[i], bone);
	vec_add_scaled(solver->joint[i], bone, 1, solver->joint[i + 1]);
}

/* FABRIK's forward pass: rotates the joints towards reached[]. */
static void reach_forward(struct solver *solver)
{
	float above[4];

	memcpy(above, solver->root, sizeof(above));
	for (int i = 0; i < solver->bones; i++) {
		float world[4], turn[4], now[3], wanted[3];

		quat_multiply(above, solver->local[i], world);
		quat_rotate(world, solver->bone[i], now);
		vec_subtract(solver->reached[i + 1], solver->joint[i], wanted);
		quat_between(now, wanted, turn);
		quat_multiply(turn, world, world);
		set_joint(solver, i, above, world);
		place_next(solver, i, above, world);
		memcpy(above, world, sizeof(above));
	}
}

/* Turns one joint in world axes and moves the rest of the chain along. */
static void turn_joint(struct solver *solver, int turned, const float turn[4])
{
	float above[4];

	memcpy(above, solver->root, sizeof(above));
	for (int i = 0; i < solver->bones; i++) {
		float world[4];

		if (i == turned) {
			quat_multiply(above, solver->local[i], world);
			quat_multiply(turn, world, world);
			set_joint(solver, i, above, world);
		}
		place_next(solver, i, above, world);
		memcpy(above, world, sizeof(above));
	}
}

/*
 * Treats the parts of the chain before and after a joint as two rigid bones:
 * bends the joint until the tip is as far away as the target, by the law of
 * cosines, and rotates the whole chain onto the target.
 */
static void close_triangle(struct solver *solver, int bent, const float goal[3])
{
	float before[3], behind[3], offset[3], axis[3], turn[4];
	float a, b, distance, now, wanted;

	vec_subtract(solver->joint[0], solver->joint[bent], before);
	vec_subtract(solver->joint[solver->bones], solver->joint[bent], behind);
	vec_subtract(goal, solver->joint[0], offset);
	vec_cross(before, behind, axis);
	a = vec_length(before);
	b = vec_length(behind);
	distance = vec_length(offset);
	if (vec_normalize(axis) == 0 || !(a * b > 0)) {
		return;
	}
	now = scalar_acos(vec_dot(before, behind) / (a * b));
	wanted = scalar_acos(
		(a * a + b * b - distance * distance) / (2 * a * b));
	quat_from_axis_angle(axis, wanted - now, turn);
	turn_joint(solver, bent, turn);
	vec_subtract(solver->joint[solver->bones], solver->joint[0], behind);
	quat_between(behind, offset, turn);
	turn_joint(solver, 0, turn);
}

/*
 * If the chain is straight and points at the target, moves its joints aside:
 * FABRIK would leave them on the line.
 */
static void buckle(struct solver *solver, const float target[3])
{
	float line[3], side[3], offset[3];
	float least[3] = {0, 0, 0};
	float widest = 0;

	vec_subtract(target, solver->joint[0], line);
	if (vec_normalize(line) == 0) {
		memcpy(line, solver->bone[0], sizeof(line));
		vec_normalize(line);
	}
	for (int i = 1; i <= solver->bones; i++) {
		vec_subtract(solver->joint[i], solver->joint[0], offset);
		vec_cross(offset, line, side);
		widest = vec_length(side) > widest ? vec_length(side) : widest;
	}
	if (widest > 1e-3f * solver->total) {
		return;
	}
	least[scalar_abs(line[0]) < 0.6f ? 0 : 1] = 1;
	vec_cross(line, least, side);
	vec_normalize(side);
	for (int i = 1; i < solver->bones; i++) {
		vec_add_scaled(solver->joint[i], side, 0.1f * solver->length[i],
			solver->joint[i]);
	}
}

/*
 * Writes the target or, if it is out of reach, the point in its direction at
 * the length of the chain. Returns true if only a straight chain reaches that.
 */
static bool bring_near(
	const struct solver *solver, const float target[3], float out[3])
{
	float offset[3];
	float distance;

	vec_subtract(target, solver->joint[0], offset);
	distance = vec_normalize(offset);
	memcpy(out, target, sizeof(offset));
	if (distance < 0.99999f * solver->total) {
		return false;
	}
	vec_add_scaled(solver->joint[0], offset, solver->total, out);
	return true;
}

/* Puts reached[] on the straight line to the target. */
static void stretch(struct solver *solver, const float target[3])
{
	float offset[3];

	vec_subtract(target, solver->joint[0], offset);
	vec_normalize(offset);
	memcpy(solver->reached[0], solver->joint[0], sizeof(offset));
	for (int i = 0; i < solver->bones; i++) {
		vec_add_scaled(solver->reached[i], offset, solver->length[i],
			solver->reached[i + 1]);
	}
}

static void store(const struct solver *solver, struct pose *pose)
{
	const struct ik_chain *chain = solver->chain;

	for (int i = 0; i < solver->bones; i++) {
		float *local = pose->local[chain->node[i]].rotation;
		float goal[4];

		memcpy(goal, solver->local[i], sizeof(goal));
		bone_mirror_rotation(solver->mirrored, goal);
		quat_slerp(local, goal, chain->weight, local);
		quat_normalize(local);
		pose->animated[chain->node[i]] = true;
	}
}

/* Keeps the candidate if its tip is nearer to the target than least. */
static void keep_best(const struct solver *candidate, const float target[3],
	struct solver *best, float *least)
{
	float now = distance_left(candidate, target);

	if (now < *least) {
		*least = now;
		*best = *candidate;
	}
}

/*
 * Tries close_triangle() with each joint and keeps the best result. This helps
 * where FABRIK converges slowly: if the chain is nearly straight or folded, or
 * at a limit.
 */
static void close_gap(const float goal[3], const float target[3],
	struct solver *best, float *least)
{
	struct solver start = *best;

	for (int bent = 1; bent < start.bones; bent++) {
		struct solver candidate = start;

		close_triangle(&candidate, bent, goal);
		keep_best(&candidate, target, best, least);
	}
}

float ik_chain_solve(const struct ik_chain *chain, const float target[3],
	const mat4 *world, struct pose *pose)
{
	struct solver solver;
	struct solver best;
	float goal[3];
	float least;
	bool far;

	begin(&solver, chain, world, pose);
	best = solver;
	least = distance_left(&solver, target);
	if (!(solver.total > 1e-9f)) {
		return least;
	}
	far = bring_near(&solver, target, goal);
	if (!far && least > chain->tolerance) {
		buckle(&solver, goal);
	}
	for (int n = 0; n < chain->iterations; n++) {
		if (distance_left(&best, goal) <= chain->tolerance) {
			break;
		}
		if (far && n == 0) {
			stretch(&solver, goal);
		} else {
			reach_backward(&solver, goal);
		}
		reach_forward(&solver);
		keep_best(&solver, target, &best, &least);
		if (n % 8 == 7) {
			close_gap(goal, target, &best, &least);
			solver = best;
		}
	}
	store(&best, pose);
	return least;
}
