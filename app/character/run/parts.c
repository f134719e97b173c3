#include "app/character/run/parts.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/character/run/distance.h"
#include "app/character/run/pending.h"

#include <string.h>

/* Parts that share a joint may touch there. */
static bool are_joined(const struct model *model, int a, int b)
{
	return model->node[a].parent == b || model->node[b].parent == a;
}

static const float axes[3][3] = {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}};

static void place(const struct character *character,
	const struct character_part *part, struct pose *pose)
{
	const struct transform *rest =
		&character->instance->model->node[part->node].rest;
	struct transform *local = &pose->local[part->node];
	float all[4] = {0, 0, 0, 1}, turn[4], offset[3];

	for (int i = 0; i < 3; i++) {
		int which = part->order[i];

		quat_from_axis_angle(axes[which],
			part->freedom[which].value * (SCALAR_PI / 180), turn);
		quat_multiply(all, turn, all);
	}
	quat_multiply(rest->rotation, all, local->rotation);
	for (int i = 0; i < 3; i++) {
		offset[i] = rest->translation[i] +
			part->freedom[CHARACTER_X + i].value;
	}
	if (part->rotates_first) {
		quat_rotate(all, offset, offset);
	}
	memcpy(local->translation, offset, sizeof(offset));
	pose->animated[part->node] = true;
}

static void follow(struct character_part *part)
{
	for (int i = 0; i < CHARACTER_FREEDOMS; i++) {
		struct character_freedom *freedom = &part->freedom[i];

		if (part->follows[i]) {
			freedom->value = scalar_clamp(
				*part->follows[i], freedom->low, freedom->high);
		}
	}
}

static void line_of(const struct character *character,
	const struct character_part *part, float a[3], float b[3])
{
	mat4 *world = character->instance->world;

	memcpy(a, world[part->node][3], sizeof(float[3]));
	matrix_apply(world[part->node], part->tip, b);
}

/* How far the guarded parts are inside each other and the ground, in all. */
static float depth_of(const struct character *character)
{
	float depth = 0;

	for (int i = 0; i < character->part_count; i++) {
		const struct character_part *one = &character->part[i];
		float a[3], b[3];

		if (one->radius_m <= 0) {
			continue;
		}
		line_of(character, one, a, b);
		depth += scalar_clamp(character->ground_m + one->radius_m -
				(a[1] < b[1] ? a[1] : b[1]),
			0, 1e6f);
		for (int j = 0; j < i; j++) {
			const struct character_part *other = &character->part[j];
			float c[3], d[3];

			if (other->radius_m <= 0 ||
				are_joined(character->instance->model,
					one->node, other->node)) {
				continue;
			}
			line_of(character, other, c, d);
			depth += scalar_clamp(one->radius_m + other->radius_m -
					character_line_distance(a, b, c, d),
				0, 1e6f);
		}
	}
	return depth;
}

static void place_all(struct character *character)
{
	for (int i = 0; i < character->part_count; i++) {
		place(character, &character->part[i],
			&character->instance->pose);
	}
}

/* Moves a degree of freedom unless its part would go into something. */
static void move(struct character *character, struct character_part *part,
	struct character_freedom *freedom, bool guarded)
{
	struct instance *instance = character->instance;
	float before = freedom->value, depth = 0;

	if (guarded) {
		place_all(character);
		instance_update_nodes(instance);
		depth = depth_of(character);
	}
	freedom->value = scalar_clamp(
		before + freedom->moved, freedom->low, freedom->high);
	freedom->moved = 0;
	if (guarded) {
		place(character, part, &instance->pose);
		instance_update_nodes(instance);
		if (depth_of(character) > depth + 1e-5f) {
			freedom->value = before;
		}
	}
}

void character_parts_run(struct character *character, void *unused)
{
	bool guarded = false;

	(void)unused;
	for (int i = 0; i < character->part_count; i++) {
		follow(&character->part[i]);
		guarded = guarded || character->part[i].radius_m > 0;
	}
	for (int i = 0; i < character->part_count; i++) {
		struct character_part *part = &character->part[i];

		for (int f = 0; f < CHARACTER_FREEDOMS; f++) {
			if (part->freedom[f].moved != 0) {
				move(character, part, &part->freedom[f],
					guarded);
			}
		}
	}
	place_all(character);
}

