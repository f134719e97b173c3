/* Which feet stand, how high the hips go, and what that says of the ground. */
#include "tests/unit/app/character/run/footing.h"

static void test_feet_are_on_as_far_as_the_pair_that_is_on_most(void **state)
{
	static const float on[][3] = {
		{0.25f, 0.75f, 0.75f}, {0.75f, 0.25f, 0.75f}, {0, 0, 0}};
	struct footing footing;

	(void)state;
	footing_begin(&footing);
	for (size_t i = 0; i < ARRAY_COUNT(on); i++) {
		footing.feet[0].is.now = on[i][0];
		footing.feet[1].is.now = on[i][1];
		assert_near(
			character_feet_level(&footing.character), on[i][2], 0);
	}
	footing.character.feet = NULL;
	assert_near(character_feet_level(&footing.character), 0, 0);
}

static void test_any_point_of_both_soles_may_be_the_lowest(void **state)
{
	(void)state;
	for (int side = 0; side < 2; side++) {
		for (int i = 0; i < ANKLE; i++) {
			struct footing footing;

			footing_begin(&footing);
			place_of(&footing, 1, side, i)[1] = -0.3f;
			assert_near(character_feet_place(&footing.feet[1],
					    &footing.instance),
				-0.3f, 0);
			assert_near(character_feet_place(&footing.feet[0],
					    &footing.instance),
				0, 0);
		}
	}
}

/* Each pair goes by the heights of its own soles. */
static void test_a_blend_lifts_soles_to_the_mean_height_of_its_clips(
	void **state)
{
	static const float height_m[3][PAIRS] = {
		{0.1f, 0.5f}, {0.2f, 0.7f}, {9, 9}};
	struct footing footing;

	(void)state;
	footing_begin(&footing);
	for (int i = 0; i < 3; i++) {
		for (int pair = 0; pair < PAIRS; pair++) {
			footing.sole_m[i][pair][0] = height_m[i][pair];
		}
	}
	footing.entry[0].weight = 0.25f;
	footing.entry[1].weight = 0.75f;
	/* Nothing asks a clip of another state. */
	footing.entry[2].weight = 1;
	footing.state[1].entry_count = 2;
	move_foot(&footing, 0, 1, 0, -0.03f, 0);
	move_foot(&footing, 1, 0, 0, -0.05f, 0);
	character_feet_follow(&footing.character);
	assert_near(footing.feet[0].lift_m, 0.175f + 0.03f, 1e-6);
	assert_near(footing.feet[1].lift_m, 0.65f + 0.05f, 1e-6);
}

static void test_a_clip_that_does_not_play_has_no_height(void **state)
{
	struct footing footing;

	(void)state;
	footing_begin(&footing);
	footing.sole_m[0][0][0] = 0.1f;
	footing.entry[0].weight = 0.5f;
	footing.clip[1].sole_m = footing.clip[2].sole_m = NULL;
	character_feet_follow(&footing.character);
	assert_near(footing.feet[0].lift_m, 0.05f, 1e-6);
}

static void test_a_clip_alone_does_not_lift_soles(void **state)
{
	struct footing footing;

	(void)state;
	footing_begin(&footing);
	footing.sole_m[0][0][0] = 0.1f;
	move_foot(&footing, 0, 0, 0, 0.02f, 0);
	move_foot(&footing, 0, 1, 0, 0.03f, 0);
	character_feet_follow(&footing.character);
	assert_near(footing.feet[0].lift_m, 0, 0);
	assert_near(footing.feet[0].shown_m, 0.02f, 1e-6);
}

/* A fade of 0.4 s from 0.3 m to clips with 0.1 m. */
static void test_a_fade_leads_from_the_height_shown_to_the_new_one(void **state)
{
	static const struct {
		float elapsed_s, step_s, shown_m;
	} rows[] = {{0.1f, 0.1f, 0.1f + 0.2f * 0.84375f}, {0.2f, 0.1f, 0.2f},
		{0.3f, 0.1f, 0.1f + 0.2f * 0.15625f}, {0.3f, 0.0f, 0.13125f},
		{0.4f, 0.1f, 0.1f}};
	struct footing footing;
	struct inertia *inertia = &footing.character.machine.inertia;

	(void)state;
	footing_begin(&footing);
	footing.sole_m[0][0][0] = 0.1f;
	footing.feet[0].shown_m = 0.3f;
	inertia->running = true;
	inertia->duration_s = 0.4f;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		inertia->elapsed_s = rows[i].elapsed_s;
		footing.character.step_s = rows[i].step_s;
		character_feet_follow(&footing.character);
		assert_near(footing.feet[0].from_m, 0.2, 1e-6);
		assert_near(footing.feet[0].shown_m, rows[i].shown_m, 1e-6);
		assert_near(footing.feet[0].lift_m, rows[i].shown_m, 1e-6);
	}
}

/*
 * A sole takes hold below planted_m, 4 mm, above the ground. One that stands
 * lets go at 2.5 times that height; one in the air has no hold yet.
 */
