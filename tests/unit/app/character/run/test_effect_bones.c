/* Which bones effects move, by how much, and from what they start. */
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/character/run/effects.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* An arm along x, a little bent towards z, from a shoulder at height 1. */
enum {
	ROOT,
	UPPER,
	LOWER,
	HAND,
	FINGER,
	BONES
};

struct fixture {
	struct bones bones;
	struct instance instance;
	struct character_target target;
	struct character character;
};

static void begin(struct fixture *f)
{
	struct bones *bones = &f->bones;

	memset(f, 0, sizeof(*f));
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones_add(bones, ROOT, 0, 1, 0);
	bones_add(bones, UPPER, 0.5f, 0, 0);
	bones_add(bones, LOWER, 0.5f, 0, 0.05f);
	bones_add(bones, HAND, 0.1f, 0, 0);
	bones_pose(bones);
	f->instance.pose = bones->pose;
	f->instance.model = &bones->model;
	f->instance.world = bones->world;
	f->character.instance = &f->instance;
	f->character.step_s = 0.25f;
	f->character.now_s = 3;
}

static void end(struct fixture *f)
{
	bones_assert_finite(&f->bones);
	bones_end(&f->bones);
}

/* The angle about y by which a bone is turned, in the world. */
static double yaw_of(const struct fixture *f, int bone)
{
	const float *front = f->bones.world[bone][2];

	return atan2((double)front[0], (double)front[2]);
}

/* Expects these bones alone to have been changed, as bits. */
static void expect_changed(const struct fixture *f, unsigned bones)
{
	for (int i = 0; i < BONES; i++) {
		assert_int_equal(f->instance.pose.animated[i], bones >> i & 1);
	}
}

/* Of 45 degrees the first bone takes a half, and the next one what is left. */
static void test_bones_share_a_look_one_after_the_other(void **state)
{
	static const struct {
		float now;
		bool is_on;
		double yaw[2]; /* in parts of 45 degrees */
		unsigned changed;
	} rows[] = {
		{1, true, {0.5, 1}, 1 << UPPER | 1 << LOWER},
		{0.5f, true, {0.25, 0.625}, 1 << UPPER | 1 << LOWER},
		{0, true, {0, 0}, 0},
		/* While it fades out, it looks ahead. */
		{0.5f, false, {0, 0}, 1 << UPPER | 1 << LOWER},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		const double eighth = 0.785398163;
		struct character_look look = {
			.is = {.now = rows[i].now, .is_on = rows[i].is_on},
			.bone_count = 2,
			.share = {0.5f, 1, 1}};
		struct fixture f;

		begin(&f);
		look.target = &f.target;
		f.target.point[0] = f.target.point[2] = 1e6f;
		for (int k = 0; k < 3; k++) {
			look.bone[k] = lookat_default(UPPER + k);
			look.bone[k].rate = 0;
		}
		character_look_run(&f.character, &look);
		assert_near(yaw_of(&f, UPPER), eighth * rows[i].yaw[0], 1e-5);
		assert_near(yaw_of(&f, LOWER), eighth * rows[i].yaw[1], 1e-5);
		assert_near(yaw_of(&f, FINGER), eighth * rows[i].yaw[1], 1e-5);
		assert_int_equal(f.target.used, rows[i].is_on);
		assert_false(f.instance.pose.animated[HAND]);
		if (rows[i].now > 0) {
			assert_near(look.bone[0].weight, 0.5 * rows[i].now, 0);
			assert_near(look.bone[1].weight, rows[i].now, 0);
		} else {
			expect_changed(&f, 0);
		}
		end(&f);
	}
}

/* It swings as far as it is on, and later than the clock by its delay. */
static void test_a_shake_swings_at_its_own_time(void **state)
{
	struct character_shake shake = {.is = {.now = 0.75f}, .delay_s = 0.2f};
	struct procedural swing = {.preset = procedural_preset_default(),
		.node = LOWER,
		.fade = 0.25f};
	struct fixture f, wanted;

	(void)state;
	begin(&f);
	begin(&wanted);
	shake.swing = swing;
	shake.swing.fade = 9;
	character_shake_run(&f.character, &shake);
	procedural_apply(&swing, 3 + (double)0.2f, &wanted.bones.pose);
	assert_memory_equal(f.bones.pose.local, wanted.bones.pose.local,
		BONES * sizeof(struct transform));
	assert_true(f.instance.pose.animated[LOWER]);
	end(&wanted);
	end(&f);
}

static void test_bones_of_a_turn_are_changed_alone(void **state)
{
	struct character_turn turn = {.is = {.now = 0.5f},
		.bone_count = 2,
		.bone = {LOWER, FINGER, UPPER},
		.bone_axis = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}},
		.angle_rad = 0.8f};
	struct fixture f;

	(void)state;
	begin(&f);
	character_turn_run(&f.character, &turn);
	expect_changed(&f, 1 << LOWER | 1 << FINGER);
	bones_update(&f.bones);
	assert_near(yaw_of(&f, UPPER), 0, 1e-6);
	assert_near(yaw_of(&f, HAND), 0.4, 1e-5);
	assert_near(yaw_of(&f, FINGER), 0.8, 1e-5);
	end(&f);
}

