#include "app/compare/candidate/candidate.h"

#include "app/compare/candidate/capped_influences.h"

#include "app/compare/measure/posed_vertices.h"
#include "app/model/model_deltas.h"
#include "app/model/model_stats.h"
#include "app/scene/instance/instance_play.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct original {
	const struct reference *reference;
	struct model model; /* a shallow copy, maybe without targets */
	struct arena arena;
	struct instance *instance;
	struct clip_cursor cursor;
};

static void pose_original(struct candidate *candidate, float time_s)
{
	struct original *state = candidate->state;

	clip_pose(state->reference->clip, time_s, CLIP_AUTO, &state->cursor,
		&state->instance->pose);
	state->instance->hold_normals = candidate->positions_only;
	state->instance->undrawn = candidate->positions_only;
	instance_update(state->instance);
}

static void take_original(const struct candidate *candidate,
	float (*position)[3], float (*normal)[3])
{
	const struct original *state = candidate->state;

	posed_vertices_positions(state->instance, position);
	if (normal) {
		posed_vertices_normals(state->instance, normal);
	}
}

static void destroy_original(struct candidate *candidate)
{
	struct original *state = candidate->state;

	if (state) {
		instance_destroy(state->instance);
		arena_release(&state->arena);
		free(state);
	}
}

static size_t vector_bytes(const struct drawable *drawable)
{
	return (size_t)drawable->primitive->vertex_count *
		(drawable->primitive->normal ? 2 : 1) * sizeof(float[3]);
}

static size_t target_bytes(const struct model *model, const struct drawable *d)
{
	const struct model_mesh *mesh = &model->mesh[model->node[d->node].mesh];
	size_t bytes = 0;

	for (int t = 0; t < mesh->target_count; t++) {
		const struct model_target *target = &d->primitive->target[t];
		int arrays = (target->position.vertex_count > 0) +
			(target->normal.vertex_count > 0);

		bytes += (size_t)(d->primitive->vertex_count * arrays) *
			sizeof(float[3]);
	}
	return bytes;
}

/* Of the displacements that the model stores: those of vertices that move. */
static size_t target_file_bytes(
	const struct model *model, const struct drawable *d)
{
	const struct model_mesh *mesh = &model->mesh[model->node[d->node].mesh];
	size_t bytes = 0;

	for (int t = 0; t < mesh->target_count; t++) {
		const struct model_target *target = &d->primitive->target[t];

		bytes += model_deltas_bytes(&target->position) +
			model_deltas_bytes(&target->normal);
	}
	return bytes;
}

/* For each influence, a stream has a weight record and base vectors. */
static size_t stream_bytes(const struct skin_stream *stream)
{
	size_t each = sizeof(struct joint_weight) + sizeof(float[4]) +
		(stream->normal ? sizeof(float[4]) : 0);

	return (size_t)stream->influence_count * each;
}

static size_t output_bytes(const struct drawable *drawable)
{
	return drawable->fixed ? vector_bytes(drawable) / sizeof(float[3]) *
			sizeof(struct fixed_vector)
			       : vector_bytes(drawable);
}

/*
 * The memory of the base and the targets; in fixed point these are stored in
 * pairs of targets or as key frames.
 */
static size_t morph_bytes(
	const struct model *model, const struct drawable *drawable)
{
	if (drawable->fixed && drawable->fixed->keys) {
		return fixed_keys_bytes(drawable->fixed->keys);
	}
	return drawable->fixed && drawable->skin < 0
		? fixed_morph_bytes(&drawable->fixed->morph)
		: vector_bytes(drawable) + target_bytes(model, drawable);
}

static size_t skin_bytes(const struct drawable *drawable)
{
	const struct drawable_fixed *fixed = drawable->fixed;

	return fixed ? fixed_skin_bytes(&fixed->skin) +
			(size_t)fixed->skin.joint_count *
				sizeof(struct fixed_matrix)
		     : stream_bytes(&drawable->stream);
}

static void count_drawable(struct candidate *candidate,
	const struct model *model, const struct drawable *drawable)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t vectors = vector_bytes(drawable);

	candidate->bytes.shared_file +=
		vectors + target_file_bytes(model, drawable);
	candidate->bytes.shared += output_bytes(drawable);
	if (drawable->skin >= 0) {
		size_t joint =
			model->skin[drawable->skin].joint_count > 256 ? 2 : 1;

		candidate->bytes.shared += skin_bytes(drawable);
		candidate->bytes.shared_file += (size_t)primitive->vertex_count *
			(size_t)primitive->influences * (joint + sizeof(float));
	}
	if (drawable->morphed) {
		candidate->bytes.shared += morph_bytes(model, drawable);
	}
}

static void count_bytes(
	struct candidate *candidate, const struct original *state)
{
	const struct model *model = &state->model;
	struct model_stats stats = {0};

	model_stats_add_clip(&stats, state->reference->clip);
	candidate->bytes.own = candidate->bytes.own_file = stats.clip_bytes;
	candidate->bytes.shared = (size_t)model->node_count *
		(sizeof(struct transform) + sizeof(mat4));
	for (int i = 0; i < model->skin_count; i++) {
		size_t matrices =
			(size_t)model->skin[i].joint_count * sizeof(mat4);

		candidate->bytes.shared +=
			2 * matrices; /* inverse bind matrices and palette */
		candidate->bytes.shared_file += matrices;
	}
	for (int i = 0; i < state->instance->drawable_count; i++) {
		const struct drawable *drawable = &state->instance->drawable[i];

		if (!drawable->shared) {
			count_drawable(candidate, model, drawable);
		}
	}
}

