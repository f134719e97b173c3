/* Where the forms of parts end, by which a sketch tells how they turn. */
#include "app/character/sketch/sketch_turn.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"
#include "tests/unit/app/character/sketch/made.h"

static const float half = 0.70710678f;

static void find(struct scene *scene, const struct made *made, int count,
	struct sketch_turn turn[MOST])
{
	make(made, count, scene);
	assert_int_equal(sketch_find_turns(&scene->model, turn), 0);
}

static void expect_axis(
	const struct sketch_turn_axis *found, int axis, int seen, int sign)
{
	assert_int_equal(found->axis, axis);
	assert_int_equal(found->seen, seen);
	assert_int_equal(found->sign, sign);
}

/* A part, its form, and the axis about which it turns or along which it lies. */
struct row {
	struct made made;
	enum sketch_turn_form form;
	int axis;
};

static void expect_rows(const struct row *row, size_t count)
{
	for (size_t i = 0; i < count; i++) {
		struct sketch_turn turn[MOST];
		struct made made = row[i].made;
		struct scene scene;

		made.parent = -1;
		find(&scene, &made, 1, turn);
		if (turn[0].form != row[i].form) {
			fail_msg("row %zu has form %d", i, (int)turn[0].form);
		}
		expect_axis(&turn[0].axis, row[i].axis, row[i].axis, 1);
	}
}

static void test_long_parts_are_needles_or_rods(void **state)
{
	static const struct row rows[] = {
		/* As thick as 0.4 of the width, and thicker. */
		{{.low = {-0.2f, -0.5f, -5}, .high = {0.2f, 0.5f, 5}},
			SKETCH_TURN_NEEDLE, 0},
		{{.low = {-0.21f, -0.5f, -5}, .high = {0.21f, 0.5f, 5}},
			SKETCH_TURN_ROD, 2},
		/* As wide as a quarter of the length, and wider. */
		{{.low = {-2, -0.5f, -0.05f}, .high = {2, 0.5f, 0.05f}},
			SKETCH_TURN_NEEDLE, 2},
		{{.low = {-2, -0.51f, -0.05f}, .high = {2, 0.51f, 0.05f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-2, -0.5f, -0.5f}, .high = {2, 0.5f, 0.5f}},
			SKETCH_TURN_ROD, 0},
		{{.low = {-2, -0.51f, -0.51f}, .high = {2, 0.51f, 0.51f}},
			SKETCH_TURN_FREE, 0},
		/* The pivot is at an end, and beyond it. */
		{{.low = {0, -0.5f, -0.05f}, .high = {4, 0.5f, 0.05f}},
			SKETCH_TURN_NEEDLE, 2},
		{{.low = {0.01f, -0.5f, -0.05f}, .high = {4, 0.5f, 0.05f}},
			SKETCH_TURN_HINGE, 1},
		/* It is at 0.3 of the width, and nearer to a side. */
		{{.low = {-2, -0.3f, -0.05f}, .high = {2, 0.7f, 0.05f}},
			SKETCH_TURN_NEEDLE, 2},
		{{.low = {-2, -0.7f, -0.05f}, .high = {2, 0.3f, 0.05f}},
			SKETCH_TURN_NEEDLE, 2},
		{{.low = {-2, -0.28f, -0.05f}, .high = {2, 0.72f, 0.05f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-2, -0.72f, -0.05f}, .high = {2, 0.28f, 0.05f}},
			SKETCH_TURN_FREE, 0},
		/* A rod's is in the middle of both its short sides. */
		{{.low = {-2, -0.3f, -0.3f}, .high = {2, 0.6f, 0.6f}},
			SKETCH_TURN_ROD, 0},
		{{.low = {-2, -0.3f, -0.2f}, .high = {2, 0.6f, 0.6f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-2, -0.2f, -0.4f}, .high = {2, 0.7f, 0.4f}},
			SKETCH_TURN_FREE, 0},
	};

	(void)state;
	expect_rows(rows, ARRAY_COUNT(rows));
}

