/*
 * Poses the legs and the hips of a pair of feet: the feet are where feet.c
 * holds them, on the ground below.
 */
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/character/run/feet.h"
#include "platform/base/scalar.h"

#include <string.h>

/*
 * From a foot to the two places that show how the ground slopes there, in
 * heights of the figure.
 */
static const float slope_step = 0.0484f;
/* The part of its length to which a leg may be stretched */
static const float stretch = 0.999f;

/* Where the ankle of a foot has to be, and how the foot turns. */
struct foot_goal {
	float at[3];
	float turn[4];  /* on top of the animated rotation */
	float ground_m; /* above level ground */
};

static void update_world_from(struct instance *instance, int node)
{
	pose_world_from(
		&instance->pose, instance->model, NULL, node, instance->world);
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
	float scale = parent < 0 ? 1 : matrix_scale(&world[parent]);
	float up[3] = {0, scale > 0 ? lift / scale : 0, 0};

	bone_to_axes(world, parent, up, up);
	vec_add_scaled(local->translation, up, 1, local->translation);
	instance->pose.animated[feet->hips] = true;
}

/* Returns how far the hips have to come down for a leg to reach its target. */
static float missing_height(const struct instance *instance,
	const struct character_foot *foot, const float target[3], float lift)
{
	float from[3], length = stretch * foot->length_m;
	float across2;

	vec_subtract(instance->world[foot->leg.upper][3], target, from);
	across2 = from[0] * from[0] + from[2] * from[2];
	return from[1] + lift - scalar_sqrt(length * length - across2);
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
	float weight = feet->is.now;
	float turn[4];
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
	character_feet_hold(character, feet);
	if (feet->is.now == 0) {
		return;
	}
	moves = find_targets(character, feet, goal);
	/* The hips move with the lower foot, so that both legs can reach. */
	lift += scalar_min(goal[0].ground_m, goal[1].ground_m);
	for (int side = 0; side < 2 && moves; side++) {
		float missing = missing_height(
			instance, &feet->foot[side], goal[side].at, lift);

		lower = scalar_max(missing, lower);
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
