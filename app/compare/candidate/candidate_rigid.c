#include "app/compare/candidate/candidate_rigid.h"

#include "app/anim/math/matrix.h"
#include "app/compare/measure/posed_vertices.h"
#include "app/model/model_stats.h"
#include "platform/base/count.h"
#include "platform/base/interrupt.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

enum {
	CORNERS = 3,
	CHOICES_MAX = CORNERS * MODEL_INFLUENCES_MAX
};

/* The state of split_drawable(), which divides triangles among the joints. */
struct splitter {
	struct rigid_bake *rigid;
	const struct reference_part *part;
	const struct drawable *drawable;
	const struct model_skin *skin; /* or NULL */
	int triangle_count;
	int *joint;  /* [triangle_count]: index in the skin, or 0 */
	int *copied; /* [vertex_count]: its last copy in rigid, or -1 */
};

static void pose_rigid(struct candidate *candidate, float time_s)
{
	struct rigid_bake *rigid = candidate->state;

	clip_pose(rigid->reference->clip, time_s, CLIP_AUTO, &rigid->cursor,
		&rigid->pose);
	pose_world(&rigid->pose, rigid->reference->model, NULL, rigid->world);
}

static void take_rigid(const struct candidate *candidate, float (*position)[3],
	float (*normal)[3])
{
	const struct rigid_bake *rigid = candidate->state;
	mat3 turn = GLM_MAT3_IDENTITY_INIT;

	for (int v = 0; v < candidate->vertex_count; v++) {
		int node = rigid->node[v];
		vec4 *world = rigid->world[node];

		matrix_apply(world, rigid->position[v], position[v]);
		if (normal && (v == 0 || node != rigid->node[v - 1])) {
			posed_vertices_normal_matrix((const vec4 *)world, turn);
		}
		if (normal) {
			glm_mat3_mulv(turn, rigid->normal[v], normal[v]);
			glm_vec3_normalize(normal[v]);
		}
	}
}

static void destroy_rigid(struct candidate *candidate)
{
	struct rigid_bake *rigid = candidate->state;

	if (rigid) {
		arena_release(&rigid->arena);
		free(rigid);
	}
}

/* Chooses the joint with the largest sum of weights at the corners. */
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

static void choose_joints(struct splitter *splitter)
{
	const struct model_primitive *primitive = splitter->drawable->primitive;

	for (int t = 0; t < splitter->triangle_count; t++) {
		splitter->joint[t] = splitter->skin
			? choose_joint(primitive, primitive->index + t * CORNERS)
			: 0;
	}
}

/*
 * Converts a skinned normal n to the joint's space. With W, the joint's world
 * matrix, skinning shows it as W * bind * n; but normals of a node's mesh are
 * transformed by the cofactors of W. transpose(W) * W * bind * n looks the same
 * at rest, and wherever joints only rotate from there.
 */
static void transform_normal(vec4 *bind, vec4 *world, float normal[3])
{
	mat3 side;
	vec3 bound, shown;

	matrix_apply_direction(bind, normal, bound);
	matrix_apply_direction(world, bound, shown);
	glm_mat4_pick3t(world, side);
	glm_mat3_mulv(side, shown, normal);
	if (glm_vec3_norm2(normal) == 0.0f) {
		glm_vec3_copy(bound, normal); /* the node is flat at rest */
	}
	glm_vec3_normalize(normal);
}

/* Stores a vertex in the space of the node that moves it. */
static void transform_vertex(
	const struct splitter *splitter, int joint, int vertex, int to)
{
	const struct model_primitive *primitive = splitter->drawable->primitive;
	struct rigid_bake *rigid = splitter->rigid;
	float *position = rigid->position[to];

	glm_vec3_copy(primitive->position[vertex], position);
	if (primitive->normal) {
		glm_vec3_copy(primitive->normal[vertex], rigid->normal[to]);
	}
	if (splitter->skin) {
		vec4 *bind = splitter->skin->inverse_bind[joint];

		matrix_apply(bind, position, position);
		transform_normal(bind,
			rigid->world[splitter->skin->joint[joint]],
			rigid->normal[to]);
	}
}

