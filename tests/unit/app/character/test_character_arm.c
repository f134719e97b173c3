/* The parts of assets/arm.character: limits, grips and guards. */
#include "app/anim/math/vec.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const double rate_hz = 30.0;

static void press(struct acting *acting, enum button button, double until_s)
{
	acting_tap(acting, button, 0.1, rate_hz);
	acting_run_to(acting, until_s, rate_hz);
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

static void test_capsules_of_a_part_may_stand_in_any_order(void **state)
{
	static const char *const order[] = {
		"[part Arm]\nradius = 0.2\ntip = 0 0.5 0\nguard = 0.1 1 2 3\n",
		"[part Arm]\nguard = 0.1 1 2 3\ntip = 0 0.5 0\nradius = 0.2\n",
	};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (int i = 0; i < 2; i++) {
		const struct character_part *part;

		acting_expect(&acting, order[i]);
		part = part_of(&acting, "Arm");
		assert_int_equal(part->guard_count, 2);
		assert_near(part->guard[0].radius_m, 0.2, 1e-6);
		assert_near(part->guard[0].to[1], 0.5, 1e-6);
		assert_near(part->guard[1].radius_m, 0.1, 1e-6);
		assert_near(part->guard[1].to[2], 3.0, 1e-6);
	}
	acting_read(&acting,
		"[part Arm]\nguard = 1\nguard = 2\nguard = 3\nguard = 4\nradius = 5\n");
	assert_int_equal(acting.error, -EINVAL);
	assert_contains(acting.logged.sentence[0], "at most 4 capsules");
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

/* Also the first part of a character, or the only one. */
static void test_the_floor_stops_the_only_part(void **state)
{
	struct acting acting;
	float tip[3] = {0.0f, 0.0f, 3.0f};

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	acting_expect(&acting,
		"[part Arm]\npitch = 0 0 90 45\nguard = 0.1 0 0 3\n"
		"[buttons]\nDOWN = move Arm pitch 1\n");
	acting_press(&acting, BUTTON_DOWN);
	acting_run_to(&acting, 4.0, rate_hz);
	glm_mat4_mulv3(acting.instance->world[part_of(&acting, "Arm")->node],
		tip, 1.0f, tip);
	assert_true(tip[1] > 0.1f - 1e-3f);
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
	acting_tap(&acting, BUTTON_DOWN, 3.0, rate_hz);
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
	acting_tap(acting, button, seconds, rate_hz);
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
	acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
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

/* Whatever the order of the parts in the file. */
static void test_a_part_on_a_part_that_is_held_goes_with_both(void **state)
{
	static const char *const lists[] = {
		"[part Crate]\n[part Car]\n", "[part Car]\n[part Crate]\n"};
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	for (size_t i = 0; i < ARRAY_COUNT(lists); i++) {
		float before[3], after[3], car[2][3];
		char text[256];

		snprintf(text, sizeof(text),
			"%s[part Arm]\nheading = 0 -90 90 45\n"
			"[buttons]\nUP = attach Crate Car, attach Car Hand\n"
			"RIGHT hold = move Arm heading 1\n",
			lists[i]);
		acting_expect(&acting, text);
		acting.now_s = 0;
		press(&acting, BUTTON_UP, 0.5);
		acting_place(&acting, "Crate", before);
		acting_place(&acting, "Car", car[0]);
		acting_tap(&acting, BUTTON_RIGHT, 1.0, rate_hz);
		acting_place(&acting, "Crate", after);
		acting_place(&acting, "Car", car[1]);
		assert_true(glm_vec3_distance(car[0], car[1]) > 0.1f);
		assert_near(glm_vec3_distance(after, car[1]),
			glm_vec3_distance(before, car[0]), 1e-4);
	}
	acting_end(&acting);
}

/* The part's section need not name a freedom that a sequence's step does. */
static void test_a_button_moves_what_only_a_sequence_names(void **state)
{
	struct acting acting;

	(void)state;
	acting_begin(&acting, "assets/arm.glb");
	acting_expect(&acting,
		"[part Arm]\n[sequence bow]\nstep = down 1, Arm pitch 20\n"
		"[buttons]\nUP hold = move Arm pitch 1\n");
	acting_tap(&acting, BUTTON_UP, 1.0, rate_hz);
	assert_near(angle_of(&acting, "Arm", CHARACTER_PITCH), 45.0, 2.0);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_button_moves_what_only_a_sequence_names),
		cmocka_unit_test(
			test_a_part_on_a_part_that_is_held_goes_with_both),
		cmocka_unit_test(test_the_arm_loads_the_truck_by_a_sequence),
		cmocka_unit_test(
			test_what_the_arrows_move_depends_on_the_chosen_part),
		cmocka_unit_test(test_capsules_of_a_part_may_stand_in_any_order),
		cmocka_unit_test(test_guarded_parts_stay_above_the_floor),
		cmocka_unit_test(test_the_floor_stops_the_only_part),
		cmocka_unit_test(test_the_crate_changes_hands_without_a_jump),
		cmocka_unit_test(
			test_the_crate_keeps_its_bearing_while_it_is_carried),
		cmocka_unit_test(test_a_choice_goes_round),
		cmocka_unit_test(test_parts_do_not_pass_through_each_other),
		cmocka_unit_test(test_the_crate_is_gripped_and_dropped_by_hand),
		cmocka_unit_test(test_a_part_that_is_dropped_lies_on_the_truck),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
