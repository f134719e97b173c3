#include "app/compare/optimize/optimize_reach.h"

#include "app/anim/math/matrix.h"
#include "app/anim/pose.h"
#include "app/model/model_deltas.h"
#include "platform/base/scalar.h"

#include <errno.h>
#include <string.h>

#include <cglm/cglm.h>

/* The least distance between a node and its farthest vertex, in model sizes. */
static const float helper_reach = 0.1f;

struct reacher {
	const struct model *model;
	mat4 *world;   /* [node_count]: at rest */
	mat4 *palette; /* of the current skin */
	float *reach; /* [node_count]: distance to the farthest vertex, world units */
	bool *used; /* [node_count]: vertices follow it, or it is needed */
	struct bounds box;
};

/* Marks a node and its ancestors. */
static void use(struct reacher *reacher, int node)
{
	for (; node >= 0 && !reacher->used[node];
		node = reacher->model->node[node].parent) {
		reacher->used[node] = true;
	}
}

/* Updates the reach of a node and its ancestors by a vertex that follows it. */
static void follow(struct reacher *reacher, int node, const vec3 at)
{
	for (; node >= 0; node = reacher->model->node[node].parent) {
		float distance =
			glm_vec3_distance((float *)at, reacher->world[node][3]);

		if (distance > reacher->reach[node]) {
			reacher->reach[node] = distance;
		}
	}
}

static void reach_skinned(struct reacher *reacher,
	const struct model_primitive *primitive, const struct model_skin *skin)
{
	int influences = primitive->influences;

	for (int v = 0; v < primitive->vertex_count; v++) {
		size_t first = (size_t)v * (size_t)influences;

		for (int i = 0; i < influences; i++) {
			int joint = primitive->joint[first + (size_t)i];
			vec3 at;

			if (primitive->weight[first + (size_t)i] > 0.0f) {
				use(reacher, skin->joint[joint]);
			}
			if (primitive->weight[first + (size_t)i] < 0.01f) {
				continue;
			}
			glm_mat4_mulv3(reacher->palette[joint],
				primitive->position[v], 1.0f, at);
			bounds_add(&reacher->box, at);
			follow(reacher, skin->joint[joint], at);
		}
	}
}

static void reach_rigid(struct reacher *reacher,
	const struct model_primitive *primitive, int node)
{
	for (int v = 0; v < primitive->vertex_count; v++) {
		vec3 at;

		glm_mat4_mulv3(
			reacher->world[node], primitive->position[v], 1.0f, at);
		bounds_add(&reacher->box, at);
		follow(reacher, node, at);
	}
}

static void reach_node(struct reacher *reacher, int index)
{
	const struct model *model = reacher->model;
	const struct model_node *node = &model->node[index];
	const struct model_mesh *mesh =
		node->mesh >= 0 ? &model->mesh[node->mesh] : NULL;
	const struct model_skin *skin =
		node->skin >= 0 ? &model->skin[node->skin] : NULL;

	if (mesh || node->camera >= 0) {
		use(reacher, index);
	}
	if (mesh && skin) {
		pose_palette(skin, reacher->world, reacher->palette);
	}
	for (int p = 0; mesh && p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		if (skin && primitive->influences > 0) {
			reach_skinned(reacher, primitive, skin);
		} else {
			reach_rigid(reacher, primitive, index);
		}
	}
}

/* Finds the largest displacement of each target; px is pixels a unit. */
static int measure_targets(struct optimize_reach *reach,
	struct optimize_reach_node *node, const struct model_mesh *mesh,
	float px)
{
	float *out =
		ARENA_ARRAY(&reach->arena, float, (size_t)mesh->target_count);

	if (!out) {
		return -ENOMEM;
	}
	for (int p = 0; p < mesh->primitive_count; p++) {
		const struct model_primitive *primitive = &mesh->primitive[p];

		for (int t = 0; t < mesh->target_count; t++) {
			for (int v = 0; v < primitive->vertex_count; v++) {
				float moved[3], length;

				model_deltas_get(&primitive->target[t].position,
					v, moved);
				length = px * glm_vec3_norm(moved);
				out[t] = length > out[t] ? length : out[t];
			}
		}
	}
	node->target_count = mesh->target_count;
	node->target_px = out;
	return 0;
}

