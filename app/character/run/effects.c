#include "app/character/run/effects.h"

#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "platform/base/scalar.h"

#include <string.h>

enum {
	GRIP_ROUNDS = 4
};

static void update_world_from(struct instance *instance, int node)
{
	pose_world_from(
		&instance->pose, instance->model, NULL, node, instance->world);
}

void character_shake_run(struct character *character, void *what)
{
	struct character_shake *shake = what;

	shake->swing.fade = 1 - shake->is.now;
	procedural_apply(&shake->swing,
		character->now_s + (double)shake->delay_s,
		&character->instance->pose);
}

void character_shake_use(
	struct character *character, const struct character_action *action)
{
	struct character_shake *shake = character->shake[action->index];
	int count = shake->preset_count;
	int chosen = action->detail >= 0 ? action->detail
					 : shake->chosen + (int)action->amount;

	shake->chosen = (chosen % count + count) % count;
	shake->swing.preset = shake->preset[shake->chosen];
}

void character_look_run(struct character *character, void *what)
{
	struct character_look *look = what;
	struct instance *instance = character->instance;
	const float *target = look->is.is_on ? look->target->point : NULL;

	look->target->used = look->target->used || look->is.is_on;

	if (look->is.now == 0) {
		return;
	}
	for (int i = 0; i < look->bone_count; i++) {
		struct lookat *bone = &look->bone[i];

		bone->weight = look->share[i] * look->is.now;
		lookat_update(bone, target, character->step_s,
			(const mat4 *)instance->world, &instance->pose);
		update_world_from(instance, bone->node);
	}
}

/* The tip's goal lies short_m before the target, seen from the first bone. */
static void shorten(const struct character_reach *reach,
	const struct instance *instance, float goal[3])
{
	int first = reach->is_chain ? reach->chain.node[0] : reach->limb.upper;
	float back[3], distance;

	vec_subtract(instance->world[first][3], reach->target->point, back);
	distance = vec_normalize(back);
	vec_add_scaled(reach->target->point, back,
		scalar_min(reach->short_m, distance), goal);
}

/*
 * The middle joint bends towards the pole or, without one, as it is animated.
 */
static void solve_limb(const struct character_reach *reach,
	struct instance *instance, const float goal[3], float weight)
{
	struct ik_limb limb = reach->limb;
	float pole[3];

	vec_add_scaled(goal, reach->pole, 1, pole);
	limb.weight = weight;
	ik_limb_solve(&limb, goal, reach->has_pole ? pole : NULL,
		(const mat4 *)instance->world, &instance->pose);
	update_world_from(instance, limb.upper);
}

/*
 * Brings a place of the tip's frame, such as the palm of a hand, to the target.
 * That place depends on the tip's rotation, which depends on the limb's, so a
 * few rounds are needed.
 */
static void grip(const struct character_reach *reach, struct instance *instance)
{
	const int node[3] = {
		reach->limb.upper, reach->limb.lower, reach->limb.tip};
	struct transform animated[3];

	for (int i = 0; i < 3; i++) {
		animated[i] = instance->pose.local[node[i]];
	}
	for (int round = 0; round < GRIP_ROUNDS; round++) {
		float goal[3], place[3];

		matrix_apply_direction(
			instance->world[reach->limb.tip], reach->grip, place);
		vec_subtract(reach->target->point, place, goal);
		for (int i = 0; i < 3; i++) {
			instance->pose.local[node[i]] = animated[i];
		}
		update_world_from(instance, node[0]);
		solve_limb(reach, instance, goal,
			round + 1 < GRIP_ROUNDS ? 1 : reach->is.now);
	}
}

void character_reach_run(struct character *character, void *what)
{
	struct character_reach *reach = what;
	struct instance *instance = character->instance;
	float goal[3];

	reach->target->used = reach->target->used || reach->is.is_on;
	if (reach->is.now == 0) {
		return;
	}
	if (reach->has_grip) {
		grip(reach, instance);
		return;
	}
	shorten(reach, instance, goal);
	if (reach->is_chain) {
		reach->chain.weight = reach->is.now;
		ik_chain_solve(&reach->chain, goal,
			(const mat4 *)instance->world, &instance->pose);
		update_world_from(instance, reach->chain.node[0]);
		return;
	}
	solve_limb(reach, instance, goal, reach->is.now);
}

/*
 * Turns a bone from its animated rotation, or blends to one turned from rest.
 */
static void turn_bone(
	const struct character_turn *turn, struct pose *pose, int which)
{
	int bone = turn->bone[which];
	float *local = pose->local[bone].rotation;
	float rotation[4];

	quat_from_axis_angle(turn->bone_axis[which],
		turn->angle_rad *
			(turn->from == CHARACTER_FROM_REST ? 1 : turn->is.now),
		rotation);
	if (turn->from == CHARACTER_FROM_REST) {
		quat_multiply(pose->model->node[bone].rest.rotation, rotation,
			rotation);
		quat_slerp(local, rotation, turn->is.now, local);
	} else {
		quat_multiply(local, rotation, local);
	}
	pose->animated[bone] = true;
}

void character_turn_run(struct character *character, void *what)
{
	struct character_turn *turn = what;
	struct pose *pose = &character->instance->pose;

	if (turn->is.now == 0) {
		return;
	}
	for (int i = 0; i < turn->bone_count; i++) {
		turn_bone(turn, pose, i);
	}
}

void character_spring_run(struct character *character, void *what)
{
	struct character_spring *effect = what;
	struct instance *instance = character->instance;
	struct capsule_world body[CHARACTER_BONES_MAX];
	const float *ground = character->motion.velocity;

	capsule_to_world(effect->body, effect->body_count,
		(const mat4 *)instance->world, body);
	/* The figure moves on the spot, so the air moves instead. */
	effect->spring.gravity[0] = effect->gravity[0] - 3 * ground[0];
	effect->spring.gravity[2] = effect->gravity[2] - 3 * ground[1];
	effect->spring.weight = effect->is.now;
	spring_update(&effect->spring, character->step_s, body,
		effect->body_count, (const mat4 *)instance->world,
		&instance->pose);
	update_world_from(instance, effect->spring.node[0]);
}

void character_breath_run(struct character *character, void *what)
{
	struct character_breath *effect = what;

	effect->breath.weight = effect->is.now;
	if (effect->is.now != 0) {
		breath_apply(&effect->breath, character->now_s,
			&character->instance->pose);
	}
}

void character_muscle_run(struct character *character, void *what)
{
	struct character_muscle *effect = what;

	if (effect->is.now == 0) {
		return;
	}
	for (int i = 0; i < 3; i++) {
		effect->muscle.swell[i] = effect->swell[i] * effect->is.now;
	}
	muscle_apply(&effect->muscle, &character->instance->pose);
}

/* A place in the file becomes one in the model, which may have been moved. */
static void from_file(const struct model *model, float point[3])
{
	for (int axis = 0; axis < 3; axis++) {
		point[axis] = (float)((double)point[axis] - model->origin[axis]);
	}
}

void character_targets_update(struct character *character)
{
	for (int i = 0; i < character->target_count; i++) {
		struct character_target *target = &character->target[i];

		target->used = !target->has_users;

		if (target->is_camera) {
			memcpy(target->point, character->eye,
				sizeof(target->point));
			continue;
		}
		for (int axis = 0; axis < 3; axis++) {
			target->point[axis] = *target->place[axis];
		}
		if (target->node < 0) {
			from_file(character->instance->model, target->point);
		} else {
			vec_add_scaled(target->point,
				character->instance->world[target->node][3], 1,
				target->point);
		}
	}
}
