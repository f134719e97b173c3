#include "app/character/parts/held.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"

#include <string.h>

static const float gravity_m_s2 = 9.81f;
/* A free part this near to its height on the ground lies there. */
static const float lies_m = 1e-4f;
/* A part lies on the model's ground if its lowest vertex is this near to it. */
static const float near_ground_m = 0.02f;
/* seconds in which a part is pulled to its place at the holder */
static const float pull_s = 0.2f;

/* A mirrored node is a rotated one whose z axis has the opposite direction. */
static bool is_mirrored(const struct instance *instance, int node)
{
	return matrix_determinant((const mat4 *)&instance->world[node]) < 0;
}

/*
 * Converts a point and a rotation of the world to the frame of a node; node -1
 * is the world itself.
 */
static void to_frame(const struct instance *instance, int node,
	const float point[3], const float rotation[4], struct transform *out)
{
	float back[4] = {0, 0, 0, 1}, offset[3];
	bool mirrored = node >= 0 && is_mirrored(instance, node);
	float scale = 1;

	memcpy(offset, point, sizeof(offset));
	if (node >= 0) {
		matrix_rotation(instance->world[node], back);
		quat_conjugate(back, back);
		vec_subtract(point, instance->world[node][3], offset);
		scale = matrix_scale((const mat4 *)&instance->world[node]);
	}
	quat_rotate(back, offset, offset);
	offset[2] = mirrored ? -offset[2] : offset[2];
	for (int i = 0; i < 3; i++) {
		out->translation[i] = scale > 0 ? offset[i] / scale : offset[i];
	}
	quat_multiply(back, rotation, out->rotation);
	bone_mirror_rotation(mirrored, out->rotation);
}

void character_part_attach(struct character *character,
	struct character_part *part, const struct character_action *action)
{
	struct instance *instance = character->instance;
	int holder = action->detail;
	float at[3], away[3], rotation[4];

	instance_update_nodes(instance);
	if (holder < 0) {
		part->holder = -1;
		return;
	}
	matrix_apply(instance->world[holder], action->place, at);
	vec_subtract(instance->world[part->node][3], at, away);
	if (part->holder == holder ||
		(action->amount > 0 && vec_length(away) > action->amount)) {
		return;
	}
	matrix_rotation(instance->world[part->node], rotation);
	to_frame(instance, holder, instance->world[part->node][3], rotation,
		&part->held);
	part->holder = holder;
	part->fall_m = part->pull_s = 0;
	if (action->has_place) {
		vec_subtract(part->held.translation, action->place, part->pull);
		memcpy(part->held.translation, action->place,
			sizeof(action->place));
		part->pull_s = pull_s;
	}
}

void character_held_init(
	const struct instance *instance, struct character_part *part)
{
	const struct model *model = instance->model;
	mat4 *world = instance->world;
	bool found = false;

	matrix_rotation(world[part->node], part->upright);
	part->rest_m = part->low_m = world[part->node][3][1];
	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct model_primitive *shape = drawable->primitive;

		if (drawable->skin >= 0 ||
			!model_is_below(model, drawable->node, part->node)) {
			continue;
		}
		for (int v = 0; v < shape->vertex_count; v++) {
			float at[3];

			matrix_apply(
				world[drawable->node], shape->position[v], at);
			if (!found || at[1] < part->low_m) {
				part->low_m = at[1];
				found = true;
			}
		}
	}
}

/* Returns the height of a part's pivot above what the part lies on. */
static float height_above(
	const struct character *character, const struct character_part *part)
{
	bool floats = scalar_abs(part->low_m - character->ground_m) >
		near_ground_m * character->metre;

	return part->rest_m - (floats ? part->low_m : character->ground_m);
}

/* Computes the rotation of the part, turned as it is now, that is upright. */
static void upright(const struct instance *instance,
	const struct character_part *part, float out[4])
{
	float now[4], back[4];

	matrix_rotation(instance->world[part->node], now);
	quat_conjugate(part->upright, back);
	quat_multiply(now, back, out);
	out[0] = out[2] = 0;
	quat_normalize(out);
	quat_multiply(out, part->upright, out);
}

/*
 * Finds the height at which a vertical line through a point meets a triangle.
 * Returns false if it does not.
 */
static bool height_at(float corner[3][3], const float at[3], float *height)
{
	const float *a = corner[0], *b = corner[1], *c = corner[2];
	float area =
		(b[0] - a[0]) * (c[2] - a[2]) - (c[0] - a[0]) * (b[2] - a[2]);
	float u, v;

	if (area == 0) {
		return false;
	}
	u = ((at[0] - a[0]) * (c[2] - a[2]) - (c[0] - a[0]) * (at[2] - a[2])) /
		area;
	v = ((b[0] - a[0]) * (at[2] - a[2]) - (at[0] - a[0]) * (b[2] - a[2])) /
		area;
	*height = a[1] + u * (b[1] - a[1]) + v * (c[1] - a[1]);
	return u >= 0 && v >= 0 && u + v <= 1;
}

