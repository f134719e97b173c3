/* The example files of assets/characters act on the sample models. */
#include "app/anim/math/vec.h"
#include "app/character/run/effects.h"
#include "tests/support/model/acting.h"
#include "tests/support/model/samples.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <math.h>
#include <string.h>

static const double rate_hz = 30.0;

static void begin(struct acting *acting, const char *model, const char *file)
{
	samples_require(model);
	acting_begin(acting, samples_path(model).text);
	acting_load(acting, file);
	assert_int_equal(acting->error, 0);
}

static void press(struct acting *acting, enum button button, double until_s)
{
	acting_tap(acting, button, 0.1, rate_hz);
	acting_run_to(acting, until_s, rate_hz);
}

/* How far a node is from a target's point. */
static double distance_to_target(
	const struct acting *acting, const char *node, int target)
{
	float place[3], away[3];

	acting_place(acting, node, place);
	vec_subtract(place, acting->character->target[target].point, away);
	return (double)vec_length(away);
}

static void test_cesium_man_walks_faster_and_lifts_an_arm(void **state)
{
	struct acting acting;
	float low[3], high[3], still[3], later[3];
	float slow;

	(void)state;
	begin(&acting, "CesiumMan.glb", "assets/characters/CesiumMan.character");
	acting_run_to(&acting, 3.0, rate_hz);
	slow = acting.character->motion.velocity[1];
	assert_true(slow > 0.3f);
	acting_place(&acting, "Skeleton_arm_joint_L__2_", low);
	for (int i = 0; i < 4; i++) {
		press(&acting, BUTTON_UP, 4.0 + i);
	}
	assert_near(acting_value(&acting, "speed"), 2.0, 0.0);
	press(&acting, BUTTON_LEFT, 9.0);
	acting_place(&acting, "Skeleton_arm_joint_L__2_", high);
	assert_true(high[1] > low[1] + 0.2f);
	/* At speed 0 it stands. */
	for (int i = 0; i < 8; i++) {
		press(&acting, BUTTON_DOWN, 10.0 + i);
	}
	acting_run_to(&acting, 19.0, rate_hz);
	acting_place(&acting, "leg_joint_L_5", still);
	acting_run_to(&acting, 20.0, rate_hz);
	acting_place(&acting, "leg_joint_L_5", later);
	assert_all_near(later, still, 3, 1e-6);
	acting_end(&acting);
}

static void test_cesium_man_looks_at_the_ball_and_shivers(void **state)
{
	struct acting acting;
	float before[3], after[3];

	(void)state;
	begin(&acting, "CesiumMan.glb", "assets/characters/CesiumMan.character");
	press(&acting, BUTTON_ENTER, 2.0);
	assert_near(acting.character->switches[3]->now, 1.0, 0.0);
	acting_place(&acting, "Skeleton_neck_joint_2", before);
	press(&acting, BUTTON_F6, 4.0); /* alone it waits for F8 */
	acting_place(&acting, "Skeleton_neck_joint_2", after);
	assert_string_equal(acting.character->switches[2]->name, "cold");
	assert_near(acting.character->switches[2]->now, 1.0, 0.0);
	assert_true(fabsf(after[0] - before[0]) + fabsf(after[1] - before[1]) +
			fabsf(after[2] - before[2]) >
		1e-4f);
	acting_end(&acting);
}

static void test_rigged_figure_reaches_the_ball_by_the_shared_file(void **state)
{
	struct acting acting;
	double before;

	(void)state;
	begin(&acting, "RiggedFigure.glb",
		"assets/characters/RiggedFigure.character");
	assert_int_equal(acting.character->text.file_count, 2);
	acting_run_to(&acting, 1.0, rate_hz);
	before = distance_to_target(&acting, "arm_joint_R_3", 0);
	press(&acting, BUTTON_RIGHT, 2.5);
	assert_true(
		distance_to_target(&acting, "arm_joint_R_3", 0) < 0.5 * before);
	for (int i = 0; i < 4; i++) {
		press(&acting, BUTTON_DOWN, 3.0 + 0.5 * i);
	}
	acting_run_to(&acting, 6.0, rate_hz);
	assert_string_equal(acting_state(&acting), "stand");
	acting_end(&acting);
}

static void test_the_cube_mixes_three_expressions_and_a_morph(void **state)
{
	struct acting acting;
	const float *weight;

	(void)state;
	begin(&acting, "AnimatedMorphCube.glb",
		"assets/characters/AnimatedMorphCube.character");
	weight = acting.instance->pose.weight;
	press(&acting, BUTTON_RIGHT, 1.5);
	assert_near(weight[0], 1.0, 1e-6);
	assert_near(weight[1], 0.0, 1e-6);
	press(&acting, BUTTON_ENTER, 3.0);
	press(&acting, BUTTON_UP, 4.0);
	assert_near(weight[0], 0.8, 1e-6);
	press(&acting, BUTTON_DOWN, 5.0);
	assert_near(weight[0], 1.2, 1e-5);
	assert_near(weight[1], 0.8, 1e-5);
	acting_end(&acting);
}