/* Whatever they had in the frame before. */
static void test_breath_and_muscles_have_their_weights(void **state)
{
	struct character_breath breath = {.is = {.now = 0.25f}};
	struct character_muscle muscle = {.is = {.now = 0.5f},
		.muscle = {.joint = LOWER,
			.to_rad = 1,
			.node = UPPER,
			.weight = -1},
		.swell = {0.2f, 0.4f, -0.6f}};
	struct fixture f;

	(void)state;
	begin(&f);
	breath.breath = breath_default(UPPER);
	character_breath_run(&f.character, &breath);
	assert_near(breath.breath.weight, 0.25, 0);
	assert_true(f.instance.pose.animated[UPPER]);
	breath.is.now = 0;
	character_breath_run(&f.character, &breath);
	assert_near(breath.breath.weight, 0, 0);
	character_muscle_run(&f.character, &muscle);
	assert_all_near(
		muscle.muscle.swell, ((float[]){0.1f, 0.2f, -0.3f}), 3, 1e-6);
	muscle.is.now = 0.75f;
	character_muscle_run(&f.character, &muscle);
	assert_all_near(
		muscle.muscle.swell, ((float[]){0.15f, 0.3f, -0.45f}), 3, 1e-6);
	muscle.is.now = 0;
	character_muscle_run(&f.character, &muscle);
	assert_near(muscle.muscle.swell[0], 0.15f, 1e-6);
	end(&f);
}

/* Where the grip is, which is a place of the hand. */
static void place_of(struct fixture *f, const float grip[3], float out[3])
{
	mat4 *hand = &f->bones.world[HAND];

	for (int i = 0; i < 3; i++) {
		out[i] = (*hand)[3][i];
		for (int k = 0; k < 3; k++) {
			out[i] += grip[k] * (*hand)[k][i];
		}
	}
}

/*
 * As far as it is on; then the whole arm is where the matrices say. Four rounds
 * leave between 1 and 2 mm, and each one costs as much as another limb.
 */
static void test_a_grip_brings_a_place_of_the_hand_to_the_target(void **state)
{
	static const struct {
		float now, least_m, most_m;
	} rows[] = {{1, 8e-4f, 2e-3f}, {0.5f, 0.4f, 0.5f}, {0, 0.5f, 1}};
	static const float grip[3] = {0.1f, -0.05f, 0.02f};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_reach reach = {.is = {.now = rows[i].now},
			.limb = {.upper = UPPER, .lower = LOWER, .tip = HAND},
			.has_grip = true};
		mat4 world[BONES];
		struct fixture f;
		float place[3], apart[3];

		begin(&f);
		memcpy(reach.grip, grip, sizeof(grip));
		memcpy(f.target.point, ((float[]){0.5f, 1.2f, 0.3f}),
			sizeof(f.target.point));
		reach.target = &f.target;
		character_reach_run(&f.character, &reach);
		memcpy(world, f.bones.world, sizeof(world));
		place_of(&f, grip, place);
		vec_subtract(f.target.point, place, apart);
		assert_true(vec_length(apart) >= rows[i].least_m);
		assert_true(vec_length(apart) <= rows[i].most_m);
		bones_update(&f.bones);
		assert_all_near(world, f.bones.world, 16 * BONES, 1e-5);
		end(&f);
	}
}

/* Counted from the file's origin, or from a node's, be it the first one. */
static void test_targets_are_where_the_file_has_them(void **state)
{
	static const float place[3] = {5, 6, 7};
	struct character_target target[3];
	struct fixture f;

	(void)state;
	begin(&f);
	f.character.target = target;
	f.character.target_count = 3;
	for (int i = 0; i < 3; i++) {
		target[i] = (struct character_target){.node = i - 1};
		for (int axis = 0; axis < 3; axis++) {
			target[i].place[axis] = &place[axis];
		}
	}
	f.bones.world[ROOT][3][0] = 0.5f;
	f.bones.model.origin[0] = 1;
	f.bones.model.origin[1] = 20;
	f.bones.model.origin[2] = -300;
	character_targets_update(&f.character);
	assert_all_near(target[0].point, ((float[]){4, -14, 307}), 3, 1e-5);
	assert_all_near(target[1].point, ((float[]){5.5f, 6, 7}), 3, 1e-5);
	assert_all_near(target[2].point, ((float[]){5, 7, 7}), 3, 1e-5);
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_bones_share_a_look_one_after_the_other),
		cmocka_unit_test(test_a_shake_swings_at_its_own_time),
		cmocka_unit_test(test_bones_of_a_turn_are_changed_alone),
		cmocka_unit_test(test_breath_and_muscles_have_their_weights),
		cmocka_unit_test(
			test_a_grip_brings_a_place_of_the_hand_to_the_target),
		cmocka_unit_test(test_targets_are_where_the_file_has_them),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
