#include "app/anim/procedural/bone.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"

#include <string.h>

void bone_parent_rotation(
	const struct pose *pose, const mat4 *world, int node, float out[4])
{
	int parent = pose->model->node[node].parent;

	if (parent < 0) {
		quat_set_identity(out);
		return;
	}
	matrix_rotation(((mat4 *)world)[parent], out);
}

bool bone_is_mirrored(const struct pose *pose, const mat4 *world, int node)
{
	int parent = pose->model->node[node].parent;

	return parent >= 0 && matrix_determinant(&world[parent]) < 0;
}

void bone_to_axes(
	const mat4 *world, int node, const float direction[3], float out[3])
{
	float back[4];

	if (node < 0) {
		memcpy(out, direction, sizeof(float[3]));
		return;
	}
	matrix_rotation(((mat4 *)world)[node], back);
	quat_conjugate(back, back);
	quat_rotate(back, direction, out);
	if (matrix_determinant(&world[node]) < 0) {
		out[2] = -out[2];
	}
}

/* Interpolates the node's local rotation to parent^-1 * rotation. */
static void set_rotation(struct pose *pose, const mat4 *world, int node,
	const float parent[4], const float rotation[4], float weight)
{
	float *local = pose->local[node].rotation;
	float goal[4];

	quat_conjugate(parent, goal);
	quat_multiply(goal, rotation, goal);
	bone_mirror_rotation(bone_is_mirrored(pose, world, node), goal);
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
	memcpy(rotation, pose->local[node].rotation, sizeof(rotation));
	bone_mirror_rotation(bone_is_mirrored(pose, world, node), rotation);
	quat_multiply(parent, rotation, rotation);
	quat_multiply(turn, rotation, rotation);
	set_rotation(pose, world, node, parent, rotation, weight);
}

void bone_set_world_rotation(struct pose *pose, const mat4 *world, int node,
	const float rotation[4], float weight)
{
	float parent[4];

	bone_parent_rotation(pose, world, node, parent);
	set_rotation(pose, world, node, parent, rotation, weight);
}

bool bone_chain(const struct model *model, int tip, int count, int *node)
{
	for (int i = count - 1; i >= 0; i--) {
		if (tip < 0 || tip >= model->node_count) {
			return false;
		}
		node[i] = tip;
		tip = model->node[tip].parent;
	}
	return true;
}

/* Returns how much the parent's factor stretches an axis of a child. */
static float stretched(
	const struct transform *child, int axis, const float factor[3])
{
	float direction[3] = {0, 0, 0};

	direction[axis] = 1;
	quat_rotate(child->rotation, direction, direction);
	for (int i = 0; i < 3; i++) {
		direction[i] *= factor[i];
	}
	return vec_length(direction);
}

void bone_swell(struct pose *pose, int node, const float factor[3])
{
	for (int i = 0; i < 3; i++) {
		pose->local[node].scale[i] *= factor[i];
	}
	pose->animated[node] = true;
	for (int c = node + 1; c < pose->node_count; c++) {
		struct transform *child = &pose->local[c];

		if (pose->model->node[c].parent != node) {
			continue;
		}
		for (int i = 0; i < 3; i++) {
			float length = stretched(child, i, factor);

			child->scale[i] /= length > 1e-6f ? length : 1;
		}
		pose->animated[c] = true;
	}
}
