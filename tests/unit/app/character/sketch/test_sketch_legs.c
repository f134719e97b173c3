/* Which bones are pairs of legs, by where they are at rest. */
#include "platform/base/compiler.h"
#include "tests/unit/app/character/sketch/legs.h"

/* The only hips and legs of two_legs(). */
static void expect_pair(struct bones *bones, bool is_pair)
{
	expect_feet(bones, is_pair ? "1: 1 2 5, " : "");
}

/* Moves bones from..to. */
static void move(struct bones *bones, int from, int to, int axis, float by)
{
	for (int i = from; i <= to; i++) {
		bones->world[i][3][axis] += by;
	}
}

/*
 * But for less than a tenth of its length, its knee for less than twice and its
 * ankle for less than three times that. The numbers are those of a leg of 10.
 */
static void test_a_leg_mirrors_the_other_one(void **state)
{
	static const struct {
		int from, to, axis;
		float most;
	} rows[] = {{RIGHT, RIGHT + 2, 0, 1}, {RIGHT, RIGHT + 2, 1, 1},
		{RIGHT + 1, RIGHT + 1, 0, 2}, {RIGHT + 1, RIGHT + 1, 1, 2},
		{RIGHT + 1, RIGHT + 1, 2, 2}, {RIGHT + 2, RIGHT + 2, 0, 3},
		{RIGHT + 2, RIGHT + 2, 2, 3}, {HIPS, HIPS, 0, 0.5f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		for (int k = 0; k < 8; k++) {
			float length = k / 4 ? 10 : 5;
			struct bones *bones = two_legs(length);
			float by = rows[i].most - (k & 2 ? 0.05f : 0);

			by *= k & 1 ? -0.1f * length : 0.1f * length;
			move(bones, rows[i].from, rows[i].to, rows[i].axis, by);
			expect_pair(bones, k & 2);
		}
	}
}

/* The model turned by 3:4: its knee may be off by less than 2 in any direction. */
static void test_legs_mirror_each_other_in_the_models_own_direction(void **state)
{
	(void)state;
	for (int k = 0; k < 4; k++) {
		struct bones *bones = two_legs(10);
		float by = k / 2 ? 1.95f : 2.05f;

		for (int i = LEFT; i < TOE; i++) {
			bones->world[i][3][0] = i < RIGHT ? 3 : -3;
			bones->world[i][3][2] = i < RIGHT ? 4 : -4;
		}
		bones->world[RIGHT + 1][3][0] += by * (k % 2 ? 0.6f : 0.8f);
		bones->world[RIGHT + 1][3][2] += by * (k % 2 ? 0.8f : -0.6f);
		expect_pair(bones, k / 2);
	}
}

static void test_a_model_stands_at_any_height(void **state)
{
	(void)state;
	for (int by = -50; by <= 50; by += 50) {
		struct bones *bones = two_legs(10);

		move(bones, ROOT, TOE, 1, (float)by);
		expect_pair(bones, true);
	}
}

/* By less than a tenth of the left one. */
static void test_both_legs_have_about_one_length(void **state)
{
	static const struct {
		int tip;
		float by;
		bool is_pair;
	} rows[] = {{RIGHT + 2, 0.95f, true}, {RIGHT + 2, 1, false},
		{RIGHT + 2, -0.95f, true}, {RIGHT + 2, -1, false},
		{LEFT + 2, 0.9f, true}, {LEFT + 2, 0.95f, false},
		{LEFT + 2, -1.05f, true}, {LEFT + 2, -1.2f, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bones *bones = two_legs(10);

		move(bones, rows[i].tip, rows[i].tip, 1, rows[i].by);
		expect_pair(bones, rows[i].is_pair);
	}
}

static void test_each_bone_of_a_leg_is_more_than_a_quarter_of_it(void **state)
{
	static const struct {
		float knee;
		bool is_leg;
	} rows[] = {{7.5f, false}, {7.4f, true}, {2.6f, true}, {2.5f, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bones *bones = two_legs(10);

		bones->world[LEFT + 1][3][1] = rows[i].knee;
		bones->world[RIGHT + 1][3][1] = rows[i].knee;
		expect_pair(bones, rows[i].is_leg);
	}
}

/* From the hip it goes down by more than half of its length. */
static void test_a_leg_stands(void **state)
{
	(void)state;
	for (int k = 0; k < 2; k++) {
		struct bones *bones = two_legs(8);

		for (int i = LEFT; i <= RIGHT; i += RIGHT - LEFT) {
			float x = i == LEFT ? 1 : -1;
			/* The thigh has the length 5, and the shin 3. */
			const float at[3][3] = {
				{2 * x, 4, -4}, {2 * x, 1, 0}, {4 * x, 0, 2}};

			for (int n = 0; n < 3; n++) {
				memcpy(bones->world[i + n][3], at[n],
					sizeof(at[n]));
			}
			bones->world[i][3][1] += k ? 0.1f : 0;
		}
		expect_pair(bones, k);
	}
}

/* It is less than 0.3 of the leg above the lowest joint, such as that of a toe. */
static void test_an_ankle_is_near_the_ground(void **state)
{
	static const struct {
		int node;
		float y;
		bool is_joint, is_leg;
	} rows[] = {{TOE, -2.3f, true, true}, {TOE, -2.4f, true, false},
		{TOE, -2.4f, false, true}, {TOE, 9, true, true},
		{ROOT, -2.3f, true, true}, {ROOT, -2.4f, true, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bones *bones = two_legs(8);

		bones->world[rows[i].node][3][1] = rows[i].y;
		bones->is_joint[rows[i].node] = rows[i].is_joint;
		expect_pair(bones, rows[i].is_leg);
	}
}

static void test_a_leg_goes_down_from_joint_to_joint(void **state)
{
	static const float wrong[][3] = {{5, 5, 0}, {4, 5, 0}, {6, 0, 0}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		struct bones *bones = two_legs(10);

		for (int k = 0; k < 3; k++) {
			bones->world[LEFT + k][3][1] = wrong[i][k];
			bones->world[RIGHT + k][3][1] = wrong[i][k];
			/* The thigh and the shin have some length. */
			bones->world[LEFT + k][3][2] = 3 * (float)(k % 2);
			bones->world[RIGHT + k][3][2] = 3 * (float)(k % 2);
		}
		expect_pair(bones, false);
	}
}

/* Three names have to fit into a line. */
static void test_hips_and_legs_are_joints_with_names(void **state)
{
	static const char name[] =
		"0123456789012345678901234567890123456789012345678901234567890";

	(void)state;
	for (int i = ROOT; i <= TOE; i++) {
		bool needed = i != ROOT && i != TOE;
		struct bones *bones = two_legs(10);
		char *text = NULL;
		size_t size = 0;
		FILE *out = open_memstream(&text, &size);

		bones->is_joint[i] = false;
		expect_pair(bones, !needed);
		bones = two_legs(10);
		bones->is_named[i] = false;
		expect_pair(bones, !needed);
		bones = two_legs(10);
		bones->node[i].name = name;
		expect_feet(bones, needed ? "" : "1: 1 2 5, ");
		bones = two_legs(10);
		bones->node[i].name = name + 1;
		assert_non_null(out);
		sketch_write_feet(&bones->model, bones->is_joint,
			bones->is_named, (const mat4 *)bones->world, out);
		assert_int_equal(fclose(out), 0);
		assert_int_equal(strstr(text, name + 1) != NULL, needed);
		assert_contains(text, "[feet feet1]");
		free(text);
		free(bones);
	}
}

static void test_hips_carry_both_legs(void **state)
{
	struct bones *bones = two_legs(10);

	(void)state;
	bones->node[RIGHT].parent = LEFT;
	expect_feet(bones, "");
	bones = two_legs(10);
	bones->node[RIGHT].parent = ROOT;
	expect_feet(bones, "1: 0 2 5, ");
	/* Two trees, and the left leg below the right one. */
	bones = two_legs(10);
	add(bones, -1, 0, 12, 0);
	bones->node[RIGHT].parent = TOE + 1;
	expect_feet(bones, "");
	bones = no_bones();
	add(bones, -1, 0, 20, 0);
	add(bones, ROOT, 0, 12, 0);
	add_leg(bones, HIPS, -2, 0, 10);
	add_leg(bones, LEFT, 2, 0, 10);
	expect_feet(bones, "");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_leg_mirrors_the_other_one),
		cmocka_unit_test(
			test_legs_mirror_each_other_in_the_models_own_direction),
		cmocka_unit_test(test_a_model_stands_at_any_height),
		cmocka_unit_test(test_both_legs_have_about_one_length),
		cmocka_unit_test(
			test_each_bone_of_a_leg_is_more_than_a_quarter_of_it),
		cmocka_unit_test(test_a_leg_stands),
		cmocka_unit_test(test_an_ankle_is_near_the_ground),
		cmocka_unit_test(test_a_leg_goes_down_from_joint_to_joint),
		cmocka_unit_test(test_hips_and_legs_are_joints_with_names),
		cmocka_unit_test(test_hips_carry_both_legs),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
