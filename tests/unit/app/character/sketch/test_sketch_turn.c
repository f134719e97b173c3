/* How parts of rigid models turn, and which parts come first. */
#include "app/character/sketch/sketch_parts.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/character/sketch/made.h"

#include <stdio.h>
#include <string.h>

static struct sketch_parts find(
	const struct made *made, int count, struct scene *scene)
{
	static const bool no_joint[MOST], named[MOST] = {true, true, true, true};
	struct sketch_parts parts;

	make(made, count, scene);
	assert_int_equal(
		sketch_find_parts(&scene->model, no_joint, named, true, &parts),
		0);
	return parts;
}

/* Asks for the form and the axis of a single part. */
static void expect_turn(struct made one, enum sketch_turn_form form, int axis)
{
	struct scene scene;
	struct sketch_parts parts;

	one.name = "one";
	one.parent = -1;
	parts = find(&one, 1, &scene);
	assert_int_equal(parts.count, 1);
	assert_int_equal(parts.turn[0].form, form);
	assert_int_equal(parts.turn[0].axis.axis, axis);
}

static void test_a_flat_part_turns_in_its_plane(void **state)
{
	(void)state;
	expect_turn((struct made){.low = {-0.05f, -0.1f, 0},
			    .high = {0.05f, 0.8f, 0}},
		SKETCH_TURN_NEEDLE, 2);
	expect_turn((struct made){.low = {-1, -0.01f, -0.05f},
			    .high = {0, 0.01f, 0.05f}},
		SKETCH_TURN_NEEDLE, 1);
	expect_turn((struct made){.low = {-0.1f, -0.33f, -0.33f},
			    .high = {0.1f, 0.33f, 0.33f}},
		SKETCH_TURN_DISC, 0);
	/* Three blades of a windmill. */
	expect_turn((struct made){.low = {-1.76f, -1.04f, -0.05f},
			    .high = {1.76f, 2, 0.05f}},
		SKETCH_TURN_DISC, 2);
}

static void test_a_part_on_a_hinge_turns_about_its_edge(void **state)
{
	const float half = 0.70710678f;
	/* A door whose pivot is at its lower corner. */
	struct made corner = {.low = {-0.02f, 0, -1}, .high = {0.02f, 2, 0}};

	(void)state;
	/* A door, a flap and a wing. */
	expect_turn((struct made){.low = {-0.02f, -0.5f, -1},
			    .high = {0.02f, 0.5f, 0}},
		SKETCH_TURN_HINGE, 1);
	expect_turn(
		(struct made){.low = {-2, -0.02f, -0.4f}, .high = {2, 0.02f, 0}},
		SKETCH_TURN_HINGE, 0);
	expect_turn((struct made){.low = {0, -0.02f, -0.1f},
			    .high = {1, 0.02f, 0.4f}},
		SKETCH_TURN_HINGE, 2);
	expect_turn(corner, SKETCH_TURN_HINGE, 1);
	/* It was modelled on its back: its upright edge is that of z. */
	memcpy(corner.rotation, (float[4]){half, 0, 0, half},
		sizeof(corner.rotation));
	expect_turn(corner, SKETCH_TURN_HINGE, 2);
}

static void test_a_thick_part_turns_freely(void **state)
{
	(void)state;
	/* A head, a ball, an arm beside its pivot, a needle beside it. */
	expect_turn((struct made){.low = {-0.1f, -0.1f, -0.1f},
			    .high = {0.1f, 0.1f, 0.1f}},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.1f, -0.1f, -0.1f},
			    .high = {0.1f, 0.1f, 0.1f},
			    .form = BALL},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.05f, -2, -0.05f},
			    .high = {0.05f, -1, 0.05f}},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.05f, 3, 0}, .high = {0.05f, 4, 0}},
		SKETCH_TURN_FREE, 0);
}

