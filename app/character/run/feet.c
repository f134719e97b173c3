#include "app/character/run/feet.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/character/state/entry.h"

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
/* from a foot to the two places that show how the ground slopes there */
static const float slope_step = 0.0484f;
static const float step_duration_s = 0.25f;
/* time constant of the motion's velocity */
static const float smooth_s = 0.08f;
/* part of its length to which a leg may be stretched */
static const float stretch = 0.999f;

/* Where the ankle of a foot has to be, and how the foot turns. */
struct foot_goal {
	float at[3];
	float turn[4];  /* on top of the animated rotation */
	float ground_m; /* above level ground */
};

float character_feet_level(const struct character *character)
{
	float level = 0;

	for (const struct character_feet *feet = character->feet; feet;
		feet = feet->next) {
		level = feet->is.now > level ? feet->is.now : level;
	}
	return level;
}

static void update_world_from(struct instance *instance, int node)
{
	pose_world_from(
		&instance->pose, instance->model, NULL, node, instance->world);
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
	return low[0] < low[1] ? low[0] : low[1];
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
	for (int i = 0; i < foot->sole_count; i++) {
		held_place(foot, ankle, foot->place[i], foot->shown[i]);
	}
}

static float ground_at(const struct character *character, const float at[3])
{
	return character->ground_height
		? character->ground_height(character->ground_user, at[0], at[2])
		: 0;
}

/* Computes the rotation from a level foot to the ground's slope. */
static void slope_rotation(const struct character *character, const float at[3],
	float height, float step_m, float out[4])
{
	const float right[3] = {at[0] + step_m, at[1], at[2]};
	const float front[3] = {at[0], at[1], at[2] + step_m};

	quat_from_slope((ground_at(character, right) - height) / step_m,
		(ground_at(character, front) - height) / step_m, out);
}

/* How far up the hips are already, as others that carry them have moved. */
static float carried_m(const struct character_feet *feet)
{
	return feet->carrier ? feet->carrier->moved_m : 0;
}

/* Moves the hips up in the world by lift metres. */
static void lift_hips(struct instance *instance,
	const struct character_feet *feet, float lift)
{
	const mat4 *world = (const mat4 *)instance->world;
	struct transform *local = &instance->pose.local[feet->hips];
	int parent = instance->pose.model->node[feet->hips].parent;
	float up[3] = {0, lift, 0};
	float scale = parent < 0 ? 1 : matrix_scale(&world[parent]);

	bone_to_axes(world, parent, up, up);
	vec_add_scaled(local->translation, up, scale > 0 ? 1 / scale : 1,
		local->translation);
	instance->pose.animated[feet->hips] = true;
}

/* Returns how far the hips have to come down for a leg to reach its target. */
static float missing_height(const struct instance *instance,
	const struct character_foot *foot, const float target[3], float lift)
{
	float from[3], length = stretch * foot->length_m;
	float across2, height2;

	vec_subtract(instance->world[foot->leg.upper][3], target, from);
	across2 = from[0] * from[0] + from[2] * from[2];
	height2 = length * length - across2;
	height2 = height2 > 0 ? height2 : 0;
	return from[1] + lift - scalar_sqrt(height2);
}

static bool is_displaced(const struct character_hold *hold)
{
	return hold->offset[0] != 0 || hold->offset[1] != 0 ||
		hold->turn_rad != 0;
}

/* Finds the ankles' goals. Returns true if the legs have to bend for them. */
static bool find_targets(const struct character *character,
	const struct character_feet *feet, struct foot_goal goal[2])
{
	const mat4 *world = (const mat4 *)character->instance->world;
	static const float up[3] = {0, 1, 0};
	float weight = feet->is.now, turn[4];
	bool moves = false;

	for (int side = 0; side < 2; side++) {
		const struct character_foot *foot = &feet->foot[side];
		float *at = goal[side].at;

		memcpy(at, world[foot->leg.tip][3], sizeof(goal[side].at));
		at[0] += foot->hold.offset[0] * weight;
		at[2] += foot->hold.offset[1] * weight;
		goal[side].ground_m = ground_at(character, at);
		slope_rotation(character, at, goal[side].ground_m,
			slope_step * feet->height_m, goal[side].turn);
		quat_from_axis_angle(up, foot->hold.turn_rad * weight, turn);
		quat_multiply(goal[side].turn, turn, goal[side].turn);
		at[1] += feet->lift_m * weight - carried_m(feet) +
			goal[side].ground_m + foot->raised_m * weight;
		moves = moves || goal[side].ground_m != 0 ||
			foot->raised_m != 0 || is_displaced(&foot->hold);
	}
	return moves;
}

static void place_foot(struct instance *instance, struct character_foot *foot,
	const struct foot_goal *goal)
{
	float turned[4];

	matrix_rotation(instance->world[foot->leg.tip], turned);
	quat_multiply(goal->turn, turned, turned);
	foot->leg.weight = 1;
	ik_limb_solve(&foot->leg, goal->at, NULL, (const mat4 *)instance->world,
		&instance->pose);
	update_world_from(instance, foot->leg.upper);
	bone_set_world_rotation(&instance->pose, (const mat4 *)instance->world,
		foot->leg.tip, turned, 1);
	update_world_from(instance, foot->leg.tip);
}

void character_feet_run(struct character *character, void *what)
{
	struct character_feet *feet = what;
	struct instance *instance = character->instance;
	struct foot_goal goal[2];
	float lift = feet->lift_m * feet->is.now - carried_m(feet);
	float lower = 0;
	bool moves;

	feet->moved_m = carried_m(feet);
	if (feet->is.now == 0) {
		return;
	}
	move_foot(character, feet, &feet->foot[0], &feet->foot[1]);
	move_foot(character, feet, &feet->foot[1], &feet->foot[0]);
	moves = find_targets(character, feet, goal);
	/* The hips move with the lower foot, so that both legs can reach. */
	lift += goal[0].ground_m < goal[1].ground_m ? goal[0].ground_m
						    : goal[1].ground_m;
	for (int side = 0; side < 2 && moves; side++) {
		float missing = missing_height(
			instance, &feet->foot[side], goal[side].at, lift);

		lower = missing > lower ? missing : lower;
	}
	if (lift != lower) {
		lift_hips(instance, feet, lift - lower);
		update_world_from(instance, feet->hips);
		feet->moved_m += lift - lower;
	}
	for (int side = 0; side < 2 && moves; side++) {
		place_foot(instance, &feet->foot[side], &goal[side]);
	}
}