static int add_vertex(struct splitter *splitter, const struct rigid_part *part,
	int joint, int vertex)
{
	struct rigid_bake *rigid = splitter->rigid;
	int to = rigid->vertex_count;

	if (splitter->copied[vertex] < part->first_vertex) {
		splitter->copied[vertex] = to;
		rigid->source[to] = splitter->part->first_vertex + vertex;
		rigid->node[to] = part->node;
		transform_vertex(splitter, joint, vertex, to);
		rigid->vertex_count++;
	}
	return splitter->copied[vertex] - part->first_vertex;
}

/*
 * Appends a triangle to the part. turned: its vertices are stored mirrored, so
 * that it must have the opposite winding to face outwards.
 */
static void add_triangle(struct splitter *splitter,
	const struct rigid_part *part, int joint, int triangle, bool turned)
{
	const uint32_t *corner =
		splitter->drawable->primitive->index + triangle * CORNERS;
	struct rigid_bake *rigid = splitter->rigid;

	for (int i = 0; i < CORNERS; i++) {
		int vertex = (int)corner[turned ? (CORNERS - i) % CORNERS : i];

		rigid->index[rigid->index_count++] =
			(uint32_t)add_vertex(splitter, part, joint, vertex);
	}
}

/*
 * Makes a part of all triangles of a joint, if there are any. A joint that
 * mirrors has an inverse bind matrix that does so, too.
 */
static void add_part(struct splitter *splitter, int joint)
{
	struct rigid_bake *rigid = splitter->rigid;
	struct rigid_part *part = &rigid->part[rigid->part_count];
	bool turned = splitter->skin &&
		matrix_determinant(
			(const mat4 *)&splitter->skin->inverse_bind[joint]) <
			0.0f;

	*part = (struct rigid_part){
		.node = splitter->skin ? splitter->skin->joint[joint]
				       : splitter->drawable->node,
		.first_vertex = rigid->vertex_count,
		.first_index = rigid->index_count,
		.part = (int)(splitter->part - rigid->reference->part),
	};
	for (int t = 0; t < splitter->triangle_count; t++) {
		if (splitter->joint[t] == joint) {
			add_triangle(splitter, part, joint, t, turned);
		}
	}
	part->vertex_count = rigid->vertex_count - part->first_vertex;
	part->index_count = rigid->index_count - part->first_index;
	rigid->part_count += part->index_count > 0;
}

static int split_drawable(
	struct rigid_bake *rigid, const struct reference_part *part)
{
	const struct instance *instance = rigid->reference->instance;
	const struct drawable *drawable = &instance->drawable[part->drawable];
	struct splitter splitter = {
		.rigid = rigid,
		.part = part,
		.drawable = drawable,
		.skin = drawable->skin >= 0
			? &rigid->reference->model->skin[drawable->skin]
			: NULL,
		.triangle_count = drawable->primitive->index_count / CORNERS,
	};
	int joints = splitter.skin ? splitter.skin->joint_count : 1;

	splitter.joint = ARENA_ARRAY(
		&rigid->arena, int, (size_t)splitter.triangle_count);
	splitter.copied =
		ARENA_ARRAY(&rigid->arena, int, (size_t)part->vertex_count);
	if (!splitter.joint || !splitter.copied) {
		return -ENOMEM;
	}
	for (int v = 0; v < part->vertex_count; v++) {
		splitter.copied[v] = -1;
	}
	choose_joints(&splitter);
	for (int joint = 0; joint < joints && !interrupt_pending(); joint++) {
		add_part(&splitter, joint);
	}
	return interrupt_pending() ? -EINTR : 0;
}

/*
 * Allocates for the worst case: every corner is a vertex, every joint a part.
 */
