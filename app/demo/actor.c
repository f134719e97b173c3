#include "app/demo/actor.h"

#include "app/scene/draw/draw.h"

#include <errno.h>
#include <stdio.h>

int actor_load(struct actor *actor, const struct demo_env *env)
{
	size_t memory_bytes =
		env->memory_bytes ? env->memory_bytes : MODEL_MEMORY_BYTES;
	struct bounds bounds;
	int error;

	*actor = (struct actor){0};
	error = model_load_within(
		env->model_path, memory_bytes, env->log, &actor->model);
	if (error) {
		return error;
	}
	error = instance_create(
		actor->model, env->kernel, env->log, &actor->instance);
	if (error) {
		goto fail_model;
	}
	actor->influence_cap = env->influence_cap;
	actor->lod = env->lod;
	bounds = bounds_of_instance(actor->instance);
	actor->extent = bounds_extent(&bounds);
	actor->interpolation = env->interpolation;
	error = clip_cursor_init(
		&actor->cursor, actor->model, &actor->instance->arena);
	if (!error) {
		error = fade_init(
			&actor->fade, actor->model, &actor->instance->arena);
	}
	if (error) {
		log_error(env->log,
			"%s: there is not enough memory to play the model",
			env->model_path);
		goto fail_instance;
	}
	error = texture_set_create(
		&actor->textures, actor->model, env->gl, env->target, env->log);
	if (!error) {
		return 0;
	}
fail_instance:
	instance_destroy(actor->instance);
fail_model:
	model_destroy(actor->model);
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

int actor_init_stage(const struct demo_env *env, const struct bounds *bounds,
	struct camera_framing framing, struct stage *stage)
{
	framing.aspect = (float)env->width / (float)env->height;
	return stage_init(
		stage, env->gl, bounds, &framing, env->target, env->log);
}

void actor_draw(const struct actor *actor, const struct stage *stage,
	const struct gl *gl, int width, int height)
{
	stage_begin(stage, gl, width, height);
	stage_shadow_begin(stage, gl);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADOW);
	stage_shadow_end(stage, gl);
	draw_instance(gl, actor->instance, &actor->textures, DRAW_SHADED);
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
	actor_choose_lod(actor, camera, picture_height);
}

void actor_choose_lod(
	struct actor *actor, const struct camera *camera, int picture_height)
{
	struct lod lod = lod_relax(&actor->lod, actor->min_error_px);

	lod_choose(actor->instance, &lod,
		lod_px_per_unit(actor->instance, camera, actor->extent,
			picture_height));
}

void actor_label_lod(const struct actor *actor, struct hud_group *group)
{
	char value[32];

	if (actor->instance->max_influences > 0) {
		snprintf(value, sizeof(value), "at most %d",
			actor->instance->max_influences);
		hud_group_text(group, "influences", value);
	}
}

const char *actor_technique(const struct instance *instance)
{
	bool skinned = false, morphed = false;

	for (int i = 0; i < instance->drawable_count; i++) {
		skinned = skinned || instance->drawable[i].skin >= 0;
		morphed = morphed || instance->drawable[i].morphed;
	}
	return skinned && morphed ? "Skeletal + morph"
		: skinned         ? "Skeletal"
		: morphed         ? "Morphing"
				  : "Hierarchical";
}

int actor_find_bone(const struct model *model, const char *name,
	const struct log *log, int *out)
{
	*out = model_find_node(model, name);
	if (*out < 0) {
		log_error(log, "%s: the model has no bone named %s",
			model->path, name);
		return -EINVAL;
	}
	return 0;
}

void actor_pose(struct actor *actor, int clip, float time_s)
{
	struct pose *pose = &actor->instance->pose;

	if (clip < 0) {
		pose_rest(pose, actor->model);
		return;
	}
	clip_pose(&actor->model->clip[clip], time_s, actor->interpolation,
		&actor->cursor, pose);
}