static void test_flat_parts_are_discs_or_hang_on_an_edge(void **state)
{
	static const struct row rows[] = {
		/* As wide as 0.8 of the length, and narrower. */
		{{.low = {-0.5f, -0.05f, -0.4f}, .high = {0.5f, 0.05f, 0.4f}},
			SKETCH_TURN_DISC, 1},
		{{.low = {-0.5f, -0.05f, -0.39f}, .high = {0.5f, 0.05f, 0.39f}},
			SKETCH_TURN_FREE, 0},
		/* The pivot is near a side, and at it. */
		{{.low = {-0.28f, -0.05f, -0.4f}, .high = {0.72f, 0.05f, 0.4f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-0.5f, -0.05f, -0.2f}, .high = {0.5f, 0.05f, 0.6f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-0.02f, -1, -0.92f}, .high = {0.02f, 1, 0.08f}},
			SKETCH_TURN_HINGE, 1},
		{{.low = {-0.02f, -1, -0.88f}, .high = {0.02f, 1, 0.12f}},
			SKETCH_TURN_FREE, 0},
		{{.low = {-0.02f, -1, -0.08f}, .high = {0.02f, 1, 0.92f}},
			SKETCH_TURN_HINGE, 1},
		{{.low = {-0.02f, -1, -0.12f}, .high = {0.02f, 1, 0.88f}},
			SKETCH_TURN_FREE, 0},
		/* It is beside the part. */
		{{.low = {-0.02f, -1, 0.08f}, .high = {0.02f, 1, 1.08f}},
			SKETCH_TURN_HINGE, 1},
		{{.low = {-0.02f, -1, 0.12f}, .high = {0.02f, 1, 1.12f}},
			SKETCH_TURN_FREE, 0},
		/* It is at a corner of which no edge is upright. */
		{{.low = {0, -0.01f, 0}, .high = {1, 0.01f, 2}},
			SKETCH_TURN_FREE, 0},
		/* Neither a line nor a point is flat. */
		{{.low = {0, 0, 0}, .high = {1, 0, 0}}, SKETCH_TURN_FREE, 0},
		{{.low = {0, 0, 0}, .high = {0, 0, 3}}, SKETCH_TURN_FREE, 0},
		{{.low = {0, 0, 0}, .high = {0, 0, 0}}, SKETCH_TURN_FREE, 0},
	};

	(void)state;
	expect_rows(rows, ARRAY_COUNT(rows));
}

static void test_round_parts_are_wheels_up_to_some_thickness(void **state)
{
	static const struct row rows[] = {
		{{.low = {-0.75f, -0.5f, -0.5f},
			 .high = {0.75f, 0.5f, 0.5f},
			 .form = ROUND_X},
			SKETCH_TURN_DISC, 0},
		{{.low = {-0.8f, -0.5f, -0.5f},
			 .high = {0.8f, 0.5f, 0.5f},
			 .form = ROUND_X},
			SKETCH_TURN_FREE, 0},
		/* A vertex is as far from the axle as it may be, and farther. */
		{{.low = {-0.4f, -0.55f, -0.45f},
			 .high = {0.4f, 0.55f, 0.45f},
			 .form = ROUND_X},
			SKETCH_TURN_DISC, 0},
		{{.low = {-0.4f, -0.56f, -0.44f},
			 .high = {0.4f, 0.56f, 0.44f},
			 .form = ROUND_X},
			SKETCH_TURN_FREE, 0},
		/* The pivot is a little off, and more. */
		{{.low = {-0.4f, -0.45f, -0.55f},
			 .high = {0.4f, 0.55f, 0.55f},
			 .form = ROUND_X},
			SKETCH_TURN_DISC, 0},
		{{.low = {-0.4f, -0.44f, -0.55f},
			 .high = {0.4f, 0.56f, 0.55f},
			 .form = ROUND_X},
			SKETCH_TURN_FREE, 0},
		{{.low = {-0.4f, -0.55f, -0.55f},
			 .high = {0.4f, 0.55f, 0.45f},
			 .form = ROUND_X},
			SKETCH_TURN_DISC, 0},
		{{.low = {-0.4f, -0.55f, -0.56f},
			 .high = {0.4f, 0.55f, 0.44f},
			 .form = ROUND_X},
			SKETCH_TURN_FREE, 0},
		/* It is round about x and y alike. */
		{{.low = {-0.5f, -0.5f, -0.5f},
			 .high = {0.5f, 0.5f, 0.5f},
			 .form = SQUARES},
			SKETCH_TURN_FREE, 0},
	};

	(void)state;
	expect_rows(rows, ARRAY_COUNT(rows));
}