static void test_a_round_part_turns_about_its_axle(void **state)
{
	const float half = 0.70710678f;
	/* A head that stands on its neck. */
	struct made head = {.low = {-0.2f, 0, -0.2f},
		.high = {0.2f, 0.3f, 0.2f},
		.form = ROUND_Y};

	(void)state;
	/* The wheel of a loader, a drum, a wheel on its inner side, a turret. */
	expect_turn((struct made){.low = {-0.4f, -0.8f, -0.8f},
			    .high = {0.4f, 0.8f, 0.8f},
			    .form = ROUND_X},
		SKETCH_TURN_DISC, 0);
	expect_turn((struct made){.low = {-0.8f, -0.6f, -0.6f},
			    .high = {0.8f, 0.6f, 0.6f},
			    .form = ROUND_X},
		SKETCH_TURN_DISC, 0);
	expect_turn((struct made){.low = {-0.5f, -0.5f, 0},
			    .high = {0.5f, 0.5f, 0.6f},
			    .form = ROUND_Z},
		SKETCH_TURN_DISC, 2);
	expect_turn((struct made){.low = {-0.5f, -0.2f, -0.5f},
			    .high = {0.5f, 0.3f, 0.5f},
			    .form = ROUND_Y},
		SKETCH_TURN_DISC, 1);
	expect_turn(head, SKETCH_TURN_FREE, 0);
	memcpy(head.rotation, (float[4]){half, 0, 0, half},
		sizeof(head.rotation));
	expect_turn(head, SKETCH_TURN_DISC, 1);
	/* A pipe; a wheel beside its pivot. */
	expect_turn((struct made){.low = {-1, -0.3f, -0.3f},
			    .high = {0, 0.3f, 0.3f},
			    .form = ROUND_X},
		SKETCH_TURN_FREE, 0);
	expect_turn((struct made){.low = {-0.4f, -0.8f, -1.1f},
			    .high = {0.4f, 0.8f, 0.5f},
			    .form = ROUND_X},
		SKETCH_TURN_FREE, 0);
}

static void test_a_thick_rod_swings_across_its_length(void **state)
{
	struct scene scene;
	struct sketch_parts parts;
	struct made chain[] = {{"rod", -1, {-0.05f, -1, -0.05f},
				       {0.05f, 0, 0.05f}, .form = BOX},
		{"tip", 0, {-0.1f, -0.1f, -0.1f}, {0.1f, 0.1f, 0.1f},
			.form = BOX}};

	(void)state;
	expect_turn(chain[0], SKETCH_TURN_ROD, 1);
	/* What hangs on it shows how it turns about its length. */
	parts = find(chain, 2, &scene);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_FREE);
}

static void test_a_rod_over_a_disc_is_a_hand(void **state)
{
	struct made clock[] = {
		{"dial", -1, {-1, -1, -0.1f}, {1, 1, 0.1f}, .form = BOX},
		{"hand", 0, {-0.04f, -0.1f, 0.1f}, {0.04f, 0.8f, 0.18f},
			.form = BOX}};
	struct scene scene;
	struct sketch_parts parts;

	(void)state;
	clock[1].low[2] = -0.04f;
	clock[1].high[2] = 0.04f;
	parts = find(clock, 2, &scene);
	assert_int_equal(parts.node[0], 1);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_NEEDLE);
	assert_int_equal(parts.turn[0].axis.axis, 2);
	/* The barrel of a tank is longer or away from the middle. */
	clock[1].place[0] = 0.5f;
	parts = find(clock, 2, &scene);
	assert_int_equal(parts.turn[1].form, SKETCH_TURN_ROD);
	clock[1].place[0] = 0;
	clock[1].high[1] = 1.2f;
	parts = find(clock, 2, &scene);
	assert_int_equal(parts.turn[1].form, SKETCH_TURN_ROD);
}