static void test_a_foot_lets_go_higher_than_it_takes_hold(void **state)
{
	static const struct {
		unsigned before;
		float step_s, height_m;
		bool is_low;
	} rows[] = {{0, -1, 0.0039f, true}, {0, -1, 0.0041f, false},
		{2, -1, 0.0099f, true}, {2, -1, 0.0101f, false},
		{2, 0, 0.0041f, false}, {2, 0.1f, 0.0041f, false},
		{2, 0.1f, 0.0039f, true}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		struct character_foot *foot = &footing.feet[0].foot[1];

		footing_begin(&footing);
		footing.character.ground_m = 0.5f;
		/* The other foot, on the ground, is the lower one. */
		move_foot(&footing, 0, 0, 0, 0.5f, 0);
		move_foot(&footing, 0, 1, 0, 0.6f, 0);
		place_of(&footing, 0, 1, HEEL)[1] = 0.5f + rows[i].height_m;
		foot->low = rows[i].before;
		foot->step_s = rows[i].step_s;
		character_feet_follow(&footing.character);
		assert_int_equal(foot->low, rows[i].is_low ? 1 << HEEL : 0);
	}
}

static void test_a_sole_at_the_height_of_its_hold_is_off_the_ground(void **state)
{
	struct footing footing;

	(void)state;
	footing_begin(&footing);
	place_of(&footing, 0, 0, TOE)[1] = footing.feet[0].foot[0].planted_m;
	character_feet_follow(&footing.character);
	assert_int_equal(footing.feet[0].foot[0].low, 1 << SIDE | 1 << HEEL);
}