/* By the quarter of a turn about z, x becomes y, and by half a turn -x. */
static void test_free_parts_say_where_their_x_axis_is(void **state)
{
	static const float column[4][4] = {{1}};
	static const struct {
		float rotation[4];
		int seen, sign;
	} rows[] = {{{0, 0, half, half}, 1, 1}, {{0, 0, -half, half}, 1, -1},
		{{0, half, 0, half}, 2, -1}, {{0, -half, 0, half}, 2, 1},
		{{0, 0, 1, 0}, 0, -1}, {{1, 0, 0, 0}, 0, 1}};
	struct made made[] = {
		{.parent = -1, .low = {-1, -1, -1}, .high = {1, 1, 1}},
		{.parent = 0, .low = {-0.1f, -1, 0}, .high = {0.1f, 1, 0}},
		{.parent = 0, .low = {-0.1f, -1, 0}, .high = {0.1f, 1, 0}}};
	struct sketch_turn turn[MOST];
	struct scene scene;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		memcpy(made[0].rotation, rows[i].rotation,
			sizeof(made[0].rotation));
		make(made, 3, &scene);
		/* A node whose place is a matrix, and one that shows nothing. */
		scene.node[1].matrix = column;
		scene.node[2].mesh = -1;
		assert_int_equal(sketch_find_turns(&scene.model, turn), 0);
		for (int k = 0; k < 3; k++) {
			assert_int_equal(turn[k].form, SKETCH_TURN_FREE);
			expect_axis(
				&turn[k].axis, 0, rows[i].seen, rows[i].sign);
		}
	}
}

static void test_a_rod_points_to_its_longer_end(void **state)
{
	static const struct {
		float low, high;
		int sign;
	} rows[] = {{-1, 1, 1}, {-0.9f, 1, 1}, {-1, 0.9f, -1}, {0, 1, 1},
		{-1, 0, -1}};
	struct sketch_turn turn[MOST];
	struct scene scene;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		for (int axis = 0; axis < 3; axis++) {
			struct made rod = {.parent = -1,
				.low = {-0.1f, -0.1f, -0.1f},
				.high = {0.1f, 0.1f, 0.1f}};

			rod.low[axis] = rows[i].low;
			rod.high[axis] = rows[i].high;
			find(&scene, &rod, 1, turn);
			assert_int_equal(turn[0].form, SKETCH_TURN_ROD);
			expect_axis(&turn[0].axis, axis, axis, rows[i].sign);
		}
	}
}

/* Three blades around any axis, and what does not turn about it. */
static void test_blades_turn_their_hub_about_any_axis(void **state)
{
	const float c = 0.5f, s = 0.8660254f;
	struct sketch_turn turn[MOST];
	struct scene scene;

	(void)state;
	for (int axis = 0; axis < 3; axis++) {
		struct made rotor[4] = {{.parent = -1,
			.low = {-1, -1, -1},
			.high = {1, 1, 1},
			.form = BALL}};

		for (int i = 1; i < 4; i++) {
			rotor[i] = (struct made){.parent = 0,
				.low = {-1, -1, -1},
				.high = {1, 1, 1},
				.rotation = {[3] = i == 1 ? 1 : c}};
			rotor[i].low[(axis + 1) % 3] = 1;
			rotor[i].high[(axis + 1) % 3] = 9;
			rotor[i].rotation[axis] = (float)(i - 1) * s;
		}
		rotor[3].rotation[axis] = -s;
		find(&scene, rotor, 4, turn);
		assert_int_equal(turn[0].form, SKETCH_TURN_DISC);
		expect_axis(&turn[0].axis, axis, axis, 1);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_long_parts_are_needles_or_rods),
		cmocka_unit_test(test_flat_parts_are_discs_or_hang_on_an_edge),
		cmocka_unit_test(
			test_round_parts_are_wheels_up_to_some_thickness),
		cmocka_unit_test(test_free_parts_say_where_their_x_axis_is),
		cmocka_unit_test(test_a_rod_points_to_its_longer_end),
		cmocka_unit_test(test_blades_turn_their_hub_about_any_axis),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
