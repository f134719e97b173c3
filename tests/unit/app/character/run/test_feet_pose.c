/* How hips and legs bring feet to where the ground has them. */
#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/character/run/feet.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>

/*
 * Legs of two bones of 0.51 m, bent a little ahead, from hips that are 1 m high
 * to ankles at height 0. The figure is 2 m tall.
 */
enum {
	ROOT,
	HIPS,
	LEG, /* thigh, shin and foot of the left leg, then of the right one */
	BONES = LEG + 6
};

static const float reach_m = 0.999f * 1.0198039f;

struct fixture {
	struct bones bones;
	struct instance instance;
	struct character_feet feet, carrier;
	struct character character;
	/* of the ground: height, factors of x and z, of their squares, of x z */
	float level_m[2], rise[2], bend[2], cross;
};

static float ground(void *user, float x, float z)
{
	const struct fixture *f = user;

	return f->level_m[x > 0 ? 0 : 1] + f->rise[0] * x + f->rise[1] * z +
		f->bend[0] * x * x + f->bend[1] * z * z + f->cross * x * z;
}

static int foot_of(int side)
{
	return LEG + 3 * side + 2;
}

static void begin(struct fixture *f)
{
	struct bones *bones = &f->bones;

	memset(f, 0, sizeof(*f));
	bones_begin(bones);
	bones_add(bones, -1, 0, 0, 0);
	bones_add(bones, ROOT, 0, 1, 0);
	for (int side = 0; side < 2; side++) {
		struct character_foot *foot = &f->feet.foot[side];
		int thigh = bones_add(bones, HIPS, side ? -0.1f : 0.1f, 0, 0);
		int shin = bones_add(bones, thigh, 0, -0.5f, 0.1f);

		foot->leg.upper = thigh;
		foot->leg.lower = shin;
		foot->leg.tip = bones_add(bones, shin, 0, -0.5f, -0.1f);
		foot->length_m = 1.0198039f;
		foot->step_s = -1;
		foot->low = 1; /* but it has not stayed, so nothing holds it */
	}
	bones_pose(bones);
	f->instance.pose = bones->pose;
	f->instance.model = &bones->model;
	f->instance.world = bones->world;
	f->feet.is.now = 1;
	f->feet.hips = HIPS;
	f->feet.height_m = 2;
	f->character.instance = &f->instance;
	f->character.ground_height = ground;
	f->character.ground_user = f;
}

static void end(struct fixture *f)
{
	bones_assert_finite(&f->bones);
	bones_end(&f->bones);
}

/* Expects the ankle at an offset from where it is animated. */
static void expect_ankle(
	const struct fixture *f, int side, float x, float y, float z)
{
	const float wanted[3] = {(side ? -0.1f : 0.1f) + x, y, z};

	assert_all_near(f->bones.world[foot_of(side)][3], wanted, 3, 2e-5);
}

/* Expects the hips so far above their animated place, which others know. */
static void expect_hips(const struct fixture *f, float above_m)
{
	const float wanted[3] = {0, 1 + above_m, 0};

	assert_all_near(f->bones.world[HIPS][3], wanted, 3, 2e-5);
	assert_near(f->feet.moved_m, above_m, 2e-5);
}

/* Only where something has to change. */
static void test_legs_that_stand_well_are_left_alone(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	character_feet_run(&f.character, &f.feet);
	for (int i = 0; i < BONES; i++) {
		assert_false(f.instance.pose.animated[i]);
	}
	/* Without any ground it is level. */
	f.character.ground_height = NULL;
	f.feet.lift_m = 0.05f;
	character_feet_run(&f.character, &f.feet);
	expect_hips(&f, 0.05f);
	expect_ankle(&f, 0, 0, 0.05f, 0);
	expect_ankle(&f, 1, 0, 0.05f, 0);
	for (int i = 0; i < BONES; i++) {
		assert_int_equal(f.instance.pose.animated[i], i == HIPS);
	}
	end(&f);
}

