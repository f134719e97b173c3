#include "app/scene/instance/lod.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/scene/instance/batch/batch.h"
#include "platform/base/scalar.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

enum {
	LEVEL_MAX = 99
};

/* The factor by which px_per_unit may change before a new choice is made. */
static const float hysteresis = 1.1f;
/* How far a surface extends beyond its joints, as a fraction of the extent. */
static const float joint_margin = 0.06f;
/*
 * The first joint tells how large a skin is, unless it is scaled by less than
 * this part of the greatest scale of a joint.
 */
static const float least_share = 0.5f;

bool lod_parse(const char *text, struct lod *out)
{
	static const char level[] = "level:";
	char *end;

	if (strcmp(text, "auto") == 0) {
		*out = (struct lod){.kind = LOD_AUTO};
		return true;
	}
	if (strcmp(text, "off") == 0) {
		*out = (struct lod){.kind = LOD_ALL};
		return true;
	}
	if (strncmp(text, level, sizeof(level) - 1) == 0) {
		long number = strtol(text + sizeof(level) - 1, &end, 10);

		*out = (struct lod){.kind = LOD_LEVEL, .level = (int)number};
		return end > text + sizeof(level) - 1 && !*end && number >= 0 &&
			number <= LEVEL_MAX;
	}
	*out = (struct lod){.kind = LOD_ERROR, .error_px = strtof(text, &end)};
	return end > text && !*end && out->error_px > 0.0f &&
		out->error_px <= 100.0f;
}

static float error_px(const struct lod *lod)
{
	return lod->kind == LOD_AUTO ? LOD_ERROR_PX : lod->error_px;
}

struct lod lod_relax(const struct lod *lod, float min_px)
{
	bool relaxes = (lod->kind == LOD_AUTO || lod->kind == LOD_ERROR) &&
		min_px > error_px(lod);

	return relaxes ? (struct lod){.kind = LOD_ERROR, .error_px = min_px}
		       : *lod;
}

static float depth_of(
	const float point[3], const float eye[3], const float forward[3])
{
	float offset[3];

	vec_subtract(point, eye, offset);
	return vec_dot(offset, forward);
}

/* The eye of a camera and the direction in which it looks. */
struct view {
	float eye[3], forward[3];
};

static struct view view_of(const struct camera *camera)
{
	struct view view;

	camera_eye(camera, view.eye);
	for (int axis = 0; axis < 3; axis++) {
		view.forward[axis] = (camera->target[axis] - view.eye[axis]) /
			camera->distance;
	}
	return view;
}

/* The depth of the joint nearest to the eye, at most the given depth. */
static float nearest_joint(
	const struct instance *instance, const struct view *view, float max)
{
	const struct model *model = instance->model;
	float nearest = max;

	for (int i = 0; i < model->skin_count; i++) {
		const struct model_skin *skin = &model->skin[i];

		for (int j = 0; j < skin->joint_count; j++) {
			float at[3], depth;

			instance_node_position(instance, skin->joint[j], at);
			depth = depth_of(at, view->eye, view->forward);
			nearest = scalar_min(depth, nearest);
		}
	}
	return nearest;
}

/* Returns the least depth of the box around a drawable without a skin. */
static float nearest_of_box(const struct instance *instance,
	const struct drawable *drawable, const struct view *view)
{
	const vec4 *world = instance->world[drawable->node];
	float at[3], depth;

	memcpy(at, world[3], sizeof(at));
	for (int i = 0; i < 3; i++) {
		vec_add_scaled(at, world[i], drawable->box_middle[i], at);
	}
	vec_add_scaled((const float[3]){0, 0, 0}, at, instance->unit_scale, at);
	depth = depth_of(at, view->eye, view->forward);
	for (int i = 0; i < 3; i++) {
		depth -= scalar_abs(vec_dot(world[i], view->forward)) *
			drawable->box_half[i] * instance->unit_scale;
	}
	return depth;
}

float lod_px_per_unit_at(
	const struct camera *camera, float depth, int picture_height)
{
	float least = 0.05f * camera->distance;

	return 0.5f * (float)picture_height /
		(camera_tan_half(camera->yfov_rad) * scalar_max(depth, least));
}

float lod_px_per_unit(const struct instance *instance,
	const struct camera *camera, float extent, int picture_height)
{
	struct view view = view_of(camera);
	float nearest = FLT_MAX;
	bool skinned = false;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];
		float depth;

		skinned = skinned || drawable->skin >= 0;
		if (drawable->skin < 0 && !drawable->hidden) {
			depth = nearest_of_box(instance, drawable, &view);
			nearest = scalar_min(depth, nearest);
		}
	}
	if (skinned) {
		float depth = nearest_joint(instance, &view, camera->distance) -
			joint_margin * extent;

		nearest = scalar_min(depth, nearest);
	}
	return lod_px_per_unit_at(camera, nearest, picture_height);
}

