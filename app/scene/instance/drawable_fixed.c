#include "app/scene/instance/drawable_fixed.h"

#include "app/anim/kernel/run/fixed_keys_run.h"
#include "app/anim/kernel/run/fixed_morph_run.h"
#include "app/anim/kernel/run/fixed_palette.h"
#include "app/anim/kernel/run/fixed_skin_run.h"
#include "app/model/model_keys.h"
#include "app/scene/draw/bump.h"

#include <errno.h>

static struct fixed_vector *vectors(struct arena *arena, int count)
{
	return ARENA_ARRAY(arena, struct fixed_vector, (size_t)count);
}

static unsigned wanted_streams(
	const struct model *model, const struct model_primitive *primitive)
{
	unsigned streams = primitive->normal ? FIXED_NORMALS : 0;

	return streams | (bump_is_mapped(model, primitive) ? FIXED_TANGENTS : 0);
}

/* Allocates the arrays that are written each frame. */
static int init_output(struct drawable_fixed *fixed, int vertex_count,
	unsigned streams, struct arena *arena)
{
	fixed->position = vectors(arena, vertex_count);
	if (streams & FIXED_NORMALS) {
		fixed->normal = vectors(arena, vertex_count);
	}
	if (streams & FIXED_TANGENTS) {
		fixed->tangent = vectors(arena, vertex_count);
	}
	return fixed->position &&
			(fixed->normal || !(streams & FIXED_NORMALS)) &&
			(fixed->tangent || !(streams & FIXED_TANGENTS))
		? 0
		: -ENOMEM;
}

static int init_skin(struct drawable_fixed *fixed,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena)
{
	int error = fixed_skin_init(&fixed->skin, primitive, streams, arena);

	if (!error && target_count > 0) {
		error = fixed_skin_add_targets(
			&fixed->skin, target_count, arena);
	}
	if (error) {
		return error;
	}
	fixed->order = fixed->skin.order;
	fixed->inverse_order = fixed->skin.inverse_order;
	fixed->matrix = ARENA_ARRAY(
		arena, struct fixed_matrix, (size_t)fixed->skin.joint_count);
	fixed->normal_matrix = ARENA_ARRAY(
		arena, struct fixed_matrix, (size_t)fixed->skin.joint_count);
	return fixed->matrix && fixed->normal_matrix
		? init_output(fixed, primitive->vertex_count, streams, arena)
		: -ENOMEM;
}

/* A rigid drawable's output is the base itself, which never changes. */
static int init_morph(struct drawable_fixed *fixed,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena)
{
	struct fixed_morph *morph = &fixed->morph;
	int error = fixed_morph_init(
		morph, primitive, target_count, streams, arena);

	fixed->placement = morph->placement;
	if (error || target_count > 0) {
		return error ? error
			     : init_output(fixed, primitive->vertex_count,
				       streams, arena);
	}
	fixed->position = morph->stream[FIXED_POSITION].base;
	fixed->normal = morph->stream[FIXED_NORMAL].base;
	fixed->tangent = morph->stream[FIXED_TANGENT].base;
	return 0;
}

static int init_keys(struct drawable_fixed *fixed,
	const struct model_primitive *primitive, int target_count,
	unsigned streams, struct arena *arena)
{
	int error;

	fixed->keys = ARENA_NEW(arena, struct fixed_keys);
	if (!fixed->keys) {
		return -ENOMEM;
	}
	error = fixed_keys_init(
		fixed->keys, primitive, target_count, streams, arena);
	fixed->placement = fixed->keys->placement;
	return error
		? error
		: init_output(fixed, primitive->vertex_count, streams, arena);
}

int drawable_fixed_init(struct drawable *drawable, const struct model *model,
	const struct fixed_loops *loops, bool in_tiers, struct arena *arena)
{
	const struct model_primitive *primitive = drawable->primitive;
	int mesh = model->node[drawable->node].mesh;
	int target_count = model->mesh[mesh].target_count;
	unsigned streams = wanted_streams(model, primitive);
	struct drawable_fixed *fixed;
	int error;

	fixed = ARENA_NEW(arena, struct drawable_fixed);
	if (!fixed) {
		return -ENOMEM;
	}
	fixed->loops = loops;
	if (drawable->skin >= 0) {
		error = init_skin(fixed, primitive, target_count,
			streams | (in_tiers ? FIXED_TIERS : 0), arena);
	} else if (model_has_key_frames(model, drawable->node)) {
		error = init_keys(
			fixed, primitive, target_count, streams, arena);
	} else {
		error = init_morph(
			fixed, primitive, target_count, streams, arena);
	}
	drawable->fixed = error ? NULL : fixed;
	return error;
}

