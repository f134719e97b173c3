#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "app/character/run/effects.h"

#include <string.h>

/* Air pushes with the square of the speed: a cape hangs while walking. */
static const float wind_s_per_m = 0.17f;

static void update_world_from(struct instance *instance, int node)
{
	pose_world_from(
		&instance->pose, instance->model, NULL, node, instance->world);
}

static float height_at(const struct character *character, float x, float z)
{
	return character->ground_height(character->drive_user, x, z);
}

/* The rotation from a level foot to the ground's slope. */
static void slope_rotation(const struct character *character, const float at[3],
	float height, float out[4])
{
	const float step = 0.08f;
	float dx = (height_at(character, at[0] + step, at[2]) - height) / step;
	float dz = (height_at(character, at[0], at[2] + step) - height) / step;

	quat_from_slope(dx, dz, out);
}

/* Moves the hips by a height of the world. */
static void lift_hips(struct character *character,
	const struct character_feet *feet, float lift)
{
	struct instance *instance = character->instance;
	struct transform *local = &instance->pose.local[feet->hips];
	float up[3] = {0, lift, 0}, back[4];

	bone_parent_rotation(&instance->pose, (const mat4 *)instance->world,
		feet->hips, back);
	quat_conjugate(back, back);
	quat_rotate(back, up, up);
	vec_add_scaled(local->translation, up, 1, local->translation);
	instance->pose.animated[feet->hips] = true;
}

/*
 * Lifts each foot by the height of the ground under it. The hips move with the
 * lower foot, so that both legs reach the ground.
 */
void character_feet_run(struct character *character, void *what)
{
	struct character_feet *feet = what;
	struct instance *instance = character->instance;
	mat4 *world = instance->world;
	float target[2][3], slope[2][4], lift[2];

	if (feet->is.now == 0 || !character->ground_height) {
		return;
	}
	for (int side = 0; side < 2; side++) {
		memcpy(target[side], world[feet->leg[side].tip][3],
			sizeof(target[side]));
		lift[side] =
			height_at(character, target[side][0], target[side][2]);
		slope_rotation(character, target[side], lift[side], slope[side]);
		target[side][1] += lift[side];
	}
	lift_hips(character, feet, lift[0] < lift[1] ? lift[0] : lift[1]);
	for (int side = 0; side < 2; side++) {
		struct ik_limb *leg = &feet->leg[side];
		float turned[4];

		update_world_from(instance, feet->hips);
		matrix_rotation(world[leg->tip], turned);
		quat_multiply(slope[side], turned, turned);
		leg->weight = 1;
		ik_limb_solve(leg, target[side], NULL, (const mat4 *)world,
			&instance->pose);
		update_world_from(instance, leg->upper);
		bone_set_world_rotation(&instance->pose, (const mat4 *)world,
			leg->tip, turned, 1);
	}
	update_world_from(instance, feet->hips);
}

void character_cape_run(struct character *character, void *what)
{
	struct character_cape *cape = what;
	struct capsule_world body[CHARACTER_CAPE_BODIES];
	const float *ground = character->motion.velocity;
	mat4 *world = character->instance->world;
	float speed = scalar_sqrt(ground[0] * ground[0] + ground[1] * ground[1]);

	if (cape->is.now == 0) {
		cape->worn = false;
		return;
	}
	if (!cape->worn) {
		cloth_reset(&cape->cloth);
		cape->worn = true;
	}
	capsule_to_world(
		cape->body, cape->body_count, (const mat4 *)world, body);
	/* The figure moves on the spot, so the air moves instead. */
	cape->cloth.settings.wind[0] = -ground[0] * speed * wind_s_per_m;
	cape->cloth.settings.wind[2] = -ground[1] * speed * wind_s_per_m;
	cloth_update(&cape->cloth, character->step_s, body, cape->body_count,
		(const mat4 *)world);
}
