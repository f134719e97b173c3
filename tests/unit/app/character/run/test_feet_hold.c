/* What holds feet where they stand, and the steps by which they go back. */
#include "tests/unit/app/character/run/footing.h"

#include <math.h>

/*
 * Begins with the feet of one pair that stand, and shows them. The figure's
 * velocity is what the test says, at first 0.
 */
static struct character_foot *begin(struct footing *footing)
{
	footing_begin(footing);
	footing->character.feet->next = NULL;
	footing->character.motion.foot[0] = -1;
	for (int i = 0; i < 2; i++) {
		character_feet_follow(&footing->character);
		character_feet_hold(&footing->character, footing->feet);
	}
	for (int i = 0; i < 2; i++) {
		assert_int_equal(footing->feet->foot[i].stays, 7);
		assert_near(footing->feet->foot[i].step_s, -1, 0);
	}
	return footing->feet->foot;
}

static void hold(struct footing *footing)
{
	character_feet_follow(&footing->character);
	character_feet_hold(&footing->character, footing->feet);
}

/* Turns the sole about y and the ankle, from +z to +x. */
static void turn(struct footing *footing, float angle_rad)
{
	const float *ankle = place_of(footing, 0, 0, ANKLE);

	for (int i = 0; i < ANKLE; i++) {
		float *place = place_of(footing, 0, 0, i);
		float x = place[0] - ankle[0], z = place[2] - ankle[2];

		place[0] = ankle[0] + x * cosf(angle_rad) + z * sinf(angle_rad);
		place[2] = ankle[2] - x * sinf(angle_rad) + z * cosf(angle_rad);
	}
}

/* Whatever the clip does with it, and for several frames. */
static void test_a_foot_that_stands_goes_with_the_ground(void **state)
{
	struct footing footing;
	struct character_foot *foot = begin(&footing);
	float shown[ANKLE][2];

	(void)state;
	memcpy(shown, foot->shown, sizeof(shown));
	for (int frame = 0; frame < 3; frame++) {
		move_foot(&footing, 0, 0, 0.005f, 0, -0.002f);
		turn(&footing, 0.05f);
		footing.character.motion.scroll[0] = -0.003f;
		footing.character.motion.scroll[1] = 0.001f;
		/* A figure that walks is not in a hurry to go back. */
		footing.character.motion.velocity[1] = 1;
		hold(&footing);
		for (int i = 0; i < ANKLE; i++) {
			shown[i][0] += 0.003f;
			shown[i][1] -= 0.001f;
			assert_all_near(foot->shown[i], shown[i], 2, 1e-6);
		}
		assert_near(foot->hold.turn_rad, -0.05 * (frame + 1), 1e-6);
		assert_near(foot->step_s, -1, 0);
	}
}

/* One that rolls on two of three points is held there in the mean. */
static void test_only_points_that_stay_hold_a_foot(void **state)
{
	(void)state;
	for (int third = 0; third < ANKLE; third++) {
		const int first = (third + 1) % ANKLE,
			  second = (third + 2) % ANKLE;
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		place_of(&footing, 0, 0, third)[1] = 1;
		place_of(&footing, 0, 0, first)[2] += 0.002f;
		place_of(&footing, 0, 0, second)[2] += 0.006f;
		hold(&footing);
		assert_int_equal(foot->stays, 1 << first | 1 << second);
		assert_all_near(
			foot->hold.offset, ((float[]){0, -0.004f}), 2, 1e-6);
	}
}

static void test_a_foot_may_stand_on_thirty_two_points(void **state)
{
	struct footing footing;
	struct character_foot *foot;

	(void)state;
	footing_begin(&footing);
	foot = &footing.feet->foot[1];
	for (int i = ANKLE; i < CHARACTER_SOLE_MAX; i++) {
		foot->sole[i] = foot->sole[i % ANKLE];
	}
	foot->sole_count = CHARACTER_SOLE_MAX;
	hold(&footing);
	hold(&footing);
	assert_int_equal(foot->stays, 0xffffffff);
	move_foot(&footing, 0, 1, 0.004f, 0, -0.003f);
	hold(&footing);
	assert_all_near(foot->moved, ((float[]){0.004f, -0.003f}), 2, 1e-6);
	assert_all_near(
		foot->hold.offset, ((float[]){-0.004f, 0.003f}), 2, 1e-6);
}

