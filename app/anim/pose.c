#include "app/anim/pose.h"

#include "app/anim/joints.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/transform_inline.h"

#include <errno.h>
#include <string.h>

int pose_init(struct pose *pose, const struct model *model, struct arena *arena)
{
	size_t nodes = (size_t)model->node_count;
	size_t weights = (size_t)model->weight_count;
	size_t size_bytes = nodes * sizeof(*pose->local) +
		weights * sizeof(*pose->weight) +
		nodes * sizeof(*pose->animated);
	struct transform *local = arena_alloc(arena, size_bytes, 1);

	if (!local) {
		return -ENOMEM;
	}
	*pose = (struct pose){
		.model = model,
		.node_count = model->node_count,
		.local = local,
		.weight_count = model->weight_count,
		.weight = (float *)(local + nodes),
		.animated = (bool *)((float *)(local + nodes) + weights),
		.size_bytes = size_bytes,
	};
	for (int i = 0; i < model->node_count; i++) {
		if (model->node[i].parent < 0) {
			pose->root_end = i + 1;
		}
		if (model->node[i].matrix) {
			pose->matrix_end = i + 1;
		}
	}
	pose_rest(pose, model);
	return 0;
}

void pose_rest(struct pose *pose, const struct model *model)
{
	for (int i = 0; i < pose->node_count; i++) {
		pose->local[i] = model->node[i].rest;
		pose->animated[i] = false;
	}
	for (int i = 0; i < pose->weight_count; i++) {
		pose->weight[i] = model->rest_weights[i];
	}
}

void pose_world(const struct pose *pose, const struct model *model, mat4 root,
	mat4 *world)
{
	pose_world_from(pose, model, root, 0, world);
}

void pose_world_from(const struct pose *pose, const struct model *model,
	mat4 root, int first, mat4 *world)
{
	const struct model_node *node = model->node + first;
	int count = pose->node_count - first;

	if (count <= 0) {
		return;
	}
	joints_to_matrices(pose->local + first, count, world + first);
	for (int i = first; i < pose->matrix_end; i++) {
		if (model->node[i].matrix && !pose->animated[i]) {
			memcpy(world[i], model->node[i].matrix, sizeof(mat4));
		}
	}
	for (int i = first; root && i < pose->root_end; i++) {
		if (model->node[i].parent < 0) {
			matrix_multiply(root, world[i], world[i]);
		}
	}
	joints_multiply((const mat4 *)world, &node->parent, sizeof(*node),
		(const mat4 *)world + first, world + first, count);
}

void pose_palette(
	const struct model_skin *skin, const mat4 *world, mat4 *palette)
{
	joints_multiply(world, skin->joint, sizeof(*skin->joint),
		(const mat4 *)skin->inverse_bind, palette, skin->joint_count);
}
