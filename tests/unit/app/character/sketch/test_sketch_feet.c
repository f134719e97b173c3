/* Which of the pairs of legs of a model have feet in a sketch. */
#include "platform/base/compiler.h"
#include "tests/unit/app/character/sketch/legs.h"

/* Hips with pairs of legs, of which the second has this length. */
static struct bones *two_pairs(float length)
{
	struct bones *bones = two_legs(10);

	add_leg(bones, HIPS, 6, 0, length);
	add_leg(bones, HIPS, -6, 0, length);
	return bones;
}

static void test_of_two_pairs_on_the_same_hips_the_longer_stays(void **state)
{
	(void)state;
	expect_feet(two_pairs(12), "1: 1 9 12, ");
	expect_feet(two_pairs(8), "1: 1 2 5, ");
	expect_feet(two_pairs(10), "1: 1 2 5, ");
}

/* A row of hips 0..count-1, each below the one before, with legs in this order. */
static struct bones *many_hips(const int *order, int count)
{
	struct bones *bones = no_bones();

	for (int i = 0; i < count; i++) {
		add(bones, i - 1, 0, 12, 5 * (float)i);
	}
	for (int i = 0; i < count; i++) {
		float z = 5 * (float)order[i];

		add_leg(bones, order[i], 2, z, 10);
		add_leg(bones, order[i], -2, z, 10);
	}
	return bones;
}

static void test_hips_come_before_those_that_they_carry(void **state)
{
	static const struct {
		int order[3];
		const char *wanted;
	} rows[] = {{{0, 1, 2}, "1: 0 3 6, 2: 1 9 12, 3: 2 15 18, "},
		{{0, 2, 1}, "1: 0 3 6, 2: 1 15 18, 3: 2 9 12, "},
		{{1, 0, 2}, "1: 0 9 12, 2: 1 3 6, 3: 2 15 18, "},
		{{1, 2, 0}, "1: 0 15 18, 2: 1 3 6, 3: 2 9 12, "},
		{{2, 0, 1}, "1: 0 9 12, 2: 1 15 18, 3: 2 3 6, "},
		{{2, 1, 0}, "1: 0 15 18, 2: 1 9 12, 3: 2 3 6, "}};
	struct bones *bones;

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		expect_feet(many_hips(rows[i].order, 3), rows[i].wanted);
	}
	/* Those side by side stay in their order. */
	bones = many_hips(rows[4].order, 3);
	bones->node[2].parent = 0;
	expect_feet(bones, "1: 0 9 12, 2: 2 3 6, 3: 1 15 18, ");
}

static void test_four_pairs_are_enough(void **state)
{
	static const int order[2][5] = {{0, 1, 2, 3, 4}, {4, 3, 2, 1, 0}};

	(void)state;
	expect_feet(many_hips(order[0], 5),
		"1: 0 5 8, 2: 1 11 14, 3: 2 17 20, 4: 3 23 26, ");
	expect_feet(many_hips(order[1], 5),
		"1: 1 23 26, 2: 2 17 20, 3: 3 11 14, 4: 4 5 8, ");
}

/* Hips with two legs at these places, and as many opposite of them. */
static struct bones *cross(const float at[2][2], float length)
{
	struct bones *bones = no_bones();

	add(bones, -1, 0, 12, 0);
	for (int i = 0; i < 2; i++) {
		add_leg(bones, 0, at[i][0], at[i][1], length);
		add_leg(bones, 0, -at[i][0], -at[i][1], length);
	}
	return bones;
}

/* A model that looks along x has its legs along z. */
static void test_the_left_is_nearer_to_the_right_of_the_picture(void **state)
{
	static const struct {
		float at[2][2];
		const char *wanted;
	} rows[] = {/* The nearest legs, in any order, or the first ones. */
		{{{3, 3}, {2, -2}}, "1: 0 7 10, "},
		{{{2, -2}, {3, 3}}, "1: 0 1 4, "},
		{{{3, -1}, {1, 3}}, "1: 0 1 7, "},
		{{{-3, 1}, {1, 3}}, "1: 0 4 7, "},
		/* Before them those along x. */
		{{{0, 2}, {3, 0}}, "1: 0 7 10, "},
		{{{0, 2}, {-3, 0}}, "1: 0 10 7, "},
		/* Along z, either may be the left one. */
		{{{0, 2}, {0, 2}}, "1: 0 1 4, "},
		{{{0, -2}, {0, -2}}, "1: 0 1 4, "}, {{{0, 0}, {0, 0}}, ""}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		expect_feet(cross(rows[i].at, 10), rows[i].wanted);
	}
}