float lod_px_per_unit_of_box(const struct bounds *box,
	const struct camera *camera, int picture_height)
{
	struct view view = view_of(camera);
	float at[3], depth;

	bounds_center(box, at);
	depth = depth_of(at, view.eye, view.forward);
	for (int i = 0; i < 3; i++) {
		depth -= scalar_abs(view.forward[i]) * 0.5f *
			(box->high[i] - box->low[i]);
	}
	return lod_px_per_unit_at(camera, depth, picture_height);
}

float lod_error_units(
	const struct instance *instance, const struct drawable *drawable)
{
	const mat4 *joint;
	float first, least;

	if (drawable->skin < 0) {
		return instance->unit_scale *
			matrix_greatest_scale(
				(const mat4 *)&instance->world[drawable->node],
				1);
	}
	joint = (const mat4 *)instance->palette[drawable->skin];
	first = matrix_greatest_scale(joint, 1);
	least = least_share *
		matrix_greatest_scale(joint,
			instance->model->skin[drawable->skin].joint_count);
	return scalar_max(first, least);
}

/* Returns how many of the lists, finest first, have at most this error. */
static int coarsest(const struct batch_lod *list, int count, float error)
{
	int lod = 0;

	while (lod < count && list[lod].error <= error) {
		lod++;
	}
	return lod;
}

/*
 * Returns the setting's limit in the unit of the model's positions, of which
 * one has px pixels, or -1 if the setting does not limit errors.
 */
static float allowed_error(const struct lod *lod, float px)
{
	return (lod->kind == LOD_AUTO || lod->kind == LOD_ERROR) && px > 0.0f
		? error_px(lod) / px
		: -1.0f;
}

static void choose_of_drawable(
	struct drawable *drawable, const struct lod *lod, float error)
{
	const struct batch *batch = drawable->batch;
	int level = lod->kind == LOD_LEVEL ? lod->level : 0;
	int shadow;

	level = level < batch->lod_count ? level : batch->lod_count;
	drawable->bumps_hidden = false;
	if (error < 0.0f) {
		drawable->lod = drawable->shadow_lod = level;
		return;
	}
	drawable->lod = coarsest(batch->lod, batch->lod_count, error);
	drawable->bumps_hidden =
		drawable->bump_texels * error > LOD_BUMP_TEXELS * error_px(lod);
	error *= LOD_SHADOW_TOLERANCE;
	drawable->shadow_lod = coarsest(batch->lod, batch->lod_count, error);
	shadow = coarsest(batch->shadow, batch->shadow_count, error);
	drawable->shadow_list = shadow > 0 ? shadow - 1 : batch->shadow_count;
}

/*
 * The lists of gathered batches have vertices of their own, which updates copy
 * only for those that are drawn.
 */
static void gather_if_changed(
	struct drawable *drawable, int lod, int shadow_lod, int shadow_list)
{
	bool changed = lod != drawable->lod ||
		shadow_lod != drawable->shadow_lod ||
		shadow_list != drawable->shadow_list;

	if (changed && (drawable->morphed || drawable->skin >= 0)) {
		batch_gather(drawable);
	}
}

void lod_choose(
	struct instance *instance, const struct lod *setting, float px_per_unit)
{
	float held = instance->lod_px_per_unit, units = 0.0f;
	int skin = -1; /* of which units is known */

	if (px_per_unit > held * hysteresis || px_per_unit * hysteresis < held) {
		instance->lod_px_per_unit = px_per_unit;
	}
	for (int i = 0; i < instance->drawable_count; i++) {
		struct drawable *drawable = &instance->drawable[i];
		int lod = drawable->lod, shadow_lod = drawable->shadow_lod;
		int shadow_list = drawable->shadow_list;

		drawable->lod = drawable->shadow_lod = 0;
		drawable->shadow_list = 0;
		if (drawable->batch_count == 0) {
			continue;
		}
		if (drawable->skin < 0 || drawable->skin != skin) {
			units = lod_error_units(instance, drawable);
			skin = drawable->skin;
		}
		choose_of_drawable(drawable, setting,
			allowed_error(
				setting, units * instance->lod_px_per_unit));
		gather_if_changed(drawable, lod, shadow_lod, shadow_list);
	}
}

long lod_triangles(const struct instance *instance)
{
	long corners = 0;

	for (int i = 0; i < instance->drawable_count; i++) {
		const struct drawable *drawable = &instance->drawable[i];

		if (!drawable->hidden) {
			corners += drawable->lod > 0
				? drawable->batch[0].lod[drawable->lod - 1].index_count
				: drawable->primitive->index_count;
		}
	}
	return corners / 3;
}