/* A point and a rotation of the world in the frame of a node, or of none. */
static void to_frame(const struct instance *instance, int node,
	const float point[3], const float rotation[4], struct transform *out)
{
	float back[4] = {0, 0, 0, 1}, offset[3];
	float scale = 1;

	memcpy(offset, point, sizeof(offset));
	if (node >= 0) {
		matrix_rotation(instance->world[node], back);
		quat_conjugate(back, back);
		vec_subtract(point, instance->world[node][3], offset);
		scale = matrix_scale((const mat4 *)&instance->world[node]);
	}
	quat_rotate(back, offset, offset);
	for (int i = 0; i < 3; i++) {
		out->translation[i] = scale > 0 ? offset[i] / scale : offset[i];
	}
	quat_multiply(back, rotation, out->rotation);
}

void character_part_attach(struct character *character,
	struct character_part *part, int holder, float within_m)
{
	struct instance *instance = character->instance;
	float away[3], rotation[4];

	instance_update_nodes(instance);
	if (holder < 0) {
		part->holder = -1;
		return;
	}
	vec_subtract(instance->world[part->node][3], instance->world[holder][3],
		away);
	if (within_m > 0 && vec_length(away) > within_m) {
		return;
	}
	matrix_rotation(instance->world[part->node], rotation);
	to_frame(instance, holder, instance->world[part->node][3], rotation,
		&part->held);
	part->holder = holder;
}

void character_part_drop(
	struct character *character, struct character_part *part)
{
	struct instance *instance = character->instance;

	instance_update_nodes(instance);
	memcpy(part->held.translation, instance->world[part->node][3],
		sizeof(part->held.translation));
	part->held.translation[1] = part->rest_m;
	/* It stands upright, turned as it was. */
	matrix_rotation(instance->world[part->node], part->held.rotation);
	part->held.rotation[0] = part->held.rotation[2] = 0;
	quat_normalize(part->held.rotation);
	part->holder = CHARACTER_GROUND;
}

void character_attached_run(struct character *character, void *unused)
{
	struct instance *instance = character->instance;
	struct pose *pose = &instance->pose;

	(void)unused;
	for (int i = 0; i < character->part_count; i++) {
		struct character_part *part = &character->part[i];
		int parent = instance->model->node[part->node].parent;
		float point[3], rotation[4];

		if (part->holder == -1) {
			continue;
		}
		memcpy(point, part->held.translation, sizeof(point));
		memcpy(rotation, part->held.rotation, sizeof(rotation));
		if (part->holder >= 0) {
			mat4 *holder = &instance->world[part->holder];

			matrix_apply(*holder, point, point);
			matrix_rotation(*holder, rotation);
			quat_multiply(rotation, part->held.rotation, rotation);
		}
		to_frame(instance, parent, point, rotation,
			&pose->local[part->node]);
		pose->animated[part->node] = true;
		pose_world_from(pose, instance->model, NULL, part->node,
			instance->world);
	}
}

static void begin_step(struct character *character,
	struct character_sequence *sequence, struct character_step *step)
{
	sequence->now = step;
	for (struct character_goal *goal = step ? step->goal : NULL; goal;
		goal = goal->next) {
		goal->from =
			character->part[goal->part].freedom[goal->freedom].value;
	}
}

void character_sequence_start(struct character *character,
	struct character_sequence *sequence, bool repeats)
{
	sequence->elapsed_s = 0;
	sequence->repeats = repeats || sequence->repeat;
	begin_step(character, sequence, sequence->step);
}

void character_sequence_stop(struct character_sequence *sequence)
{
	sequence->now = NULL;
}

static void blend_step(
	struct character *character, struct character_step *step, float u)
{
	float eased = ease_at(EASE_CUBIC, u);

	for (struct character_goal *goal = step->goal; goal; goal = goal->next) {
		struct character_freedom *freedom =
			&character->part[goal->part].freedom[goal->freedom];

		freedom->value = u >= 1
			? goal->value
			: goal->from + (goal->value - goal->from) * eased;
	}
}

void character_sequence_run(struct character *character, void *what)
{
	struct character_sequence *sequence = what;
	int steps = 0;

	sequence->elapsed_s += sequence->now ? character->step_s : 0;
	/* A slow frame may end several steps. */
	while (sequence->now &&
		sequence->elapsed_s >= sequence->now->duration_s &&
		steps++ < CHARACTER_PENDING_MAX) {
		struct character_step *step = sequence->now;

		blend_step(character, step, 1);
		character_pending_add(character, step->then, 1);
		sequence->elapsed_s -= step->duration_s;
		begin_step(character, sequence,
			step->next                  ? step->next
				: sequence->repeats ? sequence->step
						    : NULL);
	}
	if (sequence->now) {
		blend_step(character, sequence->now,
			sequence->elapsed_s / sequence->now->duration_s);
	}
}