/* The figure is 2 m tall. Along x and z in the ratio of 3 to 4. */
static void test_a_foot_held_too_far_away_takes_a_step(void **state)
{
	static const struct {
		float speed, offset_m, turn_rad;
		bool steps;
	} rows[] = {{0, 0.0119f, 0, false}, {0, 0.0121f, 0, true},
		{0.1205f, 0.0119f, 0, false}, {0.1205f, 0.0121f, 0, true},
		{0.1215f, 0.0599f, 0, false}, {0.1215f, 0.0601f, 0, true},
		{2, 0.0599f, 0, false}, {2, 0.0601f, 0, true},
		{2, -0.0599f, 0, false}, {2, -0.0601f, 0, true},
		{2, 0, 0.299f, false}, {2, 0, 0.301f, true},
		{2, 0, -0.299f, false}, {2, 0, -0.301f, true}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		move_foot(&footing, 0, 0, -0.6f * rows[i].offset_m, 0,
			-0.8f * rows[i].offset_m);
		turn(&footing, -rows[i].turn_rad);
		character_feet_follow(&footing.character);
		footing.character.motion.velocity[0] = 0.8f * rows[i].speed;
		footing.character.motion.velocity[1] = -0.6f * rows[i].speed;
		character_feet_hold(&footing.character, footing.feet);
		assert_near(foot->hold.offset[1], 0.8 * rows[i].offset_m, 1e-6);
		assert_near(foot->hold.turn_rad, rows[i].turn_rad, 1e-6);
		assert_near(foot->step_s, rows[i].steps ? 0 : -1, 0);
		assert_near(foot[1].step_s, -1, 0);
	}
}

/* As far as a foot may be held away, and no farther; and as fast. */
static void test_a_foot_at_its_limit_stays(void **state)
{
	static const struct {
		float speed, offset_m, turn_rad;
		bool steps;
	} rows[] = {{0, 2 * 0.006f, 0, false}, {0, 2 * 0.0061f, 0, true},
		{1, 2 * 0.03f, 0, false}, {1, 2 * 0.0301f, 0, true},
		{1, 0, 0.3f, false}, {1, 0, -0.3f, false}, {1, 0, 0.301f, true},
		{2 * 0.0605f, 0.03f, 0, false}, {2 * 0.0604f, 0.03f, 0, true}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);
		const float *at = place_of(&footing, 0, 0, ANKLE);

		/* It stands on a point below its ankle. */
		foot->sole_count = 1;
		foot->heel = foot->toe = 0;
		move_foot(&footing, 0, 0, -at[0], 0, -at[2]);
		memset(place_of(&footing, 0, 0, 0), 0, sizeof(float[3]));
		hold(&footing);
		foot->hold = (struct character_hold){
			{rows[i].offset_m, 0}, rows[i].turn_rad};
		foot->shown[0][0] = rows[i].offset_m;
		foot->shown[0][1] = 0;
		footing.character.motion.velocity[0] = rows[i].speed;
		foot->step_s = -1;
		hold(&footing);
		assert_near(foot->hold.offset[0], rows[i].offset_m, 0);
		assert_near(foot->step_s, rows[i].steps ? 0 : -1, 0);
	}
}

/* In the air, or just come down. */
static void test_no_foot_steps_while_the_other_is_not_held(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		move_foot(&footing, 0, 0, 0.1f, 0, 0);
		if (i == 0) {
			foot[1].step_s = 0;
			foot[1].arc_m = 0.01f;
		} else {
			foot[1].low = 0;
		}
		hold(&footing);
		assert_near(foot->hold.offset[0], -0.1f, 1e-6);
		assert_near(foot->step_s, -1, 0);
	}
}

