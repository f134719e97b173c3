/*
 * Rigid parts on pivots: AN4044, section 2.
 *
 * A triangle goes to the joint with the largest sum of its corners' weights;
 * a vertex that triangles of several joints share is stored once for each.
 */
#include "app/compare/candidate.h"

#include "app/anim/math/matrix.h"
#include "app/model/model_stats.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

enum {
	CORNERS = 3,
	CHOICES_MAX = CORNERS * MODEL_INFLUENCES_MAX
};

/* A drawable while it is cut. */
struct cutting {
	struct rigid *rigid;
	const struct reference_part *part;
	const struct drawable *drawable;
	const struct model_skin *skin; /* or NULL */
	int triangle_count;
	int *joint;  /* [triangle_count]: in the skin, or 0 */
	int *copied; /* [vertex_count]: its place in the part, or -1 */
};

static void pose_rigid(struct candidate *candidate, float time_s)
{
	struct rigid *rigid = candidate->state;

	clip_sample(
		rigid->reference->clip, time_s, &rigid->cursor, &rigid->pose);
	pose_world(&rigid->pose, rigid->reference->model, NULL, rigid->world);
}

static void vertex_rigid(
	const struct candidate *candidate, int vertex, float out[3])
{
	const struct rigid *rigid = candidate->state;

	matrix_apply(rigid->world[rigid->node[vertex]], rigid->position[vertex],
		out);
}

static void destroy_rigid(struct candidate *candidate)
{
	struct rigid *rigid = candidate->state;

	if (rigid) {
		arena_release(&rigid->arena);
		free(rigid);
	}
}

/* The joint that moves most of a triangle. */
static int choose_joint(
	const struct model_primitive *primitive, const uint32_t corner[CORNERS])
{
	int joint[CHOICES_MAX];
	float sum[CHOICES_MAX];
	int count = 0, best = 0;

	for (int i = 0; i < CORNERS * primitive->influences; i++) {
		size_t at = (size_t)corner[i / primitive->influences] *
				(size_t)primitive->influences +
			(size_t)(i % primitive->influences);
		int known = 0;

		while (known < count && joint[known] != primitive->joint[at]) {
			known++;
		}
		if (known == count) {
			joint[count] = primitive->joint[at];
			sum[count++] = 0.0f;
		}
		sum[known] += primitive->weight[at];
	}
	for (int i = 1; i < count; i++) {
		best = sum[i] > sum[best] ? i : best;
	}
	return joint[best];
}

static void choose_joints(struct cutting *cutting)
{
	const struct model_primitive *primitive = cutting->drawable->primitive;

	for (int t = 0; t < cutting->triangle_count; t++) {
		cutting->joint[t] = cutting->skin
			? choose_joint(primitive, primitive->index + t * CORNERS)
			: 0;
	}
}

/* A vertex into the space of the node that is to carry it. */
static void place_vertex(
	const struct cutting *cutting, int joint, int vertex, int to)
{
	const struct model_primitive *primitive = cutting->drawable->primitive;
	struct rigid *rigid = cutting->rigid;
	float *position = rigid->position[to];

	glm_vec3_copy(primitive->position[vertex], position);
	if (primitive->normal) {
		glm_vec3_copy(primitive->normal[vertex], rigid->normal[to]);
	}
	if (cutting->skin) {
		vec4 *bind = cutting->skin->inverse_bind[joint];

		matrix_apply(bind, position, position);
		matrix_apply_direction(
			bind, rigid->normal[to], rigid->normal[to]);
		glm_vec3_normalize(rigid->normal[to]);
	}
}

static int add_vertex(struct cutting *cutting, const struct rigid_part *part,
	int joint, int vertex)
{
	struct rigid *rigid = cutting->rigid;
	int to = rigid->vertex_count;

	if (cutting->copied[vertex] < part->first_vertex) {
		cutting->copied[vertex] = to;
		rigid->source[to] = cutting->part->first_vertex + vertex;
		rigid->node[to] = part->node;
		place_vertex(cutting, joint, vertex, to);
		rigid->vertex_count++;
	}
	return cutting->copied[vertex] - part->first_vertex;
}

/* All triangles of one joint; none make no part. */
static void cut_part(struct cutting *cutting, int joint)
{
	const struct model_primitive *primitive = cutting->drawable->primitive;
	struct rigid *rigid = cutting->rigid;
	struct rigid_part *part = &rigid->part[rigid->part_count];

	*part = (struct rigid_part){
		.node = cutting->skin ? cutting->skin->joint[joint]
				      : cutting->drawable->node,
		.first_vertex = rigid->vertex_count,
		.first_index = rigid->index_count,
		.part = (int)(cutting->part - rigid->reference->part),
	};
	for (int t = 0; t < cutting->triangle_count; t++) {
		if (cutting->joint[t] != joint) {
			continue;
		}
		for (int corner = 0; corner < CORNERS; corner++) {
			int vertex = (int)primitive->index[t * CORNERS + corner];

			rigid->index[rigid->index_count++] =
				(uint32_t)add_vertex(
					cutting, part, joint, vertex);
		}
	}
	part->vertex_count = rigid->vertex_count - part->first_vertex;
	part->index_count = rigid->index_count - part->first_index;
	rigid->part_count += part->index_count > 0;
}

