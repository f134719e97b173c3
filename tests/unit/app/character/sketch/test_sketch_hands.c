/* Which rods over a disc are hands, as those of a clock. */
#include "app/character/sketch/sketch_turn.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/character/sketch/made.h"

enum {
	DIAL,
	HAND
};

/* A dial of radius 2 about an axis, and a hand along another one over it. */
struct clock {
	int axis, along, across;
	struct made made[MOST];
};

static struct clock clock_of(int axis, int along)
{
	struct clock clock = {.axis = axis,
		.along = along,
		.across = 3 - axis - along,
		.made = {[DIAL] = {.name = "dial", .parent = -1},
			[HAND] = {.name = "hand"}}};

	for (int i = 0; i < 3; i++) {
		clock.made[DIAL].low[i] = i == axis ? -0.1f : -2;
		clock.made[DIAL].high[i] = i == axis ? 0.1f : 2;
		clock.made[HAND].low[i] = i == along ? -0.4f : -0.04f;
		clock.made[HAND].high[i] = i == along ? 1.6f : 0.04f;
	}
	return clock;
}

/* Asks for the form of the last of the nodes, which turns about this axis. */
static void expect_hand(const struct scene *scene, bool is_hand, int axis)
{
	struct sketch_turn turn[MOST];
	int hand = scene->model.node_count - 1;

	assert_int_equal(sketch_find_turns(&scene->model, turn), 0);
	assert_int_equal(turn[hand].form,
		is_hand ? SKETCH_TURN_NEEDLE : SKETCH_TURN_ROD);
	assert_int_equal(turn[hand].axis.axis, axis);
}

static void expect_clock(const struct clock *clock, bool is_hand)
{
	struct scene scene;

	make(clock->made, 2, &scene);
	expect_hand(&scene, is_hand, is_hand ? clock->axis : clock->along);
}

/* Calls a test for each axis of a dial and each direction of a hand over it. */
static void for_all_clocks(void (*test)(const struct clock *clock))
{
	for (int axis = 0; axis < 3; axis++) {
		for (int i = 1; i < 3; i++) {
			const struct clock clock =
				clock_of(axis, (axis + i) % 3);

			test(&clock);
		}
	}
}

static void test_ends(const struct clock *clock)
{
	static const struct {
		float low, high;
		bool is_hand;
	} rows[] = {{-0.4f, 1.6f, true}, {-0.4f, 2, true},
		{-0.4f, 2.05f, false}, {-2, 0.4f, true}, {-2.05f, 0.4f, false},
		{0, 2, true}, {-2, 0, true}};

	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct clock one = *clock;

		one.made[HAND].low[one.along] = rows[i].low;
		one.made[HAND].high[one.along] = rows[i].high;
		expect_clock(&one, rows[i].is_hand);
	}
}

static void test_a_hand_ends_over_its_dial(void **state)
{
	(void)state;
	for_all_clocks(test_ends);
}

/* At most a tenth of the radius from the middle, and as high as it likes. */
static void test_places(const struct clock *clock)
{
	static const struct {
		float above, along, across;
		bool is_hand;
	} rows[] = {{1, 0, 0, true}, {-3, 0.1f, 0.1f, true}, {0, 0.2f, 0, true},
		{0, 0, -0.2f, true}, {0, 0.22f, 0, false}, {0, 0, 0.22f, false},
		{0, -0.15f, 0.15f, false}};

	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct clock one = *clock;

		one.made[HAND].place[one.axis] = rows[i].above;
		one.made[HAND].place[one.along] = rows[i].along;
		one.made[HAND].place[one.across] = rows[i].across;
		expect_clock(&one, rows[i].is_hand);
	}
}

static void test_a_hand_begins_in_the_middle_of_its_dial(void **state)
{
	(void)state;
	for_all_clocks(test_places);
}

