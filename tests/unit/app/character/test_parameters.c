/*
 * How parameters ease and what they follow, and the action "step" against a
 * search among all stops.
 */
#include "app/character/run/parameters.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <stdio.h>

static const double rate_hz = 50.0;

enum {
	STOPS = 4
};

static const float stops[STOPS] = {0, 1, 2.5f, 4};

/* The next stop above the goal, or below; the outermost one behind the last. */
static float next_stop(float goal, bool up)
{
	float next = up ? stops[STOPS - 1] : stops[0];

	for (int i = 0; i < STOPS; i++) {
		float stop = stops[i];

		if (up ? stop > goal && stop < next
		       : stop < goal && stop > next) {
			next = stop;
		}
	}
	return next;
}

static struct character_parameter parameter_at(float goal)
{
	struct character_parameter parameter = {
		.range = {0, 4},
		.stop_count = STOPS,
		.value = goal,
		.goal = goal,
	};

	for (int i = 0; i < STOPS; i++) {
		parameter.stop[i] = stops[i];
	}
	return parameter;
}

static void test_a_step_goes_to_the_next_stop(void **state)
{
	(void)state;
	for (int eighth = 0; eighth <= 32; eighth++) {
		float goal = 0.125f * (float)eighth;

		for (int up = 0; up < 2; up++) {
			struct character_parameter one = parameter_at(goal);

			character_parameter_step(&one, up ? 1 : -1);
			assert_near(one.goal, next_stop(goal, up), 0.0);
		}
	}
}

/* A range may go beyond the outermost stops. */
static void test_a_step_from_outside_goes_to_the_outermost_stop(void **state)
{
	struct character_parameter one;

	(void)state;
	for (int up = 0; up < 2; up++) {
		one = parameter_at(up ? -1.0f : 9.0f);
		one.range[0] = -1;
		one.range[1] = 9;
		character_parameter_step(&one, up ? 1 : -1);
		assert_near(one.goal, up ? stops[0] : stops[STOPS - 1], 0.0);
	}
}

static void test_several_steps_go_as_far_as_one_after_the_other(void **state)
{
	(void)state;
	for (int eighth = 0; eighth <= 32; eighth++) {
		for (int steps = -5; steps <= 5; steps++) {
			float goal = 0.125f * (float)eighth;
			struct character_parameter one = parameter_at(goal);
			float wanted = goal;

			if (steps == 0) {
				continue;
			}
			for (int i = 0; i < (steps < 0 ? -steps : steps); i++) {
				wanted = next_stop(wanted, steps > 0);
			}
			character_parameter_step(&one, steps);
			assert_near(one.goal, wanted, 0.0);
		}
	}
}

static void test_a_new_goal_begins_its_way_at_the_value(void **state)
{
	struct character_parameter one = parameter_at(1);

	(void)state;
	one.value = 0.5f;
	one.elapsed_s = 0.25f;
	character_parameter_set(&one, 1);
	assert_near(one.elapsed_s, 0.25, 0.0);
	character_parameter_set(&one, 9);
	assert_near(one.goal, 4.0, 0.0);
	assert_near(one.from, 0.5, 0.0);
	assert_near(one.elapsed_s, 0.0, 0.0);
	character_parameter_set(&one, -9);
	assert_near(one.goal, 0.0, 0.0);
}

static void test_a_parameter_eases_to_its_goal(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 2\nease = 1\n[buttons]\nUP = add v 1\n");
	acting_tap(&acting, BUTTON_UP, 1.0 / rate_hz, rate_hz);
	acting_run_to(&acting, 0.5, rate_hz);
	assert_near(acting_value(&acting, "v"), 0.5, 0.05);
	acting_run_to(&acting, 1.2, rate_hz);
	assert_near(acting_value(&acting, "v"), 1.0, 0.0);
	acting_tap(&acting, BUTTON_UP, 1.0 / rate_hz, rate_hz);
	acting_tap(&acting, BUTTON_UP, 1.0 / rate_hz, rate_hz);
	acting_run_to(&acting, 4.0, rate_hz);
	assert_near(acting_value(&acting, "v"), 2.0, 0.0);
	acting_end(&acting);
}

/* As long as a button is held, the goal changes in every frame. */
static double follow(double frames_a_second)
{
	struct acting acting;
	double value;

	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 10\nease = 0.4\n"
		"[buttons]\nUP hold = add v 2\n");
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, 2.0, frames_a_second);
	value = acting_value(&acting, "v");
	acting_release(&acting, BUTTON_UP);
	acting_run_to(&acting, 2.6, frames_a_second);
	assert_near(acting_value(&acting, "v"), 4.0, 0.1);
	acting_end(&acting);
	return value;
}

