#include "app/character/parts/parts.h"

#include "app/anim/math/quat.h"
#include "app/character/parts/guard.h"
#include "app/character/parts/held.h"
#include "app/character/run/pending.h"

#include <string.h>

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

		if (part->freedom[which].value == 0) {
			continue;
		}
		quat_from_axis_angle(axes[which],
			part->freedom[which].value * (SCALAR_PI / 180), turn);
		quat_multiply(all, turn, all);
	}
	quat_multiply(rest->rotation, all, local->rotation);
	for (int i = 0; i < 3; i++) {
		offset[i] = rest->translation[i] +
			part->freedom[CHARACTER_X + i].value * part->metre[i];
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
		character_held_place(character);
		depth = character_guard_depth(character);
	}
	freedom->value = scalar_clamp(
		before + freedom->moved, freedom->low, freedom->high);
	freedom->moved = 0;
	if (guarded) {
		place(character, part, &instance->pose);
		instance_update_nodes(instance);
		character_held_place(character);
		if (character_guard_depth(character) >
			depth + 1e-5f * character->metre) {
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
		guarded = guarded || character->part[i].guard_count > 0;
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