/* What hangs on a dial of half the size is made smaller with it. */
static void test_scales(const struct clock *clock)
{
	static const float scale[][3] = {
		{0.5f, 0.5f, 0.5f}, {4, -4, 4}, {0.5f, 0.45f, 0.55f}};
	struct clock one = *clock;

	for (size_t i = 0; i < ARRAY_COUNT(scale); i++) {
		memcpy(one.made[DIAL].scale, scale[i], sizeof(scale[i]));
		one.made[HAND].high[one.along] = 1.95f;
		one.made[HAND].place[one.across] = 0.19f;
		expect_clock(&one, true);
		one.made[HAND].place[one.across] = 0.22f;
		expect_clock(&one, false);
		one.made[HAND].place[one.across] = 0;
		one.made[HAND].high[one.along] = 2.05f;
		expect_clock(&one, false);
	}
}

static void test_a_dial_is_measured_without_its_scale(void **state)
{
	(void)state;
	for_all_clocks(test_scales);
}

/* The radius is half the mean of its sides. */
static void test_a_dial_may_be_wider_than_high(void **state)
{
	struct clock clock = clock_of(2, 0);

	(void)state;
	clock.made[DIAL].low[1] = -1.75f;
	clock.made[DIAL].high[1] = 1.75f;
	clock.made[HAND].high[0] = 1.875f;
	expect_clock(&clock, true);
	clock.made[HAND].high[0] = 1.9f;
	expect_clock(&clock, false);
}

/* Its face, of any scale, and its hand hang on a node, whatever its scale. */
static void test_a_dial_may_be_a_node_above_its_face(void **state)
{
	static const struct {
		int mesh, skin;
	} nodes[] = {{-1, -1}, {0, 0}, {0, 1}};
	struct clock clock = clock_of(2, 0);
	struct made *made = clock.made;
	struct scene scene;

	(void)state;
	made[2] = made[HAND];
	made[1] = made[DIAL];
	made[1].parent = 0;
	made[0] = (struct made){
		.name = "clock", .parent = -1, .scale = {3, 3, 3}};
	for (size_t i = 0; i < ARRAY_COUNT(nodes); i++) {
		made[2].high[0] = 1.6f;
		make(made, 3, &scene);
		scene.node[0].mesh = nodes[i].mesh;
		scene.node[0].skin = nodes[i].skin;
		expect_hand(&scene, true, 2);
		made[2].high[0] = 2.05f;
		make(made, 3, &scene);
		scene.node[0].mesh = nodes[i].mesh;
		scene.node[0].skin = nodes[i].skin;
		expect_hand(&scene, false, 0);
	}
}

/* A rod along the axle of a disc, such as a steering column, is none. */
static void test_a_rod_along_the_axle_is_no_hand(void **state)
{
	static const float half = 0.70710678f;
	struct clock clock = clock_of(2, 1), axle = clock_of(2, 1);

	(void)state;
	memcpy(axle.made[HAND].rotation, (float[4]){half, 0, 0, half},
		sizeof(axle.made[HAND].rotation));
	expect_clock(&axle, false);
	/* Both nodes are turned, and nothing changes between them. */
	memcpy(clock.made[DIAL].rotation, (float[4]){half, 0, 0, half},
		sizeof(clock.made[DIAL].rotation));
	expect_clock(&clock, true);
	memcpy(axle.made[DIAL].rotation, (float[4]){half, 0, 0, half},
		sizeof(axle.made[DIAL].rotation));
	expect_clock(&axle, false);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_hand_ends_over_its_dial),
		cmocka_unit_test(test_a_hand_begins_in_the_middle_of_its_dial),
		cmocka_unit_test(test_a_dial_is_measured_without_its_scale),
		cmocka_unit_test(test_a_dial_may_be_wider_than_high),
		cmocka_unit_test(test_a_dial_may_be_a_node_above_its_face),
		cmocka_unit_test(test_a_rod_along_the_axle_is_no_hand),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
