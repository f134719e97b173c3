/* limber doctor tells of figures that lie because their file has +Z up. */
#include "app/model/examine/examine.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

/* Hips, head, knee and foot; each in the frame of the one above it. */
static void make(struct bones *bones, const float head[3], const float knee[3])
{
	static const char *const names[] = {
		"root", "mixamorig:Head", "Knee", "LeftFoot"};

	bones_begin(bones);
	bones_add(bones, -1, 0, 1, 0);
	bones_add(bones, 0, head[0], head[1], head[2]);
	bones_add(bones, 0, knee[0], knee[1], knee[2]);
	bones_add(bones, 2, knee[0], knee[1], knee[2]);
	for (int i = 0; i < 4; i++) {
		bones->node[i].name = names[i];
	}
}

/* Returns whether the figure lies; then, also whether the joints are right. */
static bool lies(const struct bones *bones)
{
	static const bool joint[4] = {true, true, true, true};
	int head, foot;

	if (!examine_find_lying(&bones->model, joint, &head, &foot)) {
		return false;
	}
	assert_int_equal(head, 1);
	assert_int_equal(foot, 3);
	return true;
}

static void expect_lies(const float head[3], const float knee[3], bool expected)
{
	struct bones bones;

	make(&bones, head, knee);
	assert_int_equal(lies(&bones), expected);
	bones_end(&bones);
}

static void test_a_figure_with_z_up_is_told(void **state)
{
	(void)state;
	expect_lies((const float[]){0, 0, 0.7f},
		(const float[]){0.1f, 0, -0.4f}, true);
	expect_lies((const float[]){0.7f, 0.1f, 0},
		(const float[]){-0.4f, 0, 0}, true);
}

/* So are those that stand, and animals, whose feet are below their spine. */
static void test_figures_that_stand_are_left_alone(void **state)
{
	(void)state;
	expect_lies((const float[]){0, 0.7f, 0},
		(const float[]){0.1f, -0.4f, 0}, false);
	expect_lies((const float[]){0, -0.7f, 0}, (const float[]){0, 0.4f, 0},
		false);
	expect_lies((const float[]){0, 0.1f, 0.7f},
		(const float[]){0.1f, -0.3f, 0}, false);
}

/* Many exporters put the turn into a node above the joints. */
static void test_a_turn_above_the_joints_counts(void **state)
{
	static const float half = 0.70710678f;
	struct bones bones;

	(void)state;
	make(&bones, (const float[]){0, 0, 0.7f}, (const float[]){0, 0, -0.4f});
	bones.node[0].rest.rotation[0] = -half;
	bones.node[0].rest.rotation[3] = half;
	assert_false(lies(&bones));
	bones_end(&bones);
}

static void test_nothing_is_said_without_names_or_one_body(void **state)
{
	struct bones bones;

	(void)state;
	make(&bones, (const float[]){0, 0, 0.7f}, (const float[]){0, 0, -0.4f});
	bones.node[3].name = "toe";
	assert_false(lies(&bones));
	bones.node[3].name = "foot";
	assert_true(lies(&bones));
	bones.node[2].parent = -1;
	assert_false(lies(&bones));
	bones_end(&bones);
}

/* The first joint with one of the words counts, in letters of any case. */
static void test_either_word_tells_head_and_foot(void **state)
{
	static const struct {
		const char *root, *head, *foot;
		bool lies;
	} cases[] = {
		{"root", "Skull", "ANKLE_L", true},
		{"root", "head", "ankle", true},
		{"root", "bip01 SKULL", "Bip01 Foot", true},
		{"root", "hea", "foot", false},
		{"root", "heaad", "foot", false},
		{"root", "head", "fot", false},
		{"root", "skul", "ankl", false},
		{"", "", "", false},
		{"Forehead", "head", "foot", false},
		{"Foothold", "head", "foot", false},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct bones bones;

		make(&bones, (const float[]){0, 0, 0.7f},
			(const float[]){0, 0, -0.4f});
		bones.node[0].name = cases[i].root;
		bones.node[1].name = cases[i].head;
		bones.node[3].name = cases[i].foot;
		assert_int_equal(lies(&bones), cases[i].lies);
		bones_end(&bones);
	}
}

/* A node of the name that is no joint is another thing, such as a mesh. */
static void test_joints_alone_are_head_and_foot(void **state)
{
	static const bool none[4] = {true, false, true, true};
	struct bones bones;
	int head, foot;

	(void)state;
	make(&bones, (const float[]){0, 0, 0.7f}, (const float[]){0, 0, -0.4f});
	assert_true(lies(&bones));
	assert_false(examine_find_lying(&bones.model, none, &head, &foot));
	bones_end(&bones);
}

/* Only what has head and foot on either side of its hips can stand. */
static void test_the_angle_at_the_hips_is_more_than_134_degrees(void **state)
{
	(void)state;
	/* The cosines are -0.71 and -0.69. */
	expect_lies((const float[]){0, 0, 1},
		(const float[]){0.7042f, 0, -0.71f}, true);
	expect_lies((const float[]){0, 0, 1},
		(const float[]){0.7238f, 0, -0.69f}, false);
	/* The slopes of the body have the sines 0.49 and 0.51. */
	expect_lies((const float[]){0, 0.49f, 0.8717f},
		(const float[]){0, -0.245f, -0.43585f}, true);
	expect_lies((const float[]){0, 0.51f, 0.8602f},
		(const float[]){0, -0.255f, -0.4301f}, false);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_figure_with_z_up_is_told),
		cmocka_unit_test(test_figures_that_stand_are_left_alone),
		cmocka_unit_test(test_a_turn_above_the_joints_counts),
		cmocka_unit_test(test_nothing_is_said_without_names_or_one_body),
		cmocka_unit_test(test_either_word_tells_head_and_foot),
		cmocka_unit_test(test_joints_alone_are_head_and_foot),
		cmocka_unit_test(
			test_the_angle_at_the_hips_is_more_than_134_degrees),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