/* If normal_matrix is NULL, the normals of the last update are kept. */
static void run_skin(const struct drawable_fixed *fixed, int lod,
	const struct fixed_matrix *normal_matrix, bool with_tangents)
{
	const struct fixed_skin *skin = &fixed->skin;
	const struct fixed_loops *loops = fixed->loops;
	int group_count = fixed_skin_group_count(skin, lod);

	loops->skin(skin->group, group_count, skin->base[FIXED_POSITION],
		fixed->matrix, fixed->position);
	if (normal_matrix) {
		loops->skin(skin->group, group_count, skin->base[FIXED_NORMAL],
			normal_matrix, fixed->normal);
	}
	if (with_tangents) {
		loops->skin(skin->group, group_count, skin->base[FIXED_TANGENT],
			fixed->matrix, fixed->tangent);
	}
}

static const float *weights_of(
	const struct instance *instance, const struct drawable *drawable)
{
	return instance->pose.weight +
		instance->model->node[drawable->node].weight_offset;
}

static bool set_skin_weights(
	const struct instance *instance, const struct drawable *drawable)
{
	struct drawable_fixed *fixed = drawable->fixed;

	return fixed_skin_set_weights(&fixed->skin, fixed->loops,
		       weights_of(instance, drawable)) == 0;
}

/*
 * Returns the matrices for normals, or NULL if normals are not posed. Call it
 * after fixed_palette_make(), whose matrices often serve for both.
 */
static const struct fixed_matrix *make_normal_matrices(
	const struct instance *instance, const struct drawable *drawable)
{
	const struct drawable_fixed *fixed = drawable->fixed;
	const mat4 *palette = instance->normal_palette[drawable->skin];

	if (instance->hold_normals || !fixed->normal) {
		return NULL;
	}
	if (palette == (const mat4 *)instance->palette[drawable->skin]) {
		return fixed->matrix;
	}
	fixed_palette_make_normals(
		&fixed->skin, &fixed->placement, palette, fixed->normal_matrix);
	return fixed->normal_matrix;
}

static void pose_skin(const struct instance *instance,
	struct drawable *drawable, bool with_tangents)
{
	struct drawable_fixed *fixed = drawable->fixed;

	fixed_skin_set_cap(&fixed->skin, instance->max_influences);
	if (drawable->morphed && !set_skin_weights(instance, drawable)) {
		fixed->overflowed = true;
		return;
	}
	fixed->overflowed = fixed_palette_make(&fixed->skin,
		(const mat4 *)instance->palette[drawable->skin], fixed->matrix,
		&fixed->placement);
	if (!fixed->overflowed) {
		run_skin(fixed, drawable->posed_lod,
			make_normal_matrices(instance, drawable), with_tangents);
	}
}

static void pose_morph(const struct instance *instance,
	struct drawable *drawable, bool with_tangents)
{
	struct drawable_fixed *fixed = drawable->fixed;
	struct fixed_morph *morph = &fixed->morph;

	fixed->overflowed =
		fixed_morph_set_weights(morph, weights_of(instance, drawable));
	if (fixed->overflowed) {
		return;
	}
	fixed->placement = morph->placement;
	fixed_morph_run(morph, fixed->loops, FIXED_POSITION, fixed->position);
	if (fixed->normal) {
		fixed_morph_run(
			morph, fixed->loops, FIXED_NORMAL, fixed->normal);
	}
	if (with_tangents) {
		fixed_morph_run(
			morph, fixed->loops, FIXED_TANGENT, fixed->tangent);
	}
}

static void pose_keys(const struct instance *instance,
	struct drawable *drawable, bool with_tangents)
{
	struct drawable_fixed *fixed = drawable->fixed;
	const struct fixed_loops *loops = fixed->loops;
	struct fixed_keys_frame frame;

	fixed->overflowed = fixed_keys_find(fixed->keys,
				    weights_of(instance, drawable), &frame) != 0;
	if (fixed->overflowed) {
		return;
	}
	fixed_keys_run(
		fixed->keys, loops, &frame, FIXED_POSITION, fixed->position);
	if (fixed->normal) {
		fixed_keys_run(fixed->keys, loops, &frame, FIXED_NORMAL,
			fixed->normal);
	}
	if (with_tangents) {
		fixed_keys_run(fixed->keys, loops, &frame, FIXED_TANGENT,
			fixed->tangent);
	}
}

void drawable_fixed_pose(
	const struct instance *instance, struct drawable *drawable)
{
	bool with_tangents = drawable->bumped;

	if (drawable->skin >= 0) {
		pose_skin(instance, drawable, with_tangents);
	} else if (drawable->fixed->keys && !drawable->external) {
		pose_keys(instance, drawable, with_tangents);
	} else if (drawable->morphed && !drawable->external) {
		pose_morph(instance, drawable, with_tangents);
	}
}