/*
 * Gives the copied model its own meshes, without targets if targets is false.
 */
static int copy_meshes(struct original *state, bool targets)
{
	const struct model *model = state->reference->model;
	struct model_mesh *mesh = ARENA_ARRAY(
		&state->arena, struct model_mesh, (size_t)model->mesh_count);

	if (!mesh) {
		return -ENOMEM;
	}
	memcpy(mesh, model->mesh, (size_t)model->mesh_count * sizeof(*mesh));
	for (int i = 0; i < model->mesh_count; i++) {
		mesh[i].target_count = targets ? mesh[i].target_count : 0;
	}
	state->model.mesh = mesh;
	return 0;
}

static int cap_primitive(
	struct model_primitive *primitive, int max, struct arena *arena)
{
	struct model_primitive from = *primitive;
	size_t count = (size_t)from.vertex_count * (size_t)from.influences;

	primitive->joint = ARENA_ARRAY(arena, uint16_t, count);
	primitive->weight = ARENA_ARRAY(arena, float, count);
	if (!primitive->joint || !primitive->weight) {
		return -ENOMEM;
	}
	for (int v = 0; v < from.vertex_count; v++) {
		struct capped_influences kept =
			capped_influences_of(&from, v, max);
		size_t at = (size_t)v * (size_t)from.influences;

		memcpy(primitive->joint + at, kept.joint,
			(size_t)from.influences * sizeof(*kept.joint));
		memcpy(primitive->weight + at, kept.weight,
			(size_t)from.influences * sizeof(*kept.weight));
	}
	return 0;
}

/* Caps the mesh's influences at max a vertex, as in the exported file. */
static int cap_mesh(struct model_mesh *mesh, int max, struct arena *arena)
{
	size_t count = (size_t)mesh->primitive_count;
	struct model_primitive *primitive =
		ARENA_ARRAY(arena, struct model_primitive, count);
	int error = primitive ? 0 : -ENOMEM;

	if (primitive) {
		memcpy(primitive, mesh->primitive, count * sizeof(*primitive));
	}
	for (int i = 0; !error && i < mesh->primitive_count; i++) {
		if (primitive[i].influences > 0) {
			error = cap_primitive(&primitive[i], max, arena);
		}
	}
	mesh->primitive = primitive;
	return error;
}

static int change_meshes(
	struct original *state, int max_influences, bool targets)
{
	int error = copy_meshes(state, targets);

	for (int i = 0;
		!error && max_influences > 0 && i < state->model.mesh_count;
		i++) {
		error = cap_mesh(
			&state->model.mesh[i], max_influences, &state->arena);
	}
	return error;
}

/* The scale is the reference's, so that the clips are not posed to find it. */
static int create_instance(const struct original *state,
	const struct kernel *kernel, bool drawn_vertices_only,
	const struct log *log, struct instance **out)
{
	const struct instance_options options = {
		.drawn_vertices_only = drawn_vertices_only,
		.unit_scale = state->reference->instance->unit_scale,
	};

	return instance_create_with(&state->model, kernel, &options, log, out);
}

static int prepare(struct original *state, const struct kernel *kernel,
	int max_influences, bool targets, const struct log *log)
{
	int error;

	state->model = *state->reference->model;
	error = change_meshes(state, max_influences, targets);
	if (!error) {
		error = clip_cursor_init(
			&state->cursor, &state->model, &state->arena);
	}
	if (error) {
		return memory_budget_fail(
			state->model.budget, state->model.path, log);
	}
	error = create_instance(state, kernel, false, log, &state->instance);
	if (!error) {
		state->instance->normal_mapping = false;
	}
	return error;
}

/*
 * Predicts for the fixed-point kernel, which the board uses, whatever kernel is
 * measured here, and for vertices in the order in which they are played.
 */
static int predict(struct candidate *candidate, struct original *state,
	double rate_hz, const struct log *log)
{
	const struct model_clip *clip = state->reference->clip;
	struct instance *instance = state->instance;
	bool dense = instance_is_dense(&state->model);
	int error = 0;

	if (!instance->kernel->fixed || dense) {
		error = create_instance(
			state, kernel_find("fixed"), dense, log, &instance);
	}
	if (!error) {
		candidate->board = board_cost_clip(
			clip, instance, &state->cursor, 0, rate_hz);
	}
	if (!error && instance != state->instance) {
		instance_destroy(instance);
	}
	return error;
}

int candidate_original(struct candidate *candidate, struct reference *reference,
	const struct kernel *kernel, int max_influences, bool targets,
	double rate_hz, const struct log *log)
{
	struct original *state = calloc(1, sizeof(*state));
	int error;

	*candidate = (struct candidate){
		.reference = reference,
		.vertex_count = reference->vertex_count,
		.pose = pose_original,
		.take = take_original,
		.destroy = destroy_original,
		.state = state,
	};
	if (!state) {
		log_error(log, "%s: there is not enough memory to compare it",
			reference->model->path);
		return -ENOMEM;
	}
	state->reference = reference;
	state->arena = arena_within(reference->model->budget);
	error = prepare(state, kernel, max_influences, targets, log);
	if (error) {
		candidate_destroy(candidate);
		return error;
	}
	count_bytes(candidate, state);
	error = predict(candidate, state, rate_hz, log);
	if (error) {
		candidate_destroy(candidate);
	}
	return error;
}
