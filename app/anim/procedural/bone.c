#include "app/anim/procedural/bone.h"

#include "app/anim/transform.h"
#include "platform/base/scalar.h"

#include <string.h>

static const float IDENTITY[4] = {0, 0, 0, 1};

void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4])
{
	int parent = pose->model->node[node].parent;

	if (parent < 0) {
		memcpy(out, IDENTITY, sizeof(IDENTITY));
		return;
	}
	matrix_rotation(((mat4 *)world)[parent], out);
}

/* local becomes parent^-1 * rotation, slerped from what it is. */
static void set_rotation(struct pose *pose, int node, const float parent[4],
	const float rotation[4], float weight)
{
	float *local = pose->local[node].rotation;
	float goal[4];

	quat_conjugate(parent, goal);
	quat_multiply(goal, rotation, goal);
	if (weight < 1) {
		quat_slerp(local, goal, weight, goal);
	}
	quat_normalize(goal);
	memcpy(local, goal, sizeof(goal));
	pose->animated[node] = true;
}

void bone_turn_world(struct pose *pose, const mat4 *world, int node,
	const float turn[4], float weight)
{
	float parent[4], rotation[4];

	bone_parent_rotation(pose, world, node, parent);
	quat_multiply(parent, pose->local[node].rotation, rotation);
	quat_multiply(turn, rotation, rotation);
	set_rotation(pose, node, parent, rotation, weight);
}

void bone_set_world_rotation(struct pose *pose, const mat4 *world, int node,
	const float rotation[4], float weight)
{
	float parent[4];

	bone_parent_rotation(pose, world, node, parent);
	set_rotation(pose, node, parent, rotation, weight);
}

float matrix_scale(const mat4 *matrix)
{
	return vec_length((*matrix)[0]);
}

bool quat_limit(float q[4], const float base[4], float limit_rad)
{
	float turn[4];
	float angle;

	quat_conjugate(base, turn);
	quat_multiply(turn, q, turn);
	angle = quat_angle(turn);
	if (angle <= limit_rad) {
		return false;
	}
	quat_slerp(IDENTITY, turn, limit_rad > 0 ? limit_rad / angle : 0, turn);
	quat_multiply(base, turn, q);
	quat_normalize(q);
	return true;
}