static int cut_drawable(struct rigid *rigid, const struct reference_part *part)
{
	const struct instance *instance = rigid->reference->instance;
	const struct drawable *drawable = &instance->drawable[part->drawable];
	struct cutting cutting = {
		.rigid = rigid,
		.part = part,
		.drawable = drawable,
		.skin = drawable->skin >= 0
			? &rigid->reference->model->skin[drawable->skin]
			: NULL,
		.triangle_count = drawable->primitive->index_count / CORNERS,
	};
	int joints = cutting.skin ? cutting.skin->joint_count : 1;

	cutting.joint =
		ARENA_ARRAY(&rigid->arena, int, (size_t)cutting.triangle_count);
	cutting.copied =
		ARENA_ARRAY(&rigid->arena, int, (size_t)part->vertex_count);
	if (!cutting.joint || !cutting.copied) {
		return -ENOMEM;
	}
	for (int v = 0; v < part->vertex_count; v++) {
		cutting.copied[v] = -1;
	}
	choose_joints(&cutting);
	for (int joint = 0; joint < joints; joint++) {
		cut_part(&cutting, joint);
	}
	return 0;
}

/* At most every corner is a vertex, and every joint a part. */
static int init_arrays(struct rigid *rigid)
{
	const struct reference *reference = rigid->reference;
	const struct instance *instance = reference->instance;
	struct arena *arena = &rigid->arena;
	size_t corners = 0, parts = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		corners += (size_t)drawable->primitive->index_count;
		parts += drawable->skin >= 0
			? (size_t)reference->model->skin[drawable->skin].joint_count
			: 1;
	}
	rigid->part = ARENA_ARRAY(arena, struct rigid_part, parts + 1);
	rigid->index = ARENA_ARRAY(arena, uint32_t, corners);
	rigid->source = ARENA_ARRAY(arena, int, corners);
	rigid->node = ARENA_ARRAY(arena, int, corners);
	rigid->position = arena_alloc(arena, corners, sizeof(float[3]));
	rigid->normal = arena_alloc(arena, corners, sizeof(float[3]));
	rigid->world =
		ARENA_ARRAY(arena, mat4, (size_t)reference->model->node_count);
	return rigid->part && rigid->index && rigid->source && rigid->node &&
			rigid->position && rigid->normal && rigid->world
		? 0
		: -ENOMEM;
}

static int prepare(struct rigid *rigid)
{
	const struct reference *reference = rigid->reference;
	int error = init_arrays(rigid);

	if (!error) {
		error = pose_init(&rigid->pose, reference->model, &rigid->arena);
	}
	if (!error) {
		error = clip_cursor_init(
			&rigid->cursor, reference->model, &rigid->arena);
	}
	for (int i = 0; !error && i < reference->part_count; i++) {
		error = cut_drawable(rigid, &reference->part[i]);
	}
	return error;
}

static void count_bytes(struct candidate *candidate, const struct rigid *rigid)
{
	const struct reference *reference = rigid->reference;
	struct model_stats stats = {0};
	size_t vectors = 0;

	model_stats_add_clip(&stats, reference->clip);
	for (int i = 0; i < rigid->part_count; i++) {
		const struct rigid_part *part = &rigid->part[i];
		bool normals = reference->part[part->part].normals;

		vectors += (size_t)(part->vertex_count * (normals ? 2 : 1));
	}
	candidate->file_bytes = stats.clip_bytes + vectors * sizeof(float[3]);
	candidate->memory_bytes = candidate->file_bytes +
		(size_t)reference->model->node_count *
			(sizeof(struct transform) + sizeof(mat4));
}

int candidate_rigid(struct candidate *candidate,
	const struct reference *reference, const struct log *log)
{
	struct rigid *rigid = calloc(1, sizeof(*rigid));

	*candidate = (struct candidate){
		.name = "rigid parts",
		.technique = TECHNIQUE_HIERARCHICAL,
		.pose = pose_rigid,
		.vertex = vertex_rigid,
		.destroy = destroy_rigid,
		.state = rigid,
	};
	if (rigid) {
		rigid->reference = reference;
		rigid->arena = arena_empty();
	}
	if (!rigid || prepare(rigid) != 0) {
		log_error(log, "%s: not enough memory to cut it into parts",
			reference->model->path);
		candidate_destroy(candidate);
		return -ENOMEM;
	}
	candidate->vertex_count = rigid->vertex_count;
	candidate->source = rigid->source;
	count_bytes(candidate, rigid);
	candidate->board = board_cost_pose(reference->model);
	return 0;
}

const struct rigid *candidate_rigid_parts(const struct candidate *candidate)
{
	return candidate->state;
}
