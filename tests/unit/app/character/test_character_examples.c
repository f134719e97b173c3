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
	acting_press(acting, button);
	acting_run_to(acting, acting->now_s + 0.1, rate_hz);
	acting_release(acting, button);
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

static void expect_place(const struct acting *acting, const char *node, float x,
	float y, float z)
{
	const float expected[3] = {x, y, z};
	float place[3];

	acting_place(acting, node, place);
	assert_all_near(place, expected, 3, 0.005);
}

static struct character_part *part_of(struct acting *acting, const char *name)
{
	struct character *character = acting->character;

	for (int i = 0; i < character->part_count; i++) {
		if (strcmp(character->part[i].name, name) == 0) {
			return &character->part[i];
		}
	}
	fail_msg("no part %s", name);
	return NULL;
}

static float angle_of(struct acting *acting, const char *name, int freedom)
{
	return part_of(acting, name)->freedom[freedom].value;
}

static void begin_arm(struct acting *acting)
{
	acting_begin(acting, "assets/arm.glb");
	acting_load(acting, "assets/arm.character");
	assert_int_equal(acting->error, 0);
}

/* The places are those of assets/arm.md. */
static void test_the_arm_loads_the_truck_by_a_sequence(void **state)
{
	struct acting acting;

	(void)state;
	begin_arm(&acting);
	acting_run_to(&acting, 0.5, rate_hz);
	expect_place(&acting, "Crate", 0.34f, 0.06f, 0.40f);
	press(&acting, BUTTON_F8, 6.1);
	expect_place(&acting, "Crate", -0.42f, 0.194f, 0.102f);
	acting_run_to(&acting, 7.8, rate_hz);
	expect_place(&acting, "Crate", -0.42f, 0.194f, 0.502f);
	expect_place(&acting, "Car", -0.42f, 0.0f, 0.62f);
	acting_run_to(&acting, 15.5, rate_hz);
	expect_place(&acting, "Crate", 0.34f, 0.06f, 0.40f);
	assert_near(angle_of(&acting, "arm", CHARACTER_PITCH), -28.0, 1e-4);
	assert_near(angle_of(&acting, "hand", CHARACTER_PITCH), 50.0, 1e-4);
	assert_near(angle_of(&acting, "truck", CHARACTER_Z), 0.0, 1e-6);
	acting_end(&acting);
}

/* From frame to frame, whoever holds it, and the truck stands meanwhile. */
static void test_the_crate_changes_hands_without_a_jump(void **state)
{
	struct acting acting;
	const struct character_part *crate;
	float before[3];
	int holder = -1, changes = 0;

	(void)state;
	begin_arm(&acting);
	crate = part_of(&acting, "crate");
	press(&acting, BUTTON_F8, 0.2);
	acting_place(&acting, "Crate", before);
	while (acting.now_s < 15.0) {
		float now[3], way[3];

		acting_run_to(&acting, acting.now_s + 1.0 / 60.0, 60.0);
		acting_place(&acting, "Crate", now);
		vec_subtract(now, before, way);
		assert_true(vec_length(way) < 0.06f);
		memcpy(before, now, sizeof(before));
		if (crate->holder != holder) {
			holder = crate->holder;
			changes++;
			assert_true(vec_length(way) < 0.005f);
			assert_near(angle_of(&acting, "truck", CHARACTER_Z),
				0.0, 1e-6);
		}
	}
	/* Hand, truck, hand, floor, and its own place at the end. */
	assert_int_equal(changes, 5);
	acting_end(&acting);
}

static void test_the_crate_keeps_its_bearing_while_it_is_carried(void **state)
{
	static const double ends_s[] = {2.8, 4.2, 4.9, 10.7, 12.1, 12.8};
	struct acting acting;
	int node;

	(void)state;
	begin_arm(&acting);
	node = part_of(&acting, "crate")->node;
	acting_press(&acting, BUTTON_F8);
	for (size_t i = 0; i < ARRAY_COUNT(ends_s); i++) {
		acting_run_to(&acting, ends_s[i], 50.0);
		for (int axis = 0; axis < 3; axis++) {
			assert_near(acting.instance->world[node][axis][axis],
				1.0, 0.01);
		}
	}
	acting_end(&acting);
}

static void test_what_the_arrows_move_depends_on_the_chosen_part(void **state)
{
	struct acting acting;
	float pitch;

	(void)state;
	begin_arm(&acting);
	acting_press(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 1.0, rate_hz);
	acting_release(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 1.2, rate_hz);
	assert_near(angle_of(&acting, "arm", CHARACTER_PITCH), 17.0, 2.0);
	press(&acting, BUTTON_ENTER, 1.6);
	pitch = angle_of(&acting, "arm", CHARACTER_PITCH);
	acting_press(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 2.0, rate_hz);
	acting_release(&acting, BUTTON_DOWN);
	assert_near(angle_of(&acting, "arm", CHARACTER_PITCH), pitch, 0.0);
	assert_true(angle_of(&acting, "forearm", CHARACTER_PITCH) > 45.0f);
	acting_end(&acting);
}

/* After the last part comes the first one again. */
static void test_a_choice_goes_round(void **state)
{
	struct acting acting;

	(void)state;
	begin_arm(&acting);
	for (int i = 1; i <= 5; i++) {
		press(&acting, BUTTON_ENTER, 0.5 * i);
		assert_near(acting_value(&acting, "moving"), i % 5, 0.0);
	}
	acting_end(&acting);
}