static int describe(struct optimize_reach *reach, const struct reacher *reacher,
	int index, float px_per_unit)
{
	const struct model *model = reacher->model;
	const struct model_node *node = &model->node[index];
	struct optimize_reach_node *out = &reach->node[node->file_index];
	float least = helper_reach * bounds_extent(&reacher->box);
	float far =
		reacher->reach[index] > least ? reacher->reach[index] : least;
	float parent = node->parent >= 0
		? matrix_greatest_scale(
			  (const mat4 *)&reacher->world[node->parent], 1)
		: 1.0f;
	const mat4 *mover; /* matrices that move the mesh's vertices */
	bool skinned;

	out->exact = false;
	out->idle = !reacher->used[index];
	out->move_px = parent * px_per_unit;
	out->turn_px = far * px_per_unit;
	out->scale_px = far * px_per_unit;
	if (node->mesh < 0 || model->mesh[node->mesh].target_count == 0) {
		return 0;
	}
	skinned = node->skin >= 0;
	mover = (const mat4 *)(skinned ? reacher->palette
				       : &reacher->world[index]);
	return measure_targets(reach, out, &model->mesh[node->mesh],
		px_per_unit *
			matrix_greatest_scale(mover,
				skinned ? model->skin[node->skin].joint_count
					: 1));
}

static int find(struct optimize_reach *reach, struct reacher *reacher,
	float px_per_unit, const bool *needed)
{
	const struct model *model = reacher->model;
	int error = 0;

	/* File nodes that were not loaded keep their keys. */
	for (int i = 0; i < reach->node_count; i++) {
		reach->node[i].exact = true;
	}
	for (int i = 0; i < model->node_count; i++) {
		if (needed && needed[model->node[i].file_index]) {
			use(reacher, i);
		}
		reach_node(reacher, i);
	}
	for (int i = 0; i < model->node_count && !error; i++) {
		const struct model_node *node = &model->node[i];

		if (node->skin >= 0) {
			pose_palette(&model->skin[node->skin], reacher->world,
				reacher->palette);
		}
		error = describe(reach, reacher, i, px_per_unit);
	}
	for (int i = model->node_count; i-- > 0;) {
		int parent = model->node[i].parent;
		const struct optimize_reach_node *node =
			&reach->node[model->node[i].file_index];

		if (model->node[i].camera >= 0) {
			reach->node[model->node[i].file_index].exact = true;
		}
		if (parent >= 0 && node->exact) {
			reach->node[model->node[parent].file_index].exact = true;
		}
	}
	return error;
}

static int most_joints(const struct model *model)
{
	int most = 1;

	for (int s = 0; s < model->skin_count; s++) {
		int count = model->skin[s].joint_count;

		most = count > most ? count : most;
	}
	return most;
}

static int count_file_nodes(const struct model *model)
{
	int count = 0;

	for (int i = 0; i < model->node_count; i++) {
		int index = model->node[i].file_index;

		count = index >= count ? index + 1 : count;
	}
	return count;
}

int optimize_reach_find(struct optimize_reach *reach, const struct model *model,
	float px_per_unit, const bool *needed)
{
	struct reacher reacher = {.model = model, .box = bounds_empty()};
	struct arena scratch = arena_empty();
	size_t count = (size_t)model->node_count;
	struct pose pose;
	int error = -ENOMEM;

	*reach = (struct optimize_reach){
		.arena = arena_empty(), .node_count = count_file_nodes(model)};
	reach->node = ARENA_ARRAY(&reach->arena, struct optimize_reach_node,
		(size_t)reach->node_count);
	reacher.world = ARENA_ARRAY(&scratch, mat4, count);
	reacher.palette =
		ARENA_ARRAY(&scratch, mat4, (size_t)most_joints(model));
	reacher.reach = ARENA_ARRAY(&scratch, float, count);
	reacher.used = ARENA_ARRAY(&scratch, bool, count);
	if (reach->node && reacher.world && reacher.palette && reacher.reach &&
		reacher.used) {
		error = pose_init(&pose, model, &scratch);
	}
	if (!error) {
		pose_world(&pose, model, NULL, reacher.world);
		error = find(reach, &reacher, px_per_unit, needed);
	}
	arena_release(&scratch);
	return error;
}

/* Marks the nodes that channels with more than one value move. */
static void mark_moved(struct optimize_reach *reach, const struct model *model)
{
	for (int c = 0; c < model->clip_count; c++) {
		const struct model_clip *clip = &model->clip[c];

		for (int i = 0; i < clip->channel_count; i++) {
			const struct model_channel *channel = &clip->channel[i];
			int index = model->node[channel->node].file_index;

			if (!channel->constant && index < reach->node_count) {
				reach->node[index].moved = true;
			}
		}
	}
}

struct optimize_idle optimize_reach_idle(
	struct optimize_reach *reach, const struct model *model)
{
	struct optimize_idle idle = {.count = 0, .name = ""};

	mark_moved(reach, model);
	for (int i = 0; i < model->node_count; i++) {
		const struct model_node *node = &model->node[i];

		if (node->file_index < reach->node_count &&
			reach->node[node->file_index].idle &&
			reach->node[node->file_index].moved) {
			idle.name = idle.count == 0 ? node->name : idle.name;
			idle.count++;
		}
	}
	return idle;
}

void optimize_reach_release(struct optimize_reach *reach)
{
	arena_release(&reach->arena);
	*reach = (struct optimize_reach){.node_count = 0};
}