/* A hill to the right: 0.1 m for each metre. */
static float hill(void *user, float x, float z)
{
	(void)user;
	(void)z;
	return 0.1f * x;
}

static void test_the_walker_keeps_to_uneven_ground(void **state)
{
	struct acting acting;
	float left[3], right[3], level[3];

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, "assets/walker.character");
	assert_int_equal(acting.error, 0);
	acting_run_to(&acting, 1.0, rate_hz);
	acting_place(&acting, "foot.R", level);
	acting.character->ground_height = hill;
	acting_run_to(&acting, 2.0, rate_hz);
	acting_place(&acting, "foot.L", left);
	acting_place(&acting, "foot.R", right);
	assert_near(left[1] - right[1], 0.1f * (left[0] - right[0]), 0.01);
	assert_near(right[1], level[1] + 0.1f * right[0], 0.01);
	acting_end(&acting);
}

static void test_the_walkers_cape_hangs_from_its_back(void **state)
{
	struct acting acting;
	const struct character_cape *cape;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, "assets/walker.character");
	cape = acting.character->cape;
	acting_run_to(&acting, 0.5, rate_hz);
	assert_false(cape->worn);
	/* F6 goes on to the cape, which F8 puts on. */
	for (int i = 0; i < 6; i++) {
		press(&acting, BUTTON_F6, 0.8 + 0.2 * i);
	}
	press(&acting, BUTTON_F8, 3.0);
	assert_true(cape->worn);
	assert_near(cape->is.now, 1.0, 0.0);
	for (int i = 0; i < cape->cloth.count; i++) {
		assert_true(cape->cloth.position[i][1] > 0.4f);
		assert_true(cape->cloth.position[i][2] < 0.1f);
	}
	press(&acting, BUTTON_F8, 4.0);
	assert_false(cape->worn);
	acting_end(&acting);
}

static void test_the_tours_of_our_own_models_run(void **state)
{
	static const char *const files[][2] = {
		{"assets/walker.glb", "assets/walker.character"},
		{"assets/arm.glb", "assets/arm.character"},
		{"assets/face.glb", "assets/face.character"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(files); i++) {
		struct acting acting;

		acting_begin(&acting, files[i][0]);
		acting_load(&acting, files[i][1]);
		assert_int_equal(acting.error, 0);
		acting.character->touring = true;
		acting.character->tour_next = acting.character->scene.tour;
		acting_run_to(&acting, 40.0, rate_hz);
		assert_true(acting.character->touring);
		acting_end(&acting);
	}
}

static void test_the_tours_of_all_examples_run(void **state)
{
	static const char *const models[] = {
		"CesiumMan", "RiggedFigure", "AnimatedMorphCube"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(models); i++) {
		struct acting acting;
		char model[64], file[128];

		snprintf(model, sizeof(model), "%s.glb", models[i]);
		snprintf(file, sizeof(file), "assets/characters/%s.character",
			models[i]);
		begin(&acting, model, file);
		acting.character->touring = true;
		acting.character->tour_next = acting.character->scene.tour;
		acting_run_to(&acting, 25.0, rate_hz);
		assert_true(acting.character->touring);
		acting_end(&acting);
	}
}

static void test_a_ball_that_nothing_aims_at_moves_too(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	acting_load(&acting, "tests/fixtures/ball.character");
	assert_int_equal(acting.error, 0);
	acting_run_to(&acting, 1.0, rate_hz);
	assert_near(acting.character->target[0].point[0],
		acting_value(&acting, "side"), 0.0);
	assert_near(acting.character->target[0].point[2], 0.5, 0.0);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_cesium_man_walks_faster_and_lifts_an_arm),
		cmocka_unit_test(test_cesium_man_looks_at_the_ball_and_shivers),
		cmocka_unit_test(
			test_rigged_figure_reaches_the_ball_by_the_shared_file),
		cmocka_unit_test(
			test_the_cube_mixes_three_expressions_and_a_morph),
		cmocka_unit_test(test_the_walker_keeps_to_uneven_ground),
		cmocka_unit_test(test_the_walkers_cape_hangs_from_its_back),
		cmocka_unit_test(test_the_tours_of_our_own_models_run),
		cmocka_unit_test(test_the_tours_of_all_examples_run),
		cmocka_unit_test(test_a_ball_that_nothing_aims_at_moves_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
