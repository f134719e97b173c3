/* Where the goals of parameters come from, and how switches fade. */
#include "app/character/run/parameters.h"
#include "tests/support/test.h"

#include <math.h>

/* Updates one parameter with a range of 2 to 6 in a frame of a quarter second. */
static float update(struct character_parameter *one, double now_s, float level)
{
	struct character character = {.parameter = one,
		.parameter_count = 1,
		.now_s = now_s,
		.step_s = 0.25f,
		.motion_level = level};

	one->range[0] = 2;
	one->range[1] = 6;
	character_parameters_update(&character);
	return one->value;
}

/* Also after two years, when a float no longer counts seconds. */
static void test_a_sine_runs_over_the_range(void **state)
{
	static const struct {
		double now_s;
		float period_s, phase, value;
	} rows[] = {{0, 4, 0, 4}, {1, 4, 0, 6}, {3, 4, 0, 2},
		{1.0 / 3, 4, 0, 5}, {0, 4, 0.25f, 6}, {0, 4, -0.25f, 2},
		{1, 4, 0.5f, 2}, {0.25, 0.5f, 0.25f, 2}, {67108865, 4, 0, 6},
		{67108867, 4, 0, 2}, {67108864 + 1.0 / 3, 4, 0, 5}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_parameter one = {
			.source = CHARACTER_SOURCE_SINE,
			.scale = rows[i].period_s,
			.offset = rows[i].phase};

		assert_near(update(&one, rows[i].now_s, 0), rows[i].value, 1e-4);
	}
}

static void test_other_sources_have_their_scale(void **state)
{
	static const float other = 1.25f;
	struct character_parameter time = {
		.source = CHARACTER_SOURCE_TIME, .scale = 0.5f, .offset = 2};
	struct character_parameter motion = {.source = CHARACTER_SOURCE_MOTION};
	struct character_parameter follower = {
		.source = CHARACTER_SOURCE_PARAMETER,
		.other = &other,
		.scale = 4,
		.offset = -1.5f};

	(void)state;
	assert_near(update(&time, 3, 0), 3.5, 0);
	assert_near(update(&time, 99, 0), 6, 0);
	assert_near(update(&motion, 3, 0), 2, 0);
	assert_near(update(&motion, 3, 0.25f), 3, 0);
	assert_near(update(&motion, 3, 1), 6, 0);
	assert_near(update(&follower, 3, 0), 3.5, 0);
}

/* By 3 u^2 - 2 u^3; a frame that ends it shows the goal. */
static void test_a_goal_is_reached_when_the_ease_ends(void **state)
{
	static const float value[] = {
		2 + 0.15625f * 4, 4, 2 + 0.84375f * 4, 6, 6};
	struct character_parameter one = {
		.ease_s = 1, .value = 2, .goal = 2, .from = 2, .last_goal = 2};

	(void)state;
	update(&one, 0, 0);
	character_parameter_set(&one, 6);
	for (size_t i = 0; i < ARRAY_COUNT(value); i++) {
		assert_near(update(&one, 0, 0), value[i], 1e-6);
	}
	/* Without an ease it is there at once, also if it moves on. */
	one.ease_s = 0;
	for (int i = 0; i < 5; i++) {
		character_parameter_set(&one, 2 + 0.5f * (float)i);
		assert_near(update(&one, 0, 0), 2 + 0.5 * i, 0);
	}
}

/* After three changes in a row, as in test_parameters.c. */
static void test_a_goal_moves_after_three_changes(void **state)
{
	struct character_parameter one = {
		.ease_s = 1, .value = 2, .goal = 2, .from = 2, .last_goal = 2};

	(void)state;
	update(&one, 0, 0);
	for (int i = 1; i <= 6; i++) {
		float before = one.value;

		character_parameter_set(&one, 2 + 0.5f * (float)i);
		update(&one, 0, 0);
		assert_int_equal(one.changes, i < 3 ? i : 3);
		if (i >= 3) {
			assert_near(one.value,
				before + (one.goal - before) * (1 - exp(-0.75)),
				1e-5);
		}
	}
	update(&one, 0, 0);
	assert_int_equal(one.changes, 0);
}

/* One stop is all there is to step to; without a step none is passed. */
static void test_steps_stay_within_the_stops(void **state)
{
	static const struct {
		int count, steps;
		float goal, wanted;
	} rows[] = {{1, 1, 2, 3}, {1, -1, 6, 3}, {1, 1, 5, 3}, {1, 0, 3, 3},
		{2, 1, 3, 5}, {2, 5, 3, 5}, {2, -1, 5, 3}, {2, -5, 5, 3},
		{2, 1, 4, 5}, {2, -1, 4, 3}, {2, 0, 4, 5}, {2, 0, 3, 3},
		{2, -2, 6, 3}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct character_parameter one = {.range = {2, 6},
			.goal = rows[i].goal,
			.stop_count = rows[i].count,
			.stop = {3, 5, 6}};

		one.stop[rows[i].count] = -9;
		character_parameter_step(&one, rows[i].steps);
		assert_near(one.goal, rows[i].wanted, 0);
	}
}

/* Both of two, each as fast as its own fade, in frames of a quarter second. */
static void test_switches_fade_to_their_weights(void **state)
{
	float weight[2] = {0.5f, 2};
	struct character_switch is[2] = {
		{.weight = &weight[0], .fade_s = 1, .is_on = true},
		{.weight = &weight[1], .fade_s = 0.5f, .is_on = true}};
	struct character_switch *switches[2] = {&is[0], &is[1]};
	struct character character = {
		.switches = switches, .switch_count = 2, .step_s = 0.25f};
	static const float level[][2] = {{0.25f, 0.5f}, {0.5f, 1}, {0.75f, 1},
		{1, 1}, {1, 1}, {0.75f, 0.5f}, {0.5f, 0}, {0.25f, 0}, {0, 0},
		{0, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(level); i++) {
		is[0].is_on = is[1].is_on = i < 5;
		character_switches_update(&character);
		for (int k = 0; k < 2; k++) {
			float u = level[i][k];

			assert_near(is[k].level, u, 0);
			assert_near(is[k].now, weight[k] * u * u * (3 - 2 * u),
				1e-6);
		}
	}
	/* Without a fade it is on or off at once. */
	is[0].fade_s = 0;
	for (int on = 1; on >= 0; on--) {
		is[0].is_on = on;
		/* Also in a pause. */
		character.step_s = 0;
		character_switches_update(&character);
		assert_near(is[0].now, on ? 0.5 : 0, 0);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_sine_runs_over_the_range),
		cmocka_unit_test(test_other_sources_have_their_scale),
		cmocka_unit_test(test_a_goal_is_reached_when_the_ease_ends),
		cmocka_unit_test(test_a_goal_moves_after_three_changes),
		cmocka_unit_test(test_steps_stay_within_the_stops),
		cmocka_unit_test(test_switches_fade_to_their_weights),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