/* As far as the feet are on, and less what another pair's hips have moved. */
static void test_hips_rise_in_the_world(void **state)
{
	static const struct {
		float weight, carried_m, above_m;
	} rows[] = {{1, 0, 0.04f}, {0.25f, 0, 0.01f}, {1, 0.03f, 0.04f},
		{0.25f, 0.04f, 0.01f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;

		begin(&f);
		/* What carries the hips is turned and twice as large. */
		quat_from_axis_angle((float[3]){0, 0, 1}, 0.5f,
			f.instance.pose.local[ROOT].rotation);
		for (int k = 0; k < 3; k++) {
			f.instance.pose.local[ROOT].scale[k] = 2;
		}
		f.instance.pose.animated[ROOT] = true;
		f.carrier.moved_m = rows[i].carried_m;
		f.feet.carrier = rows[i].carried_m > 0 ? &f.carrier : NULL;
		f.feet.is.now = rows[i].weight;
		f.feet.lift_m = 0.04f;
		bones_update(&f.bones);
		{
			float wanted[3];

			memcpy(wanted, f.bones.world[HIPS][3], sizeof(wanted));
			wanted[1] += rows[i].above_m - rows[i].carried_m;
			character_feet_run(&f.character, &f.feet);
			assert_all_near(f.bones.world[HIPS][3], wanted, 3, 1e-5);
			assert_near(f.feet.moved_m, rows[i].above_m, 1e-6);
		}
		end(&f);
	}
}

/* Hips without a parent, and those of a figure that is shrunk to a point. */
static void test_hips_rise_without_a_parent_or_its_size(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.bones.node[HIPS].parent = -1;
	f.feet.lift_m = 0.04f;
	character_feet_run(&f.character, &f.feet);
	expect_hips(&f, 0.04f);
	end(&f);
	begin(&f);
	for (int k = 0; k < 3; k++) {
		f.instance.pose.local[ROOT].scale[k] = 0;
	}
	f.instance.pose.animated[ROOT] = true;
	bones_update(&f.bones);
	f.feet.lift_m = 0.04f;
	character_feet_run(&f.character, &f.feet);
	assert_all_near(f.bones.world[HIPS][3], ((float[3]){0}), 3, 0);
	assert_near(f.instance.pose.local[HIPS].translation[1], 1, 0);
	end(&f);
}

/* The hips go with the lower foot, and lower if a leg is too short for that. */
static void test_hips_go_where_both_legs_reach_the_ground(void **state)
{
	static const struct {
		float ground_m[2], offset[2], raised_m, above_m;
	} rows[] = {
		{{0.2f, 0}, {0, 0}, 0, 0},
		{{0, 0.2f}, {0, 0}, 0, 0},
		{{-0.1f, 0}, {0, 0}, 0, -0.1f},
		{{0, -0.1f}, {0, 0}, 0, -0.1f},
		{{0.2f, 0.1f}, {0, 0}, 0, 0.1f},
		/* sqrt(reach_m^2 - 0.5^2) = 0.8876 */
		{{0, 0}, {0.3f, 0.4f}, 0, -0.1123619f},
		{{0, 0}, {0.5f, 0}, 0, -0.1123619f},
		{{0, 0}, {0, -0.5f}, 0, -0.1123619f},
		{{0.05f, 0}, {0.5f, 0}, 0, -0.0623619f},
		{{0, 0}, {0.5f, 0}, 0.02f, -0.0923619f},
		{{0, 0}, {0.1f, 0}, 0, 0},
		{{0, 0}, {0, 0}, 0.02f, 0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct fixture f;
		struct character_foot *foot = f.feet.foot;

		begin(&f);
		memcpy(f.level_m, rows[i].ground_m, sizeof(f.level_m));
		memcpy(foot->hold.offset, rows[i].offset,
			sizeof(foot->hold.offset));
		foot->raised_m = rows[i].raised_m;
		character_feet_run(&f.character, &f.feet);
		expect_hips(&f, rows[i].above_m);
		expect_ankle(&f, 0, rows[i].offset[0],
			rows[i].ground_m[0] + rows[i].raised_m,
			rows[i].offset[1]);
		expect_ankle(&f, 1, 0, rows[i].ground_m[1], 0);
		assert_near(foot->leg.weight, 1, 0);
		end(&f);
	}
}

/* The hips come down to the ankle's height then, and the leg lies level. */
static void test_a_foot_beyond_the_leg_brings_the_hips_down(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.feet.foot[1].hold.offset[1] = 2 * reach_m;
	character_feet_run(&f.character, &f.feet);
	expect_hips(&f, -1);
	end(&f);
}

/* With feet that are half on, and hips that another pair carries. */
static void test_feet_are_held_as_far_as_they_are_on(void **state)
{
	struct fixture f;
	struct character_foot *foot = f.feet.foot;

	(void)state;
	begin(&f);
	f.carrier.moved_m = 0.01f;
	f.feet.carrier = &f.carrier;
	f.feet.is.now = 0.5f;
	f.feet.lift_m = -0.06f;
	f.level_m[0] = f.level_m[1] = 0.02f;
	foot[1].hold = (struct character_hold){{0.04f, -0.08f}, 0.6f};
	foot[1].raised_m = 0.1f;
	character_feet_run(&f.character, &f.feet);
	expect_ankle(&f, 0, 0, -0.03f - 0.01f + 0.02f, 0);
	expect_ankle(&f, 1, 0.02f, -0.03f - 0.01f + 0.02f + 0.05f, -0.04f);
	assert_near(f.bones.world[HIPS][3][1], 1 - 0.03 - 0.01 + 0.02, 1e-5);
	assert_near(f.feet.moved_m, -0.01, 1e-6);
	/* z of the foot's frame */
	assert_near(f.bones.world[foot_of(1)][2][0], sinf(0.3f), 1e-5);
	assert_near(f.bones.world[foot_of(1)][2][2], cosf(0.3f), 1e-5);
	assert_near(f.bones.world[foot_of(0)][2][0], 0, 1e-6);
	end(&f);
}

/* Each of these alone bends both legs. */
static void test_legs_bend_for_whatever_displaces_a_foot(void **state)
{
	(void)state;
	for (int what = 0; what < 12; what++) {
		int side = what % 2;
		struct fixture f;
		struct character_foot *foot = &f.feet.foot[side];
		float amount = what / 6 ? 0.01f : -0.01f;

		begin(&f);
		switch (what / 2 % 6) {
		case 0:
			foot->hold.offset[0] = amount;
			break;
		case 1:
			foot->hold.offset[1] = amount;
			break;
		case 2:
			foot->hold.turn_rad = amount;
			break;
		case 3:
			foot->raised_m = amount;
			break;
		default:
			f.level_m[side] = amount;
		}
		character_feet_run(&f.character, &f.feet);
		for (int i = LEG; i < BONES; i++) {
			assert_true(f.instance.pose.animated[i]);
		}
		end(&f);
	}
}

/*
 * Up of a foot is the normal of the ground between it and 9.68 cm further along
 * x and z: 0.0484 of the figure's height. The sole turns on top of that.
 */
static void test_feet_are_as_steep_as_the_ground_before_them(void **state)
{
	static const float step_m = 0.0968f, z = 0.1f;
	struct fixture f;

	(void)state;
	begin(&f);
	f.level_m[0] = f.level_m[1] = 0.1f;
	f.rise[0] = -0.03f;
	f.rise[1] = -0.03f;
	f.bend[0] = 0.3f;
	f.bend[1] = -0.2f;
	f.cross = 0.4f;
	f.feet.foot[0].hold.offset[1] = f.feet.foot[1].hold.offset[1] = z;
	f.feet.foot[0].hold.turn_rad = 0.4f;
	character_feet_run(&f.character, &f.feet);
	for (int side = 0; side < 2; side++) {
		float x = side ? -0.1f : 0.1f;
		float up[3] = {-(-0.03f + 0.3f * (2 * x + step_m) + 0.4f * z),
			1, -(-0.03f - 0.2f * (2 * z + step_m) + 0.4f * x)};
		const float ahead[3] = {
			side ? 0 : sinf(0.4f), 0, side ? 1 : cosf(0.4f)};
		float slope[4], wanted[3];

		vec_normalize(up);
		assert_all_near(f.bones.world[foot_of(side)][1], up, 3, 1e-3);
		quat_between((float[3]){0, 1, 0}, up, slope);
		quat_rotate(slope, ahead, wanted);
		assert_all_near(
			f.bones.world[foot_of(side)][2], wanted, 3, 1e-3);
		expect_ankle(&f, side, 0, ground(&f, x, z), z);
	}
	end(&f);
}

/* It turns with the animated foot, and its descendants with it. */
static void test_a_foot_keeps_its_animated_rotation(void **state)
{
	static const float axis[3] = {1, 0, 0};
	struct fixture f;

	(void)state;
	begin(&f);
	for (int side = 0; side < 2; side++) {
		quat_from_axis_angle(axis, 0.3f,
			f.instance.pose.local[foot_of(side)].rotation);
		f.instance.pose.animated[foot_of(side)] = true;
	}
	bones_update(&f.bones);
	f.level_m[0] = 0.2f;
	character_feet_run(&f.character, &f.feet);
	for (int side = 0; side < 2; side++) {
		const float up[3] = {0, cosf(0.3f), sinf(0.3f)};

		assert_all_near(f.bones.world[foot_of(side)][1], up, 3, 1e-5);
	}
	end(&f);
}

static void test_feet_that_are_off_move_nothing(void **state)
{
	struct fixture f;

	(void)state;
	begin(&f);
	f.feet.is.now = 0;
	f.feet.lift_m = 0.05f;
	f.feet.carrier = &f.carrier;
	f.carrier.moved_m = 0.02f;
	f.level_m[0] = 0.1f;
	f.feet.foot[0].hold.offset[0] = 0.3f;
	character_feet_run(&f.character, &f.feet);
	assert_near(f.feet.foot[0].hold.offset[0], 0, 0);
	assert_near(f.feet.moved_m, 0.02f, 0);
	for (int i = 0; i < BONES; i++) {
		assert_false(f.instance.pose.animated[i]);
	}
	end(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_legs_that_stand_well_are_left_alone),
		cmocka_unit_test(test_hips_rise_in_the_world),
		cmocka_unit_test(test_hips_rise_without_a_parent_or_its_size),
		cmocka_unit_test(test_hips_go_where_both_legs_reach_the_ground),
		cmocka_unit_test(test_a_foot_beyond_the_leg_brings_the_hips_down),
		cmocka_unit_test(test_feet_are_held_as_far_as_they_are_on),
		cmocka_unit_test(test_legs_bend_for_whatever_displaces_a_foot),
		cmocka_unit_test(
			test_feet_are_as_steep_as_the_ground_before_them),
		cmocka_unit_test(test_a_foot_keeps_its_animated_rotation),
		cmocka_unit_test(test_feet_that_are_off_move_nothing),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