static void test_a_parameter_keeps_up_with_a_goal_that_moves(void **state)
{
	double slow = follow(25.0), fast = follow(100.0);

	(void)state;
	/* It has no more delay than it takes to ease to a goal that stays. */
	assert_true(slow > 4.0 - 0.4 * 2.0);
	assert_near(slow, fast, 0.15);
}

/* How a parameter of ease 0.5 s follows goals, computed in double. */
struct follower {
	double value, from, elapsed_s, goal;
	int changes; /* frames in a row with another goal */
};

static void follow_goal(struct follower *it, double goal, double step_s)
{
	const double ease_s = 0.5;
	double u;

	it->changes = goal == it->goal ? 0 : it->changes + 1;
	if (goal != it->goal) {
		it->goal = goal;
		it->from = it->value;
		it->elapsed_s = 0;
	}
	if (it->changes >= 3) {
		/* A third of the ease leaves 1/e of the difference. */
		it->value = goal +
			(it->value - goal) * exp(-step_s / (ease_s / 3.0));
		it->from = it->value;
		it->elapsed_s = 0;
		return;
	}
	it->elapsed_s += step_s;
	u = it->elapsed_s >= ease_s ? 1.0 : it->elapsed_s / ease_s;
	it->value = it->from + (goal - it->from) * u * u * (3.0 - 2.0 * u);
}

/* The goal moves from the second frame on, as in 1, 2, 3... frames in a row. */
static void test_a_value_decays_behind_a_goal_that_moves_in_a_row(void **state)
{
	static const char moves[] = "0110111011110111111100000000000000110";
	struct follower wanted = {5, 5, 0, 5, 0};
	struct character_parameter *one;
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter v]\nrange = 0 100\nstart = 5\nease = 0.5\n");
	one = &acting.character->parameter[0];
	for (int i = 0; moves[i]; i++) {
		double goal =
			wanted.goal + (moves[i] == '1' ? 2.0 + i % 3 : 0.0);

		character_parameter_set(one, (float)goal);
		follow_goal(&wanted, goal, 1.0 / rate_hz);
		acting_run_to(&acting, acting.now_s + 0.5 / rate_hz, rate_hz);
		assert_near(one->value, wanted.value, 1e-4);
	}
	acting_end(&acting);
}

static void test_sources_of_parameters(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_expect(&acting,
		"[parameter t]\nrange = 0 100\nsource = time 2 1\n"
		"[parameter s]\nrange = -1 3\nsource = sine 4\n"
		"[parameter p]\nrange = -9 9\nsource = s 2 -1\n");
	acting_run_to(&acting, 1.0, rate_hz);
	assert_near(acting_value(&acting, "t"), 3.0, 1e-4);
	assert_near(acting_value(&acting, "s"), 3.0, 1e-4);
	assert_near(acting_value(&acting, "p"), 5.0, 1e-3);
	acting_end(&acting);
}

/* A factor of 1 and a summand of 0, unless the file says others. */
static void test_sources_have_a_scale_and_an_offset(void **state)
{
	static const struct {
		const char *source;
		double value;
	} cases[] = {{"time", 2}, {"time 3", 6}, {"time 3 -1", 5},
		{"base", 0.75}, {"base 4", 3}, {"base -2 5", 3.5},
		{"part Arm pitch", 20}, {"part Arm pitch 0.5", 10},
		{"part Arm pitch 0.5 -3", 7}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct acting acting;
		char text[256];

		snprintf(text, sizeof(text),
			"[part Arm]\npitch = 20\n[parameter base]\n"
			"start = 0.75\n[parameter p]\nrange = -99 99\n"
			"source = %s\n",
			cases[i].source);
		acting_begin(&acting, "assets/arm.glb");
		acting_expect(&acting, text);
		acting_run_to(&acting, 2.0, 20.0);
		assert_near(acting_value(&acting, "p"), cases[i].value, 0.16);
		acting_end(&acting);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_step_goes_to_the_next_stop),
		cmocka_unit_test(
			test_a_step_from_outside_goes_to_the_outermost_stop),
		cmocka_unit_test(
			test_several_steps_go_as_far_as_one_after_the_other),
		cmocka_unit_test(test_a_new_goal_begins_its_way_at_the_value),
		cmocka_unit_test(test_a_parameter_eases_to_its_goal),
		cmocka_unit_test(
			test_a_parameter_keeps_up_with_a_goal_that_moves),
		cmocka_unit_test(
			test_a_value_decays_behind_a_goal_that_moves_in_a_row),
		cmocka_unit_test(test_sources_of_parameters),
		cmocka_unit_test(test_sources_have_a_scale_and_an_offset),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