/* Every part is lowered as far as it goes. */
static void test_guarded_parts_stay_above_the_floor(void **state)
{
	struct acting acting;
	float tip[3] = {0.0f, 0.0f, 0.14f};

	(void)state;
	begin_arm(&acting);
	for (int i = 0; i < 3; i++) {
		acting_press(&acting, BUTTON_DOWN);
		acting_run_to(&acting, acting.now_s + 4.0, rate_hz);
		acting_release(&acting, BUTTON_DOWN);
		press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	}
	glm_mat4_mulv3(acting.instance->world[part_of(&acting, "finger")->node],
		tip, 1.0f, tip);
	assert_true(tip[1] > 0.014f);
	assert_true(tip[1] < 0.3f);
	acting_end(&acting);
}

/* The truck in the arm's way stops it, and the arm's base stops the hand. */
static void test_parts_do_not_pass_through_each_other(void **state)
{
	struct acting acting;
	float hand[3], truck[3];

	(void)state;
	begin_arm(&acting);
	press(&acting, BUTTON_F8, 4.9); /* the hand is at the load floor */
	press(&acting, BUTTON_LEFT, 5.0);
	for (int i = 0; i < 4; i++) {
		press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	}
	acting_press(&acting, BUTTON_DOWN);
	acting_run_to(&acting, acting.now_s + 3.0, rate_hz);
	acting_release(&acting, BUTTON_DOWN);
	acting_place(&acting, "Hand", hand);
	acting_place(&acting, "Car", truck);
	/* Its cab would be below the hand at -0.118 - 0.1. */
	assert_true(truck[2] > 0.06f);
	assert_true(angle_of(&acting, "truck", CHARACTER_Z) > -0.2f);
	acting_end(&acting);
}

/* Chooses the fingers and moves them for so long. */
static void move_fingers(
	struct acting *acting, enum button button, double seconds)
{
	while (acting_value(acting, "moving") != 3.0) {
		press(acting, BUTTON_ENTER, acting->now_s + 0.3);
	}
	acting_press(acting, button);
	acting_run_to(acting, acting->now_s + seconds, rate_hz);
	acting_release(acting, button);
	acting_run_to(acting, acting->now_s + 1.0, rate_hz);
}

static void test_the_crate_is_gripped_and_dropped_by_hand(void **state)
{
	struct acting acting;
	const struct character_part *crate;
	float place[3];

	(void)state;
	begin_arm(&acting);
	crate = part_of(&acting, "crate");
	for (int i = 0; i < 3; i++) {
		press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	}
	/* The open fingers are around it. */
	press(&acting, BUTTON_F8, acting.now_s + 1.63);
	assert_true(crate->holder < 0);
	move_fingers(&acting, BUTTON_DOWN, 0.8);
	assert_int_equal(crate->holder, part_of(&acting, "hand")->node);
	press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, acting.now_s + 1.0, rate_hz);
	acting_release(&acting, BUTTON_UP);
	acting_place(&acting, "Crate", place);
	assert_true(place[1] > 0.3f);
	move_fingers(&acting, BUTTON_UP, 0.3);
	acting_place(&acting, "Crate", place);
	assert_near(place[1], 0.06, 1e-4);
	assert_int_equal(crate->holder, CHARACTER_GROUND);
	acting_end(&acting);
}

/* It falls through the air first. */
static void test_a_part_that_is_dropped_lies_on_the_truck(void **state)
{
	struct acting acting;
	const struct character_part *crate;
	float place[3];

	(void)state;
	begin_arm(&acting);
	crate = part_of(&acting, "crate");
	press(&acting, BUTTON_F8, 4.15); /* above the truck */
	press(&acting, BUTTON_LEFT, 4.2);
	acting_place(&acting, "Crate", place);
	assert_true(place[1] > 0.35f);
	for (int i = 0; i < 3; i++) {
		press(&acting, BUTTON_ENTER, acting.now_s + 0.3);
	}
	acting_press(&acting, BUTTON_UP);
	acting_run_to(&acting, acting.now_s + 0.1, rate_hz);
	acting_place(&acting, "Crate", place);
	assert_true(place[1] > 0.2f);
	acting_release(&acting, BUTTON_UP);
	acting_run_to(&acting, acting.now_s + 1.0, rate_hz);
	acting_place(&acting, "Crate", place);
	assert_near(place[1], 0.194, 1e-3);
	assert_int_equal(crate->holder, part_of(&acting, "truck")->node);
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
		cmocka_unit_test(test_the_arm_loads_the_truck_by_a_sequence),
		cmocka_unit_test(
			test_what_the_arrows_move_depends_on_the_chosen_part),
		cmocka_unit_test(test_guarded_parts_stay_above_the_floor),
		cmocka_unit_test(test_the_crate_changes_hands_without_a_jump),
		cmocka_unit_test(
			test_the_crate_keeps_its_bearing_while_it_is_carried),
		cmocka_unit_test(test_a_choice_goes_round),
		cmocka_unit_test(test_parts_do_not_pass_through_each_other),
		cmocka_unit_test(test_the_crate_is_gripped_and_dropped_by_hand),
		cmocka_unit_test(test_a_part_that_is_dropped_lies_on_the_truck),
		cmocka_unit_test(test_the_walker_keeps_to_uneven_ground),
		cmocka_unit_test(test_the_walkers_cape_hangs_from_its_back),
		cmocka_unit_test(test_the_tours_of_our_own_models_run),
		cmocka_unit_test(test_the_tours_of_all_examples_run),
		cmocka_unit_test(test_a_ball_that_nothing_aims_at_moves_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