/*
 * Finds the height of a rigid node's highest triangle below a point. Returns
 * false if there is none.
 */
static bool find_support(const struct instance *instance, int node,
	const float at[3], float *height)
{
	bool found = false;

	for (int d = 0; d < instance->drawable_count; d++) {
		const struct drawable *drawable = &instance->drawable[d];
		const struct model_primitive *shape = drawable->primitive;

		if (drawable->node != node || drawable->skin >= 0) {
			continue;
		}
		for (int i = 0; i + 2 < shape->index_count; i += 3) {
			float corner[3][3], y;

			for (int k = 0; k < 3; k++) {
				matrix_apply(instance->world[node],
					shape->position[shape->index[i + k]],
					corner[k]);
			}
			if (height_at(corner, at, &y) && y <= at[1] &&
				(!found || y > *height)) {
				*height = y;
				found = true;
			}
		}
	}
	return found;
}

void character_part_drop(
	struct character *character, struct character_part *part, int node)
{
	struct instance *instance = character->instance;
	float above_m = height_above(character, part);
	float ground = character->ground_m, support = ground, from;
	float point[3], rotation[4];

	instance_update_nodes(instance);
	memcpy(point, instance->world[part->node][3], sizeof(point));
	if (part->holder < 0 &&
		scalar_abs(point[1] - (ground + above_m)) <
			lies_m * character->metre) {
		return; /* it lies on the ground already */
	}
	upright(instance, part, rotation);
	from = point[1];
	if (node >= 0 && find_support(instance, node, point, &support) &&
		support > ground) {
		part->holder = node;
	} else {
		support = ground;
		node = -1;
		part->holder = CHARACTER_GROUND;
	}
	point[1] = support + above_m;
	to_frame(instance, node, point, rotation, &part->held);
	part->fall_m = scalar_clamp(from - point[1], 0, 1e6f);
	part->fall_m_per_s = part->pull_s = 0;
}

static void place(struct instance *instance, const struct character_part *part)
{
	struct pose *pose = &instance->pose;
	float point[3], rotation[4];

	for (int i = 0; i < 3; i++) {
		point[i] = part->held.translation[i] +
			part->pull[i] * (part->pull_s / pull_s);
	}
	memcpy(rotation, part->held.rotation, sizeof(rotation));
	if (part->holder >= 0) {
		mat4 *holder = &instance->world[part->holder];
		float turn[4];

		matrix_apply(*holder, point, point);
		matrix_rotation(*holder, turn);
		bone_mirror_rotation(
			is_mirrored(instance, part->holder), rotation);
		quat_multiply(turn, rotation, rotation);
	}
	point[1] += part->fall_m;
	to_frame(instance, instance->model->node[part->node].parent, point,
		rotation, &pose->local[part->node]);
	pose->animated[part->node] = true;
	pose_world_from(
		pose, instance->model, NULL, part->node, instance->world);
}

static bool is_below(const struct model *model, int node, int top)
{
	while (node > top) {
		node = model->node[node].parent;
	}
	return node == top;
}

/* Returns true if a part moves with another one, by its holder or its parent. */
static bool goes_with(const struct model *model,
	const struct character_part *part, const struct character_part *other)
{
	return is_below(model, part->holder, other->node) ||
		is_below(model, model->node[part->node].parent, other->node);
}

/* Places a part that is held, after the held parts with which it goes. */
static void place_after_others(
	struct character *character, struct character_part *part)
{
	if (part->holder == -1 || part->placed) {
		return;
	}
	part->placed = true; /* now, as parts may hold each other */
	for (int i = 0; i < character->part_count; i++) {
		struct character_part *other = &character->part[i];

		if (goes_with(character->instance->model, part, other)) {
			place_after_others(character, other);
		}
	}
	place(character->instance, part);
}

void character_held_place(struct character *character)
{
	for (int i = 0; i < character->part_count; i++) {
		character->part[i].placed = false;
	}
	for (int i = 0; i < character->part_count; i++) {
		place_after_others(character, &character->part[i]);
	}
}

void character_held_run(struct character *character, void *unused)
{
	(void)unused;
	for (int i = 0; i < character->part_count; i++) {
		struct character_part *part = &character->part[i];

		part->pull_s = scalar_clamp(
			part->pull_s - character->step_s, 0, pull_s);
		if (part->holder != -1 && part->fall_m > 0) {
			part->fall_m_per_s += gravity_m_s2 * character->metre *
				character->step_s;
			part->fall_m = scalar_clamp(part->fall_m -
					part->fall_m_per_s * character->step_s,
				0, 1e6f);
		}
	}
	character_held_place(character);
}
