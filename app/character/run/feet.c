#include "app/character/run/feet.h"

#include "app/character/state/entry.h"
#include "platform/base/scalar.h"

#include <string.h>

/* Lengths are in heights of the figure. */
/* a foot held further than this from its animated place takes a step */
static const float far_offset = 0.03f;
static const float near_offset = 0.006f; /* the same while the figure stands */
static const float far_turn_rad = 0.3f;
/* a held point lets go above this many times planted_m */
static const float release = 2.5f;
static const float arc_least = 0.006f, arc_most = 0.04f;
/* height of a step's arc, as a part of the step's length */
static const float arc_share = 0.25f;
static const float still_per_s = 0.0605f; /* a slower figure stands */
static const float raise_per_s = 0.726f;  /* at most */
static const float step_duration_s = 0.25f;
/* time constant of the motion's velocity */
static const float smooth_s = 0.08f;

float character_feet_level(const struct character *character)
{
	float level = 0;

	for (const struct character_feet *feet = character->feet; feet;
		feet = feet->next) {
		level = scalar_max(feet->is.now, level);
	}
	return level;
}

static int find_lowest(const struct character_foot *foot)
{
	int lowest = 0;

	for (int i = 1; i < foot->sole_count; i++) {
		lowest = foot->place[i][1] < foot->place[lowest][1] ? i : lowest;
	}
	return lowest;
}

float character_feet_place(
	struct character_feet *feet, const struct instance *instance)
{
	float low[2];

	for (int side = 0; side < 2; side++) {
		struct character_foot *foot = &feet->foot[side];

		for (int i = 0; i < foot->sole_count; i++) {
			character_sole_place(
				&foot->sole[i], instance, foot->place[i]);
		}
		low[side] = foot->place[find_lowest(foot)][1];
	}
	return scalar_min(low[0], low[1]);
}

/*
 * Returns the mean height of the lower sole in the clips that play, by their
 * weights. If one clip plays alone, it is low, that of the present pose.
 */
static float height_in_clips(const struct character *character,
	const struct character_feet *feet, float low)
{
	const struct character_machine *machine = &character->machine;
	const struct character_state *state = &machine->state[machine->current];
	float sum = 0;

	for (int i = 0; i < state->entry_count; i++) {
		const struct character_entry *entry = &state->entry[i];

		if (entry->weight == 1 && !machine->inertia.running) {
			return low;
		}
		if (entry->weight > 0) {
			sum += entry->weight *
				character_entry_sole_m(entry, feet->pair);
		}
	}
	return sum;
}

/*
 * Returns how far the hips have to be lifted. During a fade the height of the
 * lower sole goes from the one that was shown to that of the new clips.
 */
static float find_lift(const struct character *character,
	struct character_feet *feet, float low)
{
	const struct inertia *inertia = &character->machine.inertia;
	float wanted = height_in_clips(character, feet, low);

	if (inertia->running) {
		float left = 1 -
			ease_at(EASE_CUBIC,
				inertia->elapsed_s / inertia->duration_s);

		if (inertia->elapsed_s <= character->step_s) {
			feet->from_m = feet->shown_m - wanted;
		}
		wanted += feet->from_m * left;
	}
	feet->shown_m = wanted;
	return wanted - low;
}

/* An angle in -pi..pi. */
static float wrap(float angle_rad)
{
	const float turn_rad = 2 * SCALAR_PI;

	return angle_rad - turn_rad * scalar_floor(angle_rad / turn_rad + 0.5f);
}

static float direction_of(const struct character_foot *foot)
{
	const float *heel = foot->place[foot->heel];
	const float *toe = foot->place[foot->toe];

	return scalar_atan2(toe[0] - heel[0], toe[2] - heel[2]);
}

static void note_foot(const struct character *character,
	const struct character_feet *feet, struct character_foot *foot,
	float before[CHARACTER_SOLE_MAX][3])
{
	/* A foot lets go at a greater height than it takes hold at. */
	float near = foot->step_s < 0 && foot->low ? release : 1;
	float above =
		character->ground_m - feet->lift_m + near * foot->planted_m;
	float direction = direction_of(foot);
	unsigned low = 0;
	int count = 0;

	foot->moved[0] = foot->moved[1] = 0;
	for (int i = 0; i < foot->sole_count; i++) {
		low |= foot->place[i][1] < above ? 1u << i : 0;
	}
	foot->stays = feet->begun ? low & foot->low : 0;
	foot->low = low;
	for (int i = 0; i < foot->sole_count; i++) {
		if (foot->stays >> i & 1) {
			foot->moved[0] += foot->place[i][0] - before[i][0];
			foot->moved[1] += foot->place[i][2] - before[i][2];
			count++;
		}
	}
	for (int axis = 0; axis < 2 && count > 0; axis++) {
		foot->moved[axis] /= (float)count;
	}
	foot->turned = wrap(direction - foot->direction);
	foot->direction = direction;
}

static bool is_held(const struct character_foot *foot)
{
	return foot->stays && foot->step_s < 0;
}

/* Notes which feet of a pair stand. */
static void note_feet(struct character *character, struct character_feet *feet)
{
	float before[2][CHARACTER_SOLE_MAX][3], low;

	for (int side = 0; side < 2; side++) {
		memcpy(before[side], feet->foot[side].place,
			sizeof(before[side]));
	}
	low = character_feet_place(feet, character->instance);
	feet->lift_m = find_lift(character, feet, low);
	for (int side = 0; side < 2; side++) {
		note_foot(character, feet, &feet->foot[side], before[side]);
	}
	feet->begun = true;
}

