#include "app/anim/pose.h"

#include "app/anim/joints.h"
#include "app/anim/math/matrix.h"
#include "app/anim/math/transform_inline.h"

#include <errno.h>
#include <string.h>

int pose_init(struct pose *pose, const struct model *model, struct arena *arena)
{
	*pose = (struct pose){
		.model = model,
		.node_count = model->node_count,
		.weight_count = model->weight_count,
	};
	pose->local =
		ARENA_ARRAY(arena, struct transform, (size_t)model->node_count);
	pose->animated = ARENA_ARRAY(arena, bool, (size_t)model->node_count);
	pose->weight = ARENA_ARRAY(arena, float, (size_t)model->weight_count);
	if (!pose->local || !pose->animated || !pose->weight) {
		return -ENOMEM;
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
	for (int i = first; i < pose->node_count; i++) {
		if (model->node[i].matrix && !pose->animated[i]) {
			memcpy(world[i], model->node[i].matrix, sizeof(mat4));
		}
	}
	for (int i = first; root && i < pose->node_count; i++) {
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
