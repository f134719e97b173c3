#include "app/scene/instance/bounds.h"

#include "app/anim/clip.h"
#include "app/scene/instance/bounds_drawable.h"
#include "platform/base/interrupt.h"
#include "platform/base/scalar.h"

enum {
	CLIP_STEPS = 12,
	CLIP_STEPS_LEAST = 2,
	POSES_MAX = 104 /* samples of all clips together */
};

/*
 * A clip takes a model apart if its box becomes longer than this many times its
 * shortest one while no part is longer than that many times it.
 */
static const float apart_sides = 6.0f, part_sides = 2.0f;
/* A box smaller than this part of its distance from the origin is a point. */
static const float rounding_part = 1e-6f;

/* Also finds the longest side of the box of a single drawable. */
static struct bounds box_of_parts(
	const struct instance *instance, float *longest)
{
	struct bounds bounds = bounds_empty();

	*longest = 0.0f;
	for (int i = 0; i < instance->drawable_count; i++) {
		struct bounds one =
			bounds_of_drawable(instance, &instance->drawable[i]);
		float extent =
			bounds_is_empty(&one) ? 0.0f : bounds_extent(&one);

		*longest = scalar_max(extent, *longest);
		bounds_join(&bounds, &one);
	}
	return bounds;
}

struct bounds bounds_of_instance(const struct instance *instance)
{
	float unused;

	return box_of_parts(instance, &unused);
}

static void keep_longest(struct bounds_sides *sides, const struct bounds *now)
{
	for (int axis = 0; axis < 3; axis++) {
		float side = now->high[axis] - now->low[axis];

		sides->side[axis] = scalar_max(side, sides->side[axis]);
	}
}

/* Takes a part of the way out of a box. */
static void take_back(struct bounds *bounds, const float way[2], float part)
{
	for (int i = 0; i < 2; i++) {
		bounds->low[2 * i] -= way[i] * part;
		bounds->high[2 * i] -= way[i] * part;
	}
}

/* What a clip's samples say of parts that leave the others behind. */
struct apart {
	struct bounds home; /* the smallest box */
	float largest;      /* the longest side of any box */
	float largest_at;   /* and its time */
	float part;         /* the longest side of a single drawable */
};

static void note_parts(
	struct apart *apart, const struct bounds *now, float part, float time_s)
{
	float extent = bounds_is_empty(now) ? 0.0f : bounds_extent(now);

	if (bounds_is_empty(&apart->home) ||
		extent < bounds_extent(&apart->home)) {
		apart->home = *now;
	}
	if (extent > apart->largest) {
		apart->largest = extent;
		apart->largest_at = time_s;
	}
	apart->part = scalar_max(part, apart->part);
}

/* Whether a drawable of the last update is still where the model was small. */
static bool stays_home(
	const struct instance *instance, const struct bounds *home)
{
	float reach = bounds_extent(home);

	for (int i = 0; i < instance->drawable_count; i++) {
		struct bounds one =
			bounds_of_drawable(instance, &instance->drawable[i]);
		bool inside = !bounds_is_empty(&one);

		for (int axis = 0; axis < 3; axis++) {
			inside = inside &&
				one.low[axis] >= home->low[axis] - reach &&
				one.high[axis] <= home->high[axis] + reach;
		}
		if (inside) {
			return true;
		}
	}
	return false;
}

/* Cuts a box so that what stays at home can be seen, on the ground below it. */
static void cut(struct bounds *all, const struct bounds *home, float more)
{
	for (int axis = 0; axis < 3; axis++) {
		float low = home->low[axis] - (axis == 1 ? 0.0f : more);
		float high = home->high[axis] + more;

		all->low[axis] = scalar_max(low, all->low[axis]);
		all->high[axis] = scalar_min(high, all->high[axis]);
	}
}

/*
 * Returns the box where the model is smallest: in the clip or, if its parts are
 * apart all the time, perhaps at rest. May leave the instance at rest.
 */
static struct bounds find_home(
	struct instance *instance, const struct apart *apart)
{
	struct bounds home = apart->home;

	if (apart->largest > apart_sides * apart->part) {
		struct bounds rest;

		pose_rest(&instance->pose, instance->model);
		instance_update(instance);
		rest = bounds_of_instance(instance);
		if (!bounds_is_empty(&rest) &&
			bounds_extent(&rest) < bounds_extent(&home)) {
			home = rest;
		}
	}
	return home;
}

/*
 * If a part flies far away from others, as a rocket from its launch pad, or is
 * hidden far below, all would be specks. Cuts the box for the sake of those
 * that stay at home.
 */
