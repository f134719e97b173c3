/* How fast the ground goes below a figure. */
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const double rate_hz = 60.0;

static void begin(struct acting *acting, const char *text)
{
	acting_begin(acting, "assets/walker.glb");
	acting_expect(acting, text);
	acting_run_to(acting, 0.5, rate_hz);
}

/* The foot that stands moves as fast as the ground; it is walk's 1.03 m/s. */
static void test_the_ground_goes_with_the_foot_on_it(void **state)
{
	struct acting acting;
	struct character_motion *motion;
	double way = 0.0;

	(void)state;
	begin(&acting, "[state a]\nclip = walk\n[motion]\nfeet = toe.L toe.R\n");
	motion = &acting.character->motion;
	for (int i = 0; i < 66; i++) {
		float from[3], to[3];
		const char *foot = motion->planted == 0 ? "toe.L" : "toe.R";
		int planted = motion->planted;

		acting_place(&acting, foot, from);
		acting_run_to(&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
		acting_place(&acting, foot, to);
		if (planted >= 0 && planted == motion->planted) {
			for (int axis = 0; axis < 2; axis++) {
				assert_near(motion->scroll[axis],
					from[2 * axis] - to[2 * axis], 1e-5);
				assert_near(motion->velocity[axis],
					(from[2 * axis] - to[2 * axis]) * rate_hz,
					1e-3);
			}
		}
		way += motion->scroll[1];
	}
	assert_near(way / 1.1, 1.03, 0.06);
	acting_end(&acting);
}

/* It goes on as fast as before. */
static void test_a_pause_stops_the_ground_alone(void **state)
{
	static const char *const motions[] = {
		"feet = toe.L toe.R\n", "speed = v\n", "clips = yes\n"};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct acting acting;
		const struct character_motion *motion;
		char text[256] = "[parameter v]\nrange = 0 2\nstart = 1.5\n"
				 "[state a]\nclip = walk\n"
				 "[buttons]\nUP = pause\n[motion]\n";
		float velocity[2];

		strcat(text, motions[i]);
		begin(&acting, text);
		motion = &acting.character->motion;
		acting_tap(&acting, BUTTON_UP, 0.1, rate_hz);
		memcpy(velocity, motion->velocity, sizeof(velocity));
		assert_true(fabsf(velocity[1]) > 0.5f);
		acting_run_to(&acting, 1.0, rate_hz);
		assert_all_near(motion->velocity, velocity, 2, 1e-6);
		assert_near(motion->scroll[0], 0, 0);
		assert_near(motion->scroll[1], 0, 0);
		acting_tap(&acting, BUTTON_UP, 2.5 / rate_hz, rate_hz);
		assert_true(motion->scroll[1] > 0.005f);
		acting_end(&acting);
	}
}

static void test_the_ground_goes_at_the_speed_of_a_parameter(void **state)
{
	struct acting acting;
	const struct character_motion *motion;

	(void)state;
	begin(&acting,
		"[parameter v]\nrange = 0 2\nstart = 1.5\n[state a]\n"
		"clip = rest\n[motion]\nspeed = v\n");
	motion = &acting.character->motion;
	assert_near(motion->velocity[0], 0, 0);
	assert_near(motion->velocity[1], 1.5, 0);
	assert_near(motion->scroll[1], 1.5 / rate_hz, 1e-4);
	acting_end(&acting);
}

/* A figure whose feet sway stands. */
static void test_the_ground_rests_below_a_figure_that_stands(void **state)
{
	struct acting acting;
	const struct character_motion *motion;

	(void)state;
	begin(&acting, "[state a]\nclip = idle\n[motion]\nfeet = toe.L toe.R\n");
	motion = &acting.character->motion;
	for (int i = 0; i < 100; i++) {
		acting_run_to(&acting, acting.now_s + 1.0 / rate_hz, rate_hz);
		assert_near(motion->scroll[0], 0, 0);
		assert_near(motion->scroll[1], 0, 0);
	}
	assert_true(motion->planted >= 0);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_ground_goes_with_the_foot_on_it),
		cmocka_unit_test(test_a_pause_stops_the_ground_alone),
		cmocka_unit_test(
			test_the_ground_goes_at_the_speed_of_a_parameter),
		cmocka_unit_test(
			test_the_ground_rests_below_a_figure_that_stands),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