/* From 6 mm to 4 cm of a metre of height. */
static void test_a_step_is_a_quarter_as_high_as_it_is_long(void **state)
{
	static const float rows[][2] = {{0.02f, 0.012f}, {0.0479f, 0.012f},
		{0.052f, 0.013f}, {0.2f, 0.05f}, {0.316f, 0.079f},
		{0.33f, 0.08f}, {1, 0.08f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		move_foot(&footing, 0, 0, -rows[i][0], 0, 0);
		turn(&footing, 0.1f);
		hold(&footing);
		assert_near(foot->step_s, 0, 0);
		assert_near(foot->arc_m, rows[i][1], 1e-5);
		assert_near(foot->from.offset[0], rows[i][0], 1e-6);
		assert_near(foot->from.turn_rad, -0.1, 1e-6);
	}
}

/* By the share 3 u^2 - 2 u^3 of a quarter of a second. */
static void test_a_foot_in_the_air_goes_back_to_its_place(void **state)
{
	static const struct {
		float since_s, step_s, left;
	} rows[] = {{0, 0.05f, 0.896f}, {0.05f, 0.05f, 0.648f},
		{0.1f, 0.025f, 0.5f}, {0.125f, 0.075f, 0.104f},
		{0.2f, 0.05f, 0}, {0.3f, 0.05f, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		foot->step_s = rows[i].since_s;
		foot->from = (struct character_hold){{0.2f, -0.1f}, 0.4f};
		foot->hold = (struct character_hold){{9, 9}, 9};
		footing.character.step_s = rows[i].step_s;
		move_foot(&footing, 0, 0, 0, 1, 0);
		hold(&footing);
		assert_near(
			foot->step_s, rows[i].since_s + rows[i].step_s, 1e-6);
		assert_near(foot->hold.offset[0], 0.2 * rows[i].left, 1e-6);
		assert_near(foot->hold.offset[1], -0.1 * rows[i].left, 1e-6);
		assert_near(foot->hold.turn_rad, 0.4 * rows[i].left, 1e-6);
		assert_near(foot->raised_m, 0, 0);
	}
}

/* The clip raises it, which is no step. */
static void test_a_foot_that_leaves_the_ground_swings(void **state)
{
	struct footing footing;
	struct character_foot *foot = begin(&footing);

	(void)state;
	foot->hold = (struct character_hold){{0.2f, -0.1f}, 0.4f};
	move_foot(&footing, 0, 0, 0, 0.02f, 0);
	hold(&footing);
	assert_near(foot->step_s, 0, 0);
	assert_near(foot->arc_m, 0, 0);
	assert_near(foot->from.offset[0], 0.2f, 0);
	assert_near(foot->from.offset[1], -0.1f, 0);
	assert_near(foot->from.turn_rad, 0.4f, 0);
	/* It is held again where it comes down. */
	move_foot(&footing, 0, 0, 0.5f, -0.02f, 0.5f);
	hold(&footing);
	assert_near(foot->step_s, -1, 0);
	assert_true(foot->hold.offset[0] > 0.19f);
}

/*
 * A foot that takes a step stays on the ground until it is raised by 1 cm, 2.5
 * times the height in which a sole is planted.
 */
static void test_a_step_first_raises_the_foot(void **state)
{
	static const struct {
		float raised_m, arc_m;
		bool in_the_air, kept;
	} rows[] = {{0.0099f, 0.08f, false, true},
		{0.0101f, 0.08f, false, false}, {0.0099f, 0.08f, true, false},
		{2.5f * 0.004f, 0.08f, false, false},
		{0.0099f, 0, false, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);
		float wanted;

		move_foot(&footing, 0, 0, 0.004f, 0, 0);
		hold(&footing);
		assert_near(foot->hold.offset[0], -0.004f, 1e-6);
		foot->from.offset[0] = -1;
		foot->step_s = 0.115f;
		foot->arc_m = rows[i].arc_m;
		foot->raised_m = rows[i].raised_m;
		move_foot(&footing, 0, 0, 0.002f, rows[i].in_the_air ? 0.1f : 0,
			0);
		hold(&footing);
		wanted = rows[i].kept ? -0.006f : -0.5f;
		assert_near(foot->hold.offset[0], wanted, 1e-5);
		assert_near(
			foot->from.offset[0], rows[i].kept ? wanted : -1, 1e-5);
	}
}

/* Or when the other foot leaves the ground. */
static void test_a_step_ends_after_a_quarter_of_a_second(void **state)
{
	static const struct {
		float since_s;
		bool other_up, up, arc, in_the_air;
	} rows[] = {
		{0.234375f, false, false, false, false},
		{0.234f, false, false, true, true},
		{0.235f, false, false, false, false},
		{0.235f, false, true, false, true},
		{0.1f, true, false, false, false},
		{0.1f, true, true, false, true},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		foot->step_s = rows[i].since_s;
		foot->arc_m = 0.02f;
		footing.character.step_s = 0.015625f;
		move_foot(&footing, 0, 0, 0, rows[i].up ? 1 : 0, 0);
		move_foot(&footing, 0, 1, 0, rows[i].other_up ? 1 : 0, 0);
		hold(&footing);
		assert_int_equal(foot->arc_m > 0, rows[i].arc);
		assert_int_equal(foot->step_s >= 0, rows[i].in_the_air);
	}
}

/*
 * Half a sine high, and by 0.726 of its height a second at most: 14.52 mm in 10
 * ms of a figure of 2 m.
 */
static void test_a_step_raises_a_foot_at_a_limited_speed(void **state)
{
	static const struct {
		float since_s, arc_m, from_m, to_m;
	} rows[] = {
		{0.115f, 0.01f, 0, 0.01f},
		{0.115f, 0.0145f, 0, 0.0145f},
		{0.115f, 0.016f, 0, 0.01452f},
		{0.115f, 0.05f, 0.02f, 0.03452f},
		{0.03166667f, 0.02f, 0, 0.01f},
		{0.19833333f, 0.02f, 0.02f, 0.01f},
		{0.115f, 0.01f, 0.02f, 0.01f},
		{0.115f, 0.01f, 0.05f, 0.03548f},
		{-1, 0, 0.05f, 0.03548f},
		{-1, 0, 0.0145f, 0},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = begin(&footing);

		foot->step_s = rows[i].since_s;
		foot->arc_m = rows[i].arc_m;
		foot->raised_m = rows[i].from_m;
		hold(&footing);
		assert_near(foot->raised_m, rows[i].to_m, 2e-6);
	}
}

static void test_feet_that_are_off_are_where_the_clip_has_them(void **state)
{
	struct footing footing;
	struct character_foot *foot = begin(&footing);

	(void)state;
	footing.feet->is.now = 0;
	for (int side = 0; side < 2; side++) {
		foot[side].hold = (struct character_hold){{0.2f, -0.1f}, 0.4f};
		foot[side].step_s = 0.1f;
		foot[side].arc_m = foot[side].raised_m = 0.02f;
	}
	move_foot(&footing, 0, 0, 0.1f, 0, -0.3f);
	hold(&footing);
	for (int side = 0; side < 2; side++) {
		assert_near(foot[side].step_s, -1, 0);
		assert_near(foot[side].arc_m, 0, 0);
		assert_near(foot[side].raised_m, 0, 0);
		assert_near(foot[side].hold.turn_rad, 0, 0);
		for (int i = 0; i < ANKLE; i++) {
			const float *place = place_of(&footing, 0, side, i);

			assert_near(foot[side].shown[i][0], place[0], 1e-6);
			assert_near(foot[side].shown[i][1], place[2], 1e-6);
		}
	}
	/* From there they are held anew. */
	footing.feet->is.now = 0.1f;
	move_foot(&footing, 0, 0, 0.01f, 0, 0);
	hold(&footing);
	assert_near(foot->hold.offset[0], -0.01, 1e-6);
	assert_near(foot->hold.offset[1], 0, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_foot_that_stands_goes_with_the_ground),
		cmocka_unit_test(test_only_points_that_stay_hold_a_foot),
		cmocka_unit_test(test_a_foot_may_stand_on_thirty_two_points),
		cmocka_unit_test(test_a_foot_held_too_far_away_takes_a_step),
		cmocka_unit_test(test_a_foot_at_its_limit_stays),
		cmocka_unit_test(test_no_foot_steps_while_the_other_is_not_held),
		cmocka_unit_test(test_a_step_is_a_quarter_as_high_as_it_is_long),
		cmocka_unit_test(test_a_foot_in_the_air_goes_back_to_its_place),
		cmocka_unit_test(test_a_foot_that_leaves_the_ground_swings),
		cmocka_unit_test(test_a_step_first_raises_the_foot),
		cmocka_unit_test(test_a_step_ends_after_a_quarter_of_a_second),
		cmocka_unit_test(test_a_step_raises_a_foot_at_a_limited_speed),
		cmocka_unit_test(
			test_feet_that_are_off_are_where_the_clip_has_them),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