static void test_a_ring_of_blades_turns_their_hub(void **state)
{
	const float c = 0.5f, s = 0.8660254f;
	/* Blades as thick as they are wide, which are no disc together. */
	struct made rotor[] = {
		{"hub", -1, {-1, -1, -1}, {1, 1, 1}, .form = BALL},
		{"blade1", 0, {-1, 1, -1}, {1, 9, 1}, .form = BOX},
		{"blade2", 0, {-1, 1, -1}, {1, 9, 1}, {0, 0, s, c}, .form = BOX},
		{"blade3", 0, {-1, 1, -1}, {1, 9, 1}, {0, 0, -s, c},
			.form = BOX}};
	struct scene scene;
	struct sketch_parts parts = find(rotor, 4, &scene);

	(void)state;
	assert_int_equal(parts.node[0], 0);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_DISC);
	assert_int_equal(parts.turn[0].axis.axis, 2);
	/* Two at the same place, one out of place, and only two of them. */
	memcpy(rotor[3].rotation, rotor[2].rotation, sizeof(rotor[3].rotation));
	parts = find(rotor, 4, &scene);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_FREE);
	rotor[3].rotation[2] = -s;
	rotor[3].place[1] = 3;
	parts = find(rotor, 4, &scene);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_FREE);
	parts = find(rotor, 3, &scene);
	assert_int_equal(parts.turn[0].form, SKETCH_TURN_FREE);
}

static void test_needles_come_first(void **state)
{
	static const struct made panel[] = {
		{"board", -1, {-3, -1, 0}, {3, 1, 0}, .form = BOX},
		{"dial", 0, {-1, -1, 0}, {1, 1, 0}, .form = BOX},
		{"knob", 0, {-0.1f, -0.1f, 0}, {0.1f, 0.1f, 0}, .form = BOX},
		{"needle", 1, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, .form = BOX}};
	static const char *const wanted[] = {"needle", "board", "dial", "knob"};
	struct scene scene;
	struct sketch_parts parts = find(panel, ARRAY_COUNT(panel), &scene);

	(void)state;
	assert_int_equal(parts.count, ARRAY_COUNT(panel));
	for (int i = 0; i < parts.count; i++) {
		assert_string_equal(panel[parts.node[i]].name, wanted[i]);
	}
}

static void test_buttons_move_a_needle_beside_its_dial(void **state)
{
	static const struct made gauge[] = {
		{"dial", -1, {-1, -1, -0.01f}, {1, 1, 0}, .form = BOX},
		{"needle", -1, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, .form = BOX}};
	struct scene scene;
	struct sketch_parts parts = find(gauge, ARRAY_COUNT(gauge), &scene);

	(void)state;
	assert_true(parts.moved);
	assert_int_equal(parts.node[0], 1);
	/* Alone, it would be turned by turning the camera. */
	assert_false(find(&gauge[1], 1, &scene).moved);
}

static void expect_buttons(struct made one, const char *wanted)
{
	struct made made[2] = {
		{"dial", -1, {-1, -1, -1}, {1, 1, 1}, .form = BOX}, one};
	struct scene scene;
	struct sketch_parts parts = find(made, 2, &scene);
	char text[1024] = "";
	FILE *out = fmemopen(text, sizeof(text), "w");

	assert_non_null(out);
	sketch_write_part_buttons(
		&scene.model, &parts, parts.node[0] == 1 ? 0 : 1, out);
	assert_int_equal(fclose(out), 0);
	if (!strstr(text, wanted)) {
		fail_msg("%s lacks %s", text, wanted);
	}
}

