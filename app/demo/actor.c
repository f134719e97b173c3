#include "app/demo/actor.h"

#include "app/anim/math/vec.h"
#include "app/model/levels/levels_file.h"
#include "app/model/model_keys.h"
#include "app/scene/instance/instance_play.h"

#include <stdio.h>

/* Numbers of GL's matrices end at 32,768; this leaves room for the camera. */
static const float far_units = 32000.0f;

/* Says why nothing can be seen of a model that has triangles. */
static void warn_if_unseen(const struct actor *actor,
	const struct bounds *bounds, const struct demo_env *env)
{
	float middle[3], away;
	char times[48] = "";

	bounds_center(bounds, middle);
	away = vec_length(middle);
	if (away <= far_units) {
		if (!(actor->extent > 0.0f)) {
			log_warning(env->log,
				"%s: all its vertices are in one place, so nothing of it can be seen: look for a scale of 0",
				env->model_path);
		}
		return;
	}
	/* So far out, rounding may leave the model no size. */
	if (actor->extent > 0.0f) {
		snprintf(times, sizeof(times), ", %.0f times its size",
			(double)(away / actor->extent));
	}
	log_warning(env->log,
		"%s: it stands %.0f m from the origin%s, where limber cannot draw it: move it to the origin",
		env->model_path, (double)(away / actor->instance->unit_scale),
		times);
}

/* Prepares what is played and drawn. Returns 0, or -errno after logging it. */
static int prepare_parts(struct actor *actor, const struct demo_env *env)
{
	int error = shadow_ground_find(&actor->ground, actor->instance);

	if (!error) {
		error = clip_cursor_init(
			&actor->cursor, actor->model, &actor->instance->arena);
	}
	if (error) {
		return memory_budget_fail(
			actor->model->budget, env->model_path, env->log);
	}
	return texture_set_create(
		&actor->textures, actor->model, env->gl, env->target, env->log);
}

static int load_model(
	const struct demo_env *env, size_t memory_bytes, struct model **out)
{
	int error =
		model_load_within(env->model_path, memory_bytes, env->log, out);

	if (error) {
		return error;
	}
	if (!model_has_triangles(*out)) {
		log_warning(env->log,
			"%s: it has no triangles, so the stage stays empty: export the model with its meshes",
			env->model_path);
	}
	error = levels_prepare(*out, env->log);
	if (!error && env->kernel->fixed) {
		error = model_keys_round(*out, env->log);
	}
	if (error) {
		model_destroy(*out);
	}
	return error;
}

int actor_load(struct actor *actor, const struct demo_env *env)
{
	struct bounds bounds;
	int error;

	*actor = (struct actor){0};
	error = load_model(env,
		env->memory_bytes ? env->memory_bytes : MODEL_MEMORY_BYTES,
		&actor->model);
	if (error) {
		goto fail;
	}
	error = instance_create_to_play(
		actor->model, env->kernel, env->log, &actor->instance);
	if (error) {
		goto fail_model;
	}
	actor->influence_cap = env->influence_cap;
	actor->lod = env->lod;
	bounds = bounds_of_instance(actor->instance);
	actor->extent = bounds_extent_of_model(actor->instance);
	actor->interpolation = env->interpolation;
	error = prepare_parts(actor, env);
	if (error) {
		goto fail_instance;
	}
	if (model_has_triangles(actor->model)) {
		warn_if_unseen(actor, &bounds, env);
	}
	return 0;

fail_instance:
	instance_destroy(actor->instance);
fail_model:
	model_destroy(actor->model);
fail:
	*actor = (struct actor){0};
	return error;
}

void actor_unload(struct actor *actor, const struct gl *gl)
{
	texture_set_destroy(&actor->textures, gl);
	instance_destroy(actor->instance);
	model_destroy(actor->model);
	*actor = (struct actor){0};
}

void actor_reduce(struct demo_base *base)
{
	const struct demo_reduction *reduction = &base->reduction;

	base->actor.influence_limit = reduction->max_influences;
	base->actor.min_error_px = reduction->error_px;
	base->actor.instance->hold_normals = reduction->hold_normals;
}

int actor_init_stage(struct demo_base *base, const struct demo_env *env,
	const struct bounds *bounds, float unit, const struct framing *framing,
	struct stage *stage)
{
	struct camera_framing camera = framing->camera;
	int error;

	base->framing = *framing;
	base->room_below = 0.0f;
	if (env->no_labels) {
		base->framing = (struct framing){.camera = framing->camera};
	}
	base->framing.frame_times = env->frame_times;
	camera.aspect = (float)base->width / (float)base->height;
	camera.region = framing_region(
		&base->framing, bounds, base->width, base->height);
	error = stage_init(
		stage, env->gl, bounds, unit, &camera, env->target, env->log);
	if (!error && base->actor.ground.in_plane) {
		stage_lower_floor(stage, bounds);
	}
	return error;
}

void actor_reframe_stage(struct demo_base *base, int width, int height)
{
	struct camera *camera = &base->stage.camera;
	struct camera_region region;
	struct bounds bounds;

	base->width = width;
	base->height = height;
	base->framing.below = base->below;
	if (!camera->fit.on) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		bounds.low[axis] = camera->target[axis] - camera->fit.half[axis];
		bounds.high[axis] =
			camera->target[axis] + camera->fit.half[axis];
	}
	region = framing_region(&base->framing, &bounds, width, height);
	base->room_below = 0.0f;
	camera_set_region(camera, &region, base->framing.camera.margin,
		(float)width / (float)height);
}

static void choose_lod(
	struct actor *actor, const struct camera *camera, int picture_height)
{
	struct lod lod = lod_relax(&actor->lod, actor->min_error_px);

	lod_choose(actor->instance, &lod,
		lod_px_per_unit(actor->instance, camera, actor->extent,
			picture_height));
}

void actor_update(
	struct actor *actor, const struct camera *camera, int picture_height)
{
	int cap = influence_cap_choose(&actor->influence_cap, actor->instance,
		camera, actor->extent, picture_height);
	int most = actor->influence_limit;

	actor->instance->max_influences =
		most > 0 && (cap == 0 || most < cap) ? most : cap;
	instance_update(actor->instance);
	choose_lod(actor, camera, picture_height);
	if (instance_is_stale(actor->instance)) {
		instance_update(actor->instance);
	}
}