/* As their feet stand ever so near to each other. */
static void test_legs_of_small_models_are_found_as_well(void **state)
{
	static const float rows[2][2][2] = {
		{{0.3f, 0}, {0.15f, 0.15f}}, {{0.25f, 0.25f}, {0.15f, -0.1f}}};

	(void)state;
	expect_feet(cross(rows[0], 0.5f), "1: 0 1 4, ");
	expect_feet(cross(rows[1], 0.5f), "1: 0 7 10, ");
}

/* Of two directions, the one with more pairs. */
static void test_most_pairs_tell_the_side(void **state)
{
	static const int order[] = {0, 1};
	struct bones *bones = many_hips(order, 2);

	(void)state;
	/* Both pairs stand aslant, and the second hips have one along x. */
	for (int i = 0; i < 2; i++) {
		for (int k = 0; k < 3; k++) {
			bones->world[2 + 6 * i + k][3][2] += 2;
			bones->world[5 + 6 * i + k][3][2] -= 2;
		}
	}
	add_leg(bones, 1, 1, 5, 10);
	add_leg(bones, 1, -1, 5, 10);
	expect_feet(bones, "1: 0 2 5, 2: 1 8 11, ");
}

/* As seen from the side that is that of the other pair, which is wider. */
static void test_legs_of_a_pair_are_as_far_ahead(void **state)
{
	static const int order[] = {0, 1};

	(void)state;
	for (int k = 0; k < 4; k++) {
		struct bones *bones = many_hips(order, 2);
		float by = k / 2 ? 0.95f : 1.05f;

		for (int i = 0; i < 3; i++) {
			bones->world[2 + i][3][0] += 4;
			bones->world[5 + i][3][0] -= 4;
			bones->world[11 + i][3][2] += k % 2 ? by : -by;
			/* The other one may be off to the other side. */
			bones->world[5 + i][3][2] -= k < 2 ? 0
				: k % 2                    ? by
							   : -by;
		}
		expect_feet(
			bones, k / 2 ? "1: 0 2 5, 2: 1 8 11, " : "1: 0 2 5, ");
	}
}

/* Legs in trees of their own, and then the two that are a pair. */
static void test_64_legs_are_looked_at(void **state)
{
	(void)state;
	for (int count = 62; count <= 63; count++) {
		struct bones *bones = no_bones();
		int hips;

		for (int i = 0; i < count; i++) {
			add_leg(bones, add(bones, -1, 0, 12, 0), 0, 0, 10);
		}
		hips = add(bones, -1, 0, 12, 0);
		add_leg(bones, hips, 2, 0, 10);
		add_leg(bones, hips, -2, 0, 10);
		expect_feet(bones, count == 62 ? "1: 248 249 252, " : "");
	}
}

/* Of 17 legs of one length each has 16 others; legs far ahead are no pairs. */
static void test_256_pairs_are_looked_at(void **state)
{
	static const struct {
		int left, right;
		const char *wanted;
	} rows[] = {
		{15, 16, "1: 0 46 49, "}, {16, 0, ""}, {0, 16, "1: 0 1 49, "}};

	(void)state;
	for (size_t row = 0; row < ARRAY_COUNT(rows); row++) {
		struct bones *bones = no_bones();

		add(bones, -1, 0, 12, 0);
		for (int i = 0; i < 17; i++) {
			bool left = i == rows[row].left;

			if (left || i == rows[row].right) {
				add_leg(bones, 0, left ? 2 : -2, 0, 10);
			} else {
				add_leg(bones, 0, 0, 100 + (float)i, 10);
			}
		}
		expect_feet(bones, rows[row].wanted);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_of_two_pairs_on_the_same_hips_the_longer_stays),
		cmocka_unit_test(test_hips_come_before_those_that_they_carry),
		cmocka_unit_test(test_four_pairs_are_enough),
		cmocka_unit_test(
			test_the_left_is_nearer_to_the_right_of_the_picture),
		cmocka_unit_test(test_legs_of_small_models_are_found_as_well),
		cmocka_unit_test(test_most_pairs_tell_the_side),
		cmocka_unit_test(test_legs_of_a_pair_are_as_far_ahead),
		cmocka_unit_test(test_64_legs_are_looked_at),
		cmocka_unit_test(test_256_pairs_are_looked_at),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