/* The freedom is of the node's frame, the words are those of the picture. */
static void test_buttons_say_how_a_rotated_part_turns(void **state)
{
	const float half = 0.70710678f;
	struct made needle = {
		"part", 0, {-0.05f, 0, 0}, {0.05f, 0.8f, 0}, .form = BOX};
	struct made wheel = {"part", 0, {-1, -1, -0.2f}, {1, 1, 0.2f},
		.rotation = {0, half, 0, half}};

	(void)state;
	expect_buttons(needle,
		"LEFT = move part bank 1 \"turn part left\"\n"
		"RIGHT = move part bank -1 \"turn part right\"\n"
		"UP = camera tilt");
	/* Seen from behind. */
	memcpy(needle.rotation, (float[4]){0, 1, 0, 0}, sizeof(needle.rotation));
	expect_buttons(needle, "LEFT = move part bank -1 \"turn part left\"\n");
	/* It lies on its back. */
	memcpy(needle.rotation, (float[4]){-half, 0, 0, half},
		sizeof(needle.rotation));
	expect_buttons(needle, "LEFT = move part bank 1 \"turn part left\"\n");
	/* A wheel whose axle is that of x. */
	expect_buttons(wheel,
		"UP = move part bank -1 \"turn part back\"\n"
		"DOWN = move part bank 1 \"turn part forward\"\n"
		"LEFT = camera turn");
}

static void test_buttons_swing_a_rod_and_a_door(void **state)
{
	struct made rod = {
		"part", 0, {-0.05f, 0, -0.05f}, {0.05f, 1, 0.05f}, .form = BOX};
	struct made door = {
		"part", 0, {0, -0.5f, -0.02f}, {1, 0.5f, 0.02f}, .form = BOX};

	(void)state;
	expect_buttons(rod,
		"UP = move part pitch -1 \"turn part back\"\n"
		"DOWN = move part pitch 1 \"turn part forward\"\n"
		"LEFT = move part bank 1 \"turn part left\"\n"
		"RIGHT = move part bank -1 \"turn part right\"\n\n");
	/* It hangs. */
	rod.low[1] = -1;
	rod.high[1] = 0;
	expect_buttons(rod, "LEFT = move part bank -1 \"turn part left\"\n");
	expect_buttons(door,
		"LEFT = move part heading -1 \"turn part left\"\n"
		"RIGHT = move part heading 1 \"turn part right\"\n"
		"UP = camera tilt");
}

/* Each goes where its button says, whichever way its node is turned. */
static void test_buttons_raise_a_level_rod(void **state)
{
	const float half = 0.70710678f;
	struct made rod = {
		"part", 0, {0, -0.05f, -0.05f}, {1, 0.05f, 0.05f}, .form = BOX};

	(void)state;
	expect_buttons(rod,
		"UP = move part bank 1 \"turn part up\"\n"
		"DOWN = move part bank -1 \"turn part down\"\n"
		"LEFT = move part heading -1 \"turn part forward\"\n"
		"RIGHT = move part heading 1 \"turn part back\"\n\n");
	/* Its end points to the camera. */
	memcpy(rod.rotation, (float[4]){0, -half, 0, half},
		sizeof(rod.rotation));
	expect_buttons(rod,
		"UP = move part bank 1 \"turn part up\"\n"
		"DOWN = move part bank -1 \"turn part down\"\n"
		"LEFT = move part heading -1 \"turn part left\"\n");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_flat_part_turns_in_its_plane),
		cmocka_unit_test(test_a_part_on_a_hinge_turns_about_its_edge),
		cmocka_unit_test(test_a_thick_part_turns_freely),
		cmocka_unit_test(test_a_round_part_turns_about_its_axle),
		cmocka_unit_test(test_a_thick_rod_swings_across_its_length),
		cmocka_unit_test(test_a_rod_over_a_disc_is_a_hand),
		cmocka_unit_test(test_a_ring_of_blades_turns_their_hub),
		cmocka_unit_test(test_needles_come_first),
		cmocka_unit_test(test_buttons_move_a_needle_beside_its_dial),
		cmocka_unit_test(test_buttons_say_how_a_rotated_part_turns),
		cmocka_unit_test(test_buttons_swing_a_rod_and_a_door),
		cmocka_unit_test(test_buttons_raise_a_level_rod),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