/* The hips lift the soles by 8 mm: what is 5 mm below the ground stands. */
static void test_soles_stand_where_the_lifted_hips_take_them(void **state)
{
	static const struct {
		float height_m;
		bool is_low;
	} rows[] = {{-0.0041f, true}, {-0.0039f, false}, {0.0001f, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;

		footing_begin(&footing);
		footing.entry[0].weight = 0.5f;
		footing.entry[1].weight = 0.5f;
		move_foot(&footing, 0, 0, 0, -0.008f, 0);
		place_of(&footing, 0, 1, TOE)[1] = rows[i].height_m;
		place_of(&footing, 0, 1, HEEL)[1] = 1;
		place_of(&footing, 0, 1, SIDE)[1] = 1;
		character_feet_follow(&footing.character);
		assert_near(footing.feet[0].lift_m, 0.008, 1e-6);
		assert_int_equal(footing.feet[0].foot[1].low,
			rows[i].is_low ? 1 << TOE : 0);
		assert_int_equal(footing.feet[0].foot[0].low, 7);
	}
}

/* In the first frame none has stayed, in the next those low in both. */
static void test_a_point_stays_that_is_low_in_two_frames(void **state)
{
	struct footing footing;
	struct character_foot *foot = &footing.feet[0].foot[0];

	(void)state;
	footing_begin(&footing);
	foot->low = 7;
	place_of(&footing, 0, 0, HEEL)[1] = 1;
	character_feet_follow(&footing.character);
	assert_int_equal(foot->low, 1 << SIDE | 1 << TOE);
	assert_int_equal(foot->stays, 0);
	place_of(&footing, 0, 0, HEEL)[1] = 0;
	place_of(&footing, 0, 0, SIDE)[1] = 1;
	character_feet_follow(&footing.character);
	assert_int_equal(foot->low, 1 << HEEL | 1 << TOE);
	assert_int_equal(foot->stays, 1 << TOE);
}

/* Of the points that stay, here two of three; the third leaves the ground. */
static void test_a_foot_moves_as_its_points_do_in_the_mean(void **state)
{
	(void)state;
	for (int third = 0; third < ANKLE; third++) {
		const int first = (third + 1) % ANKLE,
			  second = (third + 2) % ANKLE;
		struct footing footing;
		struct character_foot *foot = &footing.feet[0].foot[0];

		footing_begin(&footing);
		character_feet_follow(&footing.character);
		place_of(&footing, 0, 0, third)[0] += 100;
		place_of(&footing, 0, 0, third)[1] = 1;
		place_of(&footing, 0, 0, first)[0] += 0.01f;
		place_of(&footing, 0, 0, first)[2] += 0.04f;
		place_of(&footing, 0, 0, second)[0] += 0.03f;
		place_of(&footing, 0, 0, second)[2] -= 0.08f;
		character_feet_follow(&footing.character);
		assert_int_equal(foot->stays, 1 << first | 1 << second);
		assert_all_near(
			foot->moved, ((float[]){0.02f, -0.02f}), 2, 1e-6);
		move_foot(&footing, 0, 0, 1, 1, 1);
		character_feet_follow(&footing.character);
		assert_all_near(foot->moved, ((float[]){0, 0}), 2, 0);
	}
}

/* About y from +z to +x, and by less than half a turn. */
static void test_a_foot_turns_as_the_line_from_heel_to_toe(void **state)
{
	static const struct {
		float from[2], to[2], turned_rad;
	} rows[] = {
		{{0, 0.3f}, {0.3f, 0}, 0.5f * SCALAR_PI},
		{{0.2f, 0.2f}, {0.2f, -0.2f}, 0.5f * SCALAR_PI},
		{{0.2f, -0.2f}, {-0.2f, -0.2f}, 0.5f * SCALAR_PI},
		{{-0.2f, -0.2f}, {0.2f, -0.2f}, -0.5f * SCALAR_PI},
		{{0.2f, 0.2f}, {0.2f, 0.2f}, 0},
		{{-0.2f, -0.2f}, {0.2f, 0}, -0.75f * SCALAR_PI},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;
		float *heel = place_of(&footing, 0, 0, HEEL);
		float *toe = place_of(&footing, 0, 0, TOE);
		struct character_foot *foot = &footing.feet[0].foot[0];

		footing_begin(&footing);
		toe[0] = heel[0] + rows[i].from[0];
		toe[2] = heel[2] + rows[i].from[1];
		character_feet_follow(&footing.character);
		toe[0] = heel[0] + rows[i].to[0];
		toe[2] = heel[2] + rows[i].to[1];
		character_feet_follow(&footing.character);
		assert_near(foot->turned, rows[i].turned_rad, 1e-5);
		assert_near(foot->direction,
			scalar_atan2(rows[i].to[0], rows[i].to[1]), 1e-5);
	}
}

enum {
	ALL = 15 /* bits: the feet of both pairs */
};

/* Begins with feet that stand, moves them, and follows them for step_s. */
static void follow(struct footing *footing, unsigned standing, float step_s)
{
	static const float moved[4][2] = {
		{0.01f, 0.002f}, {0.02f, -0.004f}, {0.03f, 0.03f}, {0.06f, 0}};

	footing_begin(footing);
	character_feet_follow(&footing->character);
	for (int i = 0; i < 4; i++) {
		move_foot(footing, i / 2, i % 2, moved[i][0], 0, moved[i][1]);
		footing->feet[i / 2].foot[i % 2].step_s =
			standing >> i & 1 ? -1 : 0;
	}
	footing->character.step_s = step_s;
	footing->character.motion.velocity[0] = 1;
	footing->character.motion.velocity[1] = -2;
	character_feet_follow(&footing->character);
}

/*
 * The figure goes where the feet that stand come from, all alike. In less than
 * 80 ms the velocity goes only a part of the way to that.
 */
static void test_the_ground_goes_as_the_feet_that_stand(void **state)
{
	static const struct {
		unsigned standing;
		float step_s, velocity[2];
	} rows[] = {
		{ALL, 0.1f, {-0.3f, -0.07f}},
		{1, 0.1f, {-0.1f, -0.02f}},
		{2, 0.1f, {-0.2f, 0.04f}},
		{6, 0.2f, {-0.125f, -0.065f}},
		{6, 0.08f, {-0.3125f, -0.1625f}},
		{6, 0.04f, {0.5f * (1 - 0.625f), 0.5f * (-2 - 0.325f)}},
		{0, 0.1f, {1, -2}},
		{ALL, 0, {1, -2}},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct footing footing;

		follow(&footing, rows[i].standing, rows[i].step_s);
		assert_all_near(footing.character.motion.velocity,
			rows[i].velocity, 2, 1e-5);
	}
}

static void test_without_feet_of_the_motion_the_velocity_is_another(void **state)
{
	struct footing footing;

	(void)state;
	follow(&footing, ALL, 0.1f);
	move_foot(&footing, 0, 0, 1, 0, 1);
	footing.character.motion.foot[0] = -1;
	character_feet_follow(&footing.character);
	assert_all_near(footing.character.motion.velocity,
		((float[]){-0.3f, -0.07f}), 2, 1e-5);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_feet_are_on_as_far_as_the_pair_that_is_on_most),
		cmocka_unit_test(test_any_point_of_both_soles_may_be_the_lowest),
		cmocka_unit_test(
			test_a_blend_lifts_soles_to_the_mean_height_of_its_clips),
		cmocka_unit_test(test_a_clip_that_does_not_play_has_no_height),
		cmocka_unit_test(test_a_clip_alone_does_not_lift_soles),
		cmocka_unit_test(
			test_a_fade_leads_from_the_height_shown_to_the_new_one),
		cmocka_unit_test(test_a_foot_lets_go_higher_than_it_takes_hold),
		cmocka_unit_test(
			test_a_sole_at_the_height_of_its_hold_is_off_the_ground),
		cmocka_unit_test(
			test_soles_stand_where_the_lifted_hips_take_them),
		cmocka_unit_test(test_a_point_stays_that_is_low_in_two_frames),
		cmocka_unit_test(test_a_foot_moves_as_its_points_do_in_the_mean),
		cmocka_unit_test(test_a_foot_turns_as_the_line_from_heel_to_toe),
		cmocka_unit_test(test_the_ground_goes_as_the_feet_that_stand),
		cmocka_unit_test(
			test_without_feet_of_the_motion_the_velocity_is_another),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
