#include "app/demo/actor.h"

#include "app/model/levels/levels_file.h"
#include "app/model/model_keys.h"

#include <stdio.h>

static const float least_side = 0.4f; /* of a region; the picture has 2 */

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
	levels_prepare(actor->model, env->log);
	if (env->kernel->fixed) {
		model_keys_round(actor->model);
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

/*
 * The regions that labels leave free: beside them and below them. Returns their
 * number; if labels leave little of a small picture, it is the whole one.
 */
static int free_regions(const struct actor_framing *framing, int width,
	int height, struct camera_region out[2])
{
	int most = hud_group_rows_max(width, height);
	int rows = framing->label_rows < most ? framing->label_rows : most;
	int bars = framing->label_bars < rows ? framing->label_bars : rows;
	struct hud_group_extent labels =
		hud_group_extent_of(width, height, rows, bars);
	float bottom = 2.0f * (float)(framing->lines_below * labels.line) /
			(float)height -
		1.0f;

	float left = 2.0f * (float)labels.column / (float)width - 1.0f;
	float top = 1.0f - 2.0f * (float)labels.top / (float)height;
	int count = 0;

	if (bottom > 1.0f - least_side) {
		bottom = -1.0f; /* the labels are larger than the picture */
	}
	out[0] = (struct camera_region){-1.0f, 1.0f, bottom, 1.0f};
	if (framing->label_rows == 0) {
		return 1;
	}
	if (left < 1.0f - least_side) {
		out[count++] = (struct camera_region){left, 1.0f, bottom, 1.0f};
	}
	if (top > bottom + least_side) {
		out[count++] = (struct camera_region){-1.0f, 1.0f, bottom, top};
	}
	return count > 0 ? count : 1;
}

/* The region in which the box appears larger. */
struct camera_region actor_region(const struct actor_framing *framing,
	const struct bounds *bounds, int width, int height)
{
	struct camera_framing tried = framing->camera;
	struct camera_region region[2], best = {0.0f, 0.0f, 0.0f, 0.0f};
	int count = free_regions(framing, width, height, region);
	float least = 0.0f;

	tried.aspect = (float)width / (float)height;
	for (int i = 0; i < count; i++) {
		struct camera camera = camera_default();

		tried.region = region[i];
		camera_frame(&camera, bounds, &tried);
		if (i == 0 || camera.distance < least) {
			least = camera.distance;
			best = region[i];
		}
	}
	if (framing->labels_right) {
		best = (struct camera_region){
			-best.right, -best.left, best.bottom, best.top};
	}
	return best;
}

int actor_init_stage(struct demo_base *base, const struct demo_env *env,
	const struct bounds *bounds, const struct actor_framing *framing,
	struct stage *stage)
{
	struct camera_framing camera = framing->camera;

	base->framing = *framing;
	if (env->no_labels) {
		base->framing =
			(struct actor_framing){.camera = framing->camera};
	}
	camera.aspect = (float)base->width / (float)base->height;
	camera.region =
		actor_region(&base->framing, bounds, base->width, base->height);
	return stage_init(
		stage, env->gl, bounds, &camera, env->target, env->log);
}

void actor_resize_stage(struct demo_base *base, int width, int height)
{
	struct camera *camera = &base->stage.camera;
	struct camera_region region;
	struct bounds bounds;

	base->width = width;
	base->height = height;
	if (!camera->fit.on) {
		return;
	}
	for (int axis = 0; axis < 3; axis++) {
		bounds.low[axis] = camera->target[axis] - camera->fit.half[axis];
		bounds.high[axis] =
			camera->target[axis] + camera->fit.half[axis];
	}
	region = actor_region(&base->framing, &bounds, width, height);
	base->overlay_room = 0.0f;
	camera_set_region(camera, &region, base->framing.camera.margin,
		(float)width / (float)height);
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
