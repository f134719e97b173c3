#include "app/compare/candidate/candidate.h"

#include "app/compare/measure/posed_vertices.h"
#include "app/model/model_stats.h"

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
		int arrays =
			(target->position != NULL) + (target->normal != NULL);

		bytes += (size_t)(d->primitive->vertex_count * arrays) *
			sizeof(float[3]);
	}
	return bytes;
}

/* Each influence is a weight record with its base vectors. */
static size_t stream_bytes(const struct skin_stream *stream, int cap)
{
	int count = cap > 0 && cap < stream->max_influences
		? stream->capped[cap]
		: stream->influence_count;
	size_t each = sizeof(struct joint_weight) + sizeof(float[4]) +
		(stream->normal ? sizeof(float[4]) : 0);

	return (size_t)count * each;
}

static size_t output_bytes(const struct drawable *drawable)
{
	return drawable->fixed ? vector_bytes(drawable) / sizeof(float[3]) *
			sizeof(struct fixed_vector)
			       : vector_bytes(drawable);
}

/* In fixed point a morph keeps its base, and its targets in pairs or as keys. */
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

static size_t skin_bytes(const struct drawable *drawable, int cap)
{
	const struct drawable_fixed *fixed = drawable->fixed;

	return fixed ? fixed_skin_bytes(&fixed->skin) +
			(size_t)fixed->skin.joint_count *
				sizeof(struct fixed_matrix)
		     : stream_bytes(&drawable->stream, cap);
}

static void count_drawable(struct candidate *candidate,
	const struct model *model, const struct drawable *drawable, int cap)
{
	const struct model_primitive *primitive = drawable->primitive;
	size_t vectors = vector_bytes(drawable);

	candidate->bytes.shared_file += vectors + target_bytes(model, drawable);
	candidate->bytes.shared += output_bytes(drawable);
	if (drawable->skin >= 0) {
		size_t joint =
			model->skin[drawable->skin].joint_count > 256 ? 2 : 1;

		candidate->bytes.shared += skin_bytes(drawable, cap);
		candidate->bytes.shared_file += (size_t)primitive->vertex_count *
			(size_t)primitive->influences * (joint + sizeof(float));
	}
	if (drawable->morphed) {
		candidate->bytes.shared += morph_bytes(model, drawable);
	}
}

static void count_bytes(
	struct candidate *candidate, const struct original *state, int cap)
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
		count_drawable(
			candidate, model, &state->instance->drawable[i], cap);
	}
}

/* Gives the copy of the model meshes without targets. */
static int drop_targets(struct original *state)
{
	const struct model *model = state->reference->model;
	struct model_mesh *mesh = ARENA_ARRAY(
		&state->arena, struct model_mesh, (size_t)model->mesh_count);

	if (!mesh) {
		return -ENOMEM;
	}
	memcpy(mesh, model->mesh, (size_t)model->mesh_count * sizeof(*mesh));
	for (int i = 0; i < model->mesh_count; i++) {
		mesh[i].target_count = 0;
	}
	state->model.mesh = mesh;
	return 0;
}

static int prepare(struct original *state, const struct kernel *kernel,
	int max_influences, bool targets, const struct log *log)
{
	int error = 0;

	state->model = *state->reference->model;
	if (!targets) {
		error = drop_targets(state);
	}
	if (!error) {
		error = clip_cursor_init(
			&state->cursor, &state->model, &state->arena);
	}
	if (error) {
		return memory_budget_fail(
			state->model.budget, state->model.path, log);
	}
	error = instance_create(&state->model, kernel, log, &state->instance);
	if (!error) {
		state->instance->normal_mapping = false;
		state->instance->max_influences = max_influences;
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
	count_bytes(candidate, state, max_influences);
	candidate->board = board_cost_clip(reference->clip, state->instance,
		&state->cursor, max_influences, rate_hz);
	return 0;
}
