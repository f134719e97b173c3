#include "app/character/run/ground.h"

#include "app/character/run/feet.h"
#include "app/character/state/entry.h"
#include "app/character/state/machine.h"

#include <string.h>

/*
 * Returns how many seconds of the clip pass in a second: 0 after its end, below
 * 0 while it plays backwards.
 */
static float clip_rate(const struct character_state *state,
	const struct character_entry *entry, float step_s)
{
	float duration_s = character_entry_duration_s(entry);

	if (state->repeat == CLIP_LOOP || step_s <= 0) {
		return *state->rate;
	}
	return (clip_time(entry->time_s, duration_s, state->repeat) -
		       clip_time(entry->before_s, duration_s, state->repeat)) /
		step_s;
}

/* Computes the mean speed of the clips over the ground, by their weights. */
static void blend_speeds(const struct character *character, float out[2])
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];

	out[0] = out[1] = 0;
	for (int i = 0; i < state->entry_count; i++) {
		const struct character_entry *entry = &state->entry[i];

		for (int axis = 0; axis < 2; axis++) {
			out[axis] += entry->weight *
				clip_rate(state, entry, character->step_s) *
				entry->of->ground_m_per_s[axis];
		}
	}
}

/*
 * Returns the foot on the ground: the lower one if it is low enough, else -1.
 */
static int find_planted(const struct character *character)
{
	const struct character_motion *motion = &character->motion;
	mat4 *world = character->instance->world;
	float height[2];
	int lower;

	for (int i = 0; i < 2; i++) {
		height[i] = world[motion->foot[i]][3][1] - motion->low_m[i];
	}
	lower = height[0] <= height[1] ? 0 : 1;
	return height[lower] < motion->near_m ? lower : -1;
}

static void follow_feet(struct character *character)
{
	struct character_motion *motion = &character->motion;
	mat4 *world = character->instance->world;
	float step_s = character->step_s;
	int planted = find_planted(character);

	if (motion->begun && planted >= 0 && step_s > 0) {
		const float *at = world[motion->foot[planted]][3];
		const float *before = motion->before[planted];

		motion->velocity[0] = (before[0] - at[0]) / step_s;
		motion->velocity[1] = (before[2] - at[2]) / step_s;
	}
	motion->planted = planted;
	for (int i = 0; i < 2; i++) {
		memcpy(motion->before[i], world[motion->foot[i]][3],
			sizeof(motion->before[i]));
	}
	motion->begun = true;
}

/*
 * Returns true if feet only sway, as in a clip that stands: if in a second they
 * move less than near_m, the height up to which a foot counts as planted.
 */
static bool is_standing(const struct character_motion *motion)
{
	float x = motion->velocity[0], z = motion->velocity[1];

	return x * x + z * z < motion->near_m * motion->near_m;
}

void character_ground_update(struct character *character)
{
	struct character_motion *motion = &character->motion;
	bool stands = false;

	if (character->feet) {
		character_feet_follow(character);
	}
	if (motion->foot[0] >= 0) {
		if (character_feet_level(character) == 0) {
			follow_feet(character);
		}
		stands = is_standing(motion);
	} else if (motion->speed) {
		motion->velocity[0] = 0;
		motion->velocity[1] = *motion->speed;
	} else {
		blend_speeds(character, motion->velocity);
	}
	for (int axis = 0; axis < 2; axis++) {
		motion->scroll[axis] =
			stands ? 0 : motion->velocity[axis] * character->step_s;
	}
}
