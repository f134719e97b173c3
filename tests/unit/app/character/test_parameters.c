/* The action "step" against a search among all stops. */
#include "app/character/run/parameters.h"
#include "tests/support/test.h"

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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_step_goes_to_the_next_stop),
		cmocka_unit_test(
			test_a_step_from_outside_goes_to_the_outermost_stop),
		cmocka_unit_test(
			test_several_steps_go_as_far_as_one_after_the_other),
		cmocka_unit_test(test_a_new_goal_begins_its_way_at_the_value),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