static int init_arrays(struct rigid_bake *rigid)
{
	const struct reference *reference = rigid->reference;
	const struct instance *instance = reference->instance;
	struct arena *arena = &rigid->arena;
	const struct model *model = reference->model;
	int corners = 0, parts = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (!count_add(corners, drawable->primitive->index_count,
			    &corners) ||
			!count_add(parts,
				drawable->skin >= 0
					? model->skin[drawable->skin].joint_count
					: 1,
				&parts)) {
			return -ENOMEM;
		}
	}
	rigid->part = ARENA_ARRAY(arena, struct rigid_part, (size_t)parts + 1);
	rigid->index = ARENA_ARRAY(arena, uint32_t, (size_t)corners);
	rigid->source = ARENA_ARRAY(arena, int, (size_t)corners);
	rigid->node = ARENA_ARRAY(arena, int, (size_t)corners);
	rigid->position = arena_alloc(arena, (size_t)corners, sizeof(float[3]));
	rigid->normal = arena_alloc(arena, (size_t)corners, sizeof(float[3]));
	rigid->world = ARENA_ARRAY(arena, mat4, (size_t)model->node_count);
	return rigid->part && rigid->index && rigid->source && rigid->node &&
			rigid->position && rigid->normal && rigid->world
		? 0
		: -ENOMEM;
}

static int prepare(struct rigid_bake *rigid)
{
	const struct reference *reference = rigid->reference;
	int error = init_arrays(rigid);

	if (!error) {
		error = pose_init(&rigid->pose, reference->model, &rigid->arena);
	}
	if (!error) {
		pose_world(&rigid->pose, reference->model, NULL, rigid->world);
		error = clip_cursor_init(
			&rigid->cursor, reference->model, &rigid->arena);
	}
	for (int i = 0; !error && i < reference->part_count; i++) {
		error = split_drawable(rigid, &reference->part[i]);
	}
	return error;
}

/* Copies the clip without weights of targets, which rigid parts do not have. */
static int find_motion(struct rigid_bake *rigid, struct model_clip *out)
{
	const struct model_clip *clip = rigid->reference->clip;

	*out = *clip;
	out->channel_count = 0;
	out->channel = ARENA_ARRAY(&rigid->arena, struct model_channel,
		(size_t)clip->channel_count);
	if (!out->channel) {
		return -ENOMEM;
	}
	for (int i = 0; i < clip->channel_count; i++) {
		if (clip->channel[i].path != MODEL_WEIGHTS) {
			out->channel[out->channel_count++] = clip->channel[i];
		}
	}
	return 0;
}

static void count_bytes(struct candidate *candidate,
	const struct rigid_bake *rigid, const struct model_clip *motion)
{
	const struct reference *reference = rigid->reference;
	struct model_stats stats = {0};
	size_t vectors = 0;

	model_stats_add_clip(&stats, motion);
	for (int i = 0; i < rigid->part_count; i++) {
		const struct rigid_part *part = &rigid->part[i];
		bool normals = reference->part[part->part].normals;

		vectors += (size_t)(part->vertex_count * (normals ? 2 : 1));
	}
	candidate->bytes.own = candidate->bytes.own_file = stats.clip_bytes;
	candidate->bytes.shared_file = vectors * sizeof(float[3]);
	candidate->bytes.shared = vectors * sizeof(struct fixed_vector) +
		(size_t)reference->model->node_count *
			(sizeof(struct transform) + sizeof(mat4));
}

int candidate_rigid(struct candidate *candidate, struct reference *reference,
	const struct log *log)
{
	struct rigid_bake *rigid = calloc(1, sizeof(*rigid));
	struct model_clip motion;
	int error = -ENOMEM;

	*candidate = (struct candidate){
		.reference = reference,
		.pose = pose_rigid,
		.take = take_rigid,
		.destroy = destroy_rigid,
		.state = rigid,
	};
	if (rigid) {
		rigid->reference = reference;
		rigid->arena = arena_within(reference->model->budget);
		error = prepare(rigid);
	}
	if (!error) {
		error = find_motion(rigid, &motion);
	}
	if (error) {
		candidate_destroy(candidate);
		return error == -EINTR
			? error
			: memory_budget_fail(reference->model->budget,
				  reference->model->path, log);
	}
	candidate->vertex_count = rigid->vertex_count;
	candidate->source = rigid->source;
	count_bytes(candidate, rigid, &motion);
	candidate->board = (struct board_frame){
		.sample = board_cost_sample(
			&motion, reference->model->node_count),
		.matrices = board_cost_matrices(reference->model->node_count,
			board_cost_count_roots(reference->model), 0),
		.vertices = board_cost_solid(rigid->part_count),
	};
	return 0;
}

const struct rigid_bake *candidate_rigid_bake(const struct candidate *candidate)
{
	return candidate->state;
}