void character_feet_follow(struct character *character)
{
	struct character_motion *motion = &character->motion;
	float fraction =
		character->step_s < smooth_s ? character->step_s / smooth_s : 1;
	float sum[2] = {0, 0};
	int standing = 0;

	for (struct character_feet *feet = character->feet; feet;
		feet = feet->next) {
		note_feet(character, feet);
		for (int side = 0; side < 2; side++) {
			const struct character_foot *foot = &feet->foot[side];

			if (is_held(foot)) {
				sum[0] += foot->moved[0];
				sum[1] += foot->moved[1];
				standing++;
			}
		}
	}
	if (standing == 0 || character->step_s <= 0 || motion->foot[0] < 0) {
		return;
	}
	for (int axis = 0; axis < 2; axis++) {
		motion->velocity[axis] += fraction *
			(-sum[axis] / ((float)standing * character->step_s) -
				motion->velocity[axis]);
	}
}

static float length_of(const float offset[2])
{
	return scalar_sqrt(offset[0] * offset[0] + offset[1] * offset[1]);
}

static void begin_step(const struct character_feet *feet,
	struct character_foot *foot, bool arc)
{
	float length = length_of(foot->hold.offset);

	foot->from = foot->hold;
	foot->step_s = 0;
	foot->arc_m = !arc
		? 0
		: scalar_clamp(arc_share * length, arc_least * feet->height_m,
			  arc_most * feet->height_m);
}

/* Computes where a point of the foot is held, along x and z. */
static void held_place(const struct character_foot *foot, const float ankle[3],
	const float place[3], float out[2])
{
	float sine = scalar_sin(foot->hold.turn_rad);
	float cosine = scalar_cos(foot->hold.turn_rad);
	float x = place[0] - ankle[0], z = place[2] - ankle[2];

	out[0] = ankle[0] + foot->hold.offset[0] + cosine * x + sine * z;
	out[1] = ankle[2] + foot->hold.offset[1] - sine * x + cosine * z;
}

/* Holds the points that stay where they were on the ground. */
static void keep_place(const struct character *character,
	struct character_foot *foot, const float ankle[3])
{
	float slip[2] = {0, 0};
	int count = 0;

	foot->hold.turn_rad -= foot->turned;
	for (int i = 0; i < foot->sole_count; i++) {
		float now[2];

		if (!(foot->stays >> i & 1)) {
			continue;
		}
		held_place(foot, ankle, foot->place[i], now);
		for (int axis = 0; axis < 2; axis++) {
			slip[axis] += now[axis] - foot->shown[i][axis] +
				character->motion.scroll[axis];
		}
		count++;
	}
	for (int axis = 0; axis < 2; axis++) {
		foot->hold.offset[axis] -= slip[axis] / (float)count;
	}
}

/*
 * Advances a foot that is in the air: the displacement that held it goes to 0.
 */
static void step(const struct character *character, struct character_foot *foot,
	const struct character_foot *other, const float ankle[3])
{
	float u, left;

	foot->step_s += character->step_s;
	u = foot->step_s / step_duration_s;
	left = 1 - ease_at(EASE_CUBIC, u);
	if (foot->arc_m > 0 && foot->stays &&
		foot->raised_m < release * foot->planted_m) {
		keep_place(character, foot, ankle);
		foot->from = foot->hold;
	} else {
		foot->hold.offset[0] = foot->from.offset[0] * left;
		foot->hold.offset[1] = foot->from.offset[1] * left;
		foot->hold.turn_rad = foot->from.turn_rad * left;
	}
	if (foot->arc_m > 0 && (u >= 1 || !other->low)) {
		foot->arc_m = 0;
	}
	if (foot->arc_m == 0 && foot->low) {
		foot->step_s = -1;
	}
}

/* A foot that is held too far from its place takes a step, if it may. */
static void return_home(const struct character *character,
	const struct character_feet *feet, struct character_foot *foot,
	const struct character_foot *other)
{
	float speed = length_of(character->motion.velocity);
	float share =
		speed < still_per_s * feet->height_m ? near_offset : far_offset;

	if (is_held(other) &&
		(length_of(foot->hold.offset) > share * feet->height_m ||
			scalar_abs(foot->hold.turn_rad) > far_turn_rad)) {
		begin_step(feet, foot, true);
	}
}

static void move_foot(const struct character *character,
	const struct character_feet *feet, struct character_foot *foot,
	const struct character_foot *other)
{
	const float *ankle = character->instance->world[foot->leg.tip][3];
	float goal = 0, most = raise_per_s * feet->height_m * character->step_s;

	if (foot->step_s >= 0) {
		step(character, foot, other, ankle);
	} else if (!foot->low) {
		begin_step(feet, foot, false);
	} else if (foot->stays) {
		keep_place(character, foot, ankle);
		return_home(character, feet, foot, other);
	}
	if (foot->step_s >= 0) {
		goal = foot->arc_m *
			scalar_sin(SCALAR_PI * foot->step_s / step_duration_s);
	}
	foot->raised_m += scalar_clamp(goal - foot->raised_m, -most, most);
}

/* A foot is not held while the effect is off, and is held anew from there. */
static void let_go(struct character_foot *foot)
{
	foot->hold = (struct character_hold){0};
	foot->step_s = -1;
	foot->arc_m = foot->raised_m = 0;
}

void character_feet_hold(
	const struct character *character, struct character_feet *feet)
{
	for (int side = 0; side < 2; side++) {
		struct character_foot *foot = &feet->foot[side];
		const float *ankle =
			character->instance->world[foot->leg.tip][3];

		if (feet->is.now == 0) {
			let_go(foot);
		} else {
			move_foot(character, feet, foot, &feet->foot[!side]);
		}
		for (int i = 0; i < foot->sole_count; i++) {
			held_place(foot, ankle, foot->place[i], foot->shown[i]);
		}
	}
}