static void cut_apart(struct instance *instance, int clip,
	const struct apart *apart, struct bounds *all)
{
	const struct model_clip *c = &instance->model->clip[clip];
	struct bounds home = find_home(instance, apart);
	float side = bounds_is_empty(&home) ? 0.0f : bounds_extent(&home);
	struct clip_cursor none = {0};

	if (apart->largest > apart_sides * side &&
		apart->part <= part_sides * side) {
		clip_sample(c, apart->largest_at, &none, &instance->pose);
		instance_update(instance);
		if (stays_home(instance, &home)) {
			cut(all, &home, apart_sides * side);
		}
	}
	if (apart->largest > apart_sides * apart->part ||
		apart->largest > apart_sides * side) {
		clip_sample(c, 0.0f, &none, &instance->pose);
		instance_update(instance);
	}
}

/*
 * Returns the box of a clip, without its way, at steps + 1 times, or of the
 * rest pose if clip is -1. The caller sets sides to zero before.
 */
static struct bounds sample_clip(struct instance *instance, int clip, int steps,
	const float way[2], struct bounds_sides *sides)
{
	struct apart apart = {.home = bounds_empty()};
	bool hold_normals = instance->hold_normals,
	     normal_mapping = instance->normal_mapping;
	struct bounds all = bounds_empty();
	struct clip_cursor none = {0};

	pose_rest(&instance->pose, instance->model);
	if (clip < 0) {
		instance_update(instance);
		return bounds_of_instance(instance);
	}
	for (int step = steps; step >= 0 && !interrupt_pending(); step--) {
		const struct model_clip *c = &instance->model->clip[clip];
		float time_s = c->duration_s * (float)step / (float)steps;
		struct bounds now;
		float part;

		clip_sample(c, time_s, &none, &instance->pose);
		/* Only the last sample's normals and tangents are kept. */
		instance->hold_normals = hold_normals || step > 0;
		instance->normal_mapping = normal_mapping && step == 0;
		instance_update(instance);
		now = box_of_parts(instance, &part);
		note_parts(&apart, &now, part, time_s);
		take_back(&now, way, clip_share(c, time_s));
		bounds_join(&all, &now);
		keep_longest(sides, &now);
	}
	if (way[0] == 0.0f && way[1] == 0.0f) {
		cut_apart(instance, clip, &apart, &all);
	}
	return all;
}

struct bounds bounds_of_clip(struct instance *instance, int clip)
{
	static const float in_place[2] = {0.0f, 0.0f};
	struct bounds_sides unused = {{0.0f}};

	return sample_clip(instance, clip, CLIP_STEPS, in_place, &unused);
}

struct bounds bounds_of_model(struct instance *instance, const float (*way)[2],
	struct bounds *clip, struct bounds_sides *sides)
{
	int count = instance->model->clip_count;
	int steps = count > 0 ? POSES_MAX / count - 1 : 0;
	struct bounds rest = sample_clip(instance, -1, 0, NULL, NULL);

	steps = steps > CLIP_STEPS         ? CLIP_STEPS
		: steps < CLIP_STEPS_LEAST ? CLIP_STEPS_LEAST
					   : steps;
	for (int i = 0; i < count; i++) {
		sides[i] = (struct bounds_sides){{0.0f}};
		clip[i] = sample_clip(instance, i, steps, way[i], &sides[i]);
	}
	return rest;
}

float bounds_extent_of_model(struct instance *instance)
{
	struct bounds rest = bounds_of_clip(instance, -1);
	float extent = bounds_extent(&rest), away = 0.0f;

	for (int axis = 0; axis < 3 && !bounds_is_empty(&rest); axis++) {
		away += scalar_abs(rest.low[axis]);
	}
	if (extent > rounding_part * away) {
		return extent;
	}
	for (int i = 0; i < instance->model->clip_count; i++) {
		struct bounds box = bounds_of_clip(instance, i);
		float side = bounds_extent(&box);

		extent = scalar_max(side, extent);
	}
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return extent > rounding_part * away ? extent : 0.0f;
}

struct bounds bounds_of_targets(struct instance *instance, int node)
{
	const struct model_node *n = &instance->model->node[node];
	int count =
		n->mesh < 0 ? 0 : instance->model->mesh[n->mesh].target_count;
	float *weight = &instance->pose.weight[n->weight_offset];
	struct bounds all = bounds_empty();

	for (int i = 0; i < count && i < POSES_MAX; i++) {
		struct bounds bounds;

		pose_rest(&instance->pose, instance->model);
		weight[i] = 1.0f;
		instance_update(instance);
		bounds = bounds_of_instance(instance);
		bounds_join(&all, &bounds);
	}
	pose_rest(&instance->pose, instance->model);
	instance_update(instance);
	return all;
}
