/* Chains of bones and legs that a sketched character file suggests. */
#include "app/character/sketch/character_sketch.h"
#include "tests/support/model/acting.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Chains of joints end at a last one and begin where the skeleton branches. */
static void expect_chains(int joints, const char *expected)
{
	enum {
		MOST = 24
	};
	struct model_node node[MOST];
	int joint[MOST];
	char name[MOST][16];
	struct model_skin skin = {.joint = joint, .joint_count = joints};
	struct model model = {.path = "chains",
		.node_count = joints,
		.node = node,
		.skin_count = 1,
		.skin = &skin};
	char *text;

	for (int i = 0; i < joints; i++) {
		/* The second joint of a root with two branches, then one line. */
		node[i] = (struct model_node){.name = name[i],
			.parent = i == 2 ? 0 : i - 1,
			.in_scene = true,
			.rest = {{0, i > 1, 0}, {0, 0, 0, 1}, {1, 1, 1}},
			.mesh = -1,
			.skin = -1,
			.camera = -1};
		snprintf(name[i], sizeof(name[i]), "j%d", i);
		joint[i] = i;
	}
	text = acting_sketch(&model, NULL);
	assert_contains(text, expected);
	free(text);
}

static void test_a_sketch_suggests_each_chain_of_two_or_more(void **state)
{
	(void)state;
	/*
	 * j0 has j1 alone and j2, j3 behind each other: a target 0.18 of the
	 * height aside, at 0.6 of it and 0.3 before.
	 */
	expect_chains(4,
		";[target ball]\n;place = 0.36 1.20 0.60\n;radius = 0.06\n\n"
		";[spring swing1]\n;bones = j3 2\n\n"
		";[reach reach1]\n;chain = j3 2\n;target = ball\n;on = no\n");
	expect_chains(
		18, ";bones = j17 16\n\n;[reach reach1]\n;chain = j17 16\n");
	expect_chains(
		17, ";bones = j16 15\n\n;[reach reach1]\n;chain = j16 15\n");
	/* One joint beyond those that a chain may have. */
	expect_chains(
		20, ";bones = j19 16\n\n;[reach reach1]\n;chain = j19 16\n");
}

/* Hips with hind legs, which carry a spine with front legs. */
/* bend is how far knees are ahead, besides; the model is turned by an angle. */
static char *sketch_turned_legs(
	float right_x, float knee_y, float ankle_y, float bend, float angle_rad)
{
	static const struct {
		const char *name;
		int parent;
		float x, y, z;
	} bone[] = {{"all", -1, 0, 0, 0}, {"hips", 0, 0, 0.9f, -0.4f},
		{"spine", 1, 0, 0.05f, 0.4f}, {"thigh l", 1, 0.2f, -0.1f, 0},
		{"shin l", 3, 0, -0.4f, 0.1f}, {"foot l", 4, 0, 0, -0.1f},
		{"thigh r", 1, 0, -0.1f, 0}, {"shin r", 6, 0, -0.4f, 0.1f},
		{"foot r", 7, 0, 0, -0.1f}, {"arm l", 2, 0.2f, -0.1f, 0.4f},
		{"hand l", 9, 0, -0.4f, 0}, {"paw l", 10, 0, 0, 0},
		{"arm r", 2, 0, -0.1f, 0.4f}, {"hand r", 12, 0, -0.4f, 0},
		{"paw r", 13, 0, 0, 0}};
	struct model_node node[ARRAY_COUNT(bone)];
	int joint[ARRAY_COUNT(bone)];
	struct model_skin skin = {
		.joint = joint, .joint_count = ARRAY_COUNT(bone)};
	struct model model = {.path = "four",
		.node_count = ARRAY_COUNT(bone),
		.node = node,
		.skin_count = 1,
		.skin = &skin};

	for (size_t i = 0; i < ARRAY_COUNT(bone); i++) {
		node[i] = (struct model_node){.name = bone[i].name,
			.parent = bone[i].parent,
			.in_scene = true,
			.rest = {{bone[i].x, bone[i].y, bone[i].z},
				{0, 0, 0, 1}, {1, 1, 1}},
			.mesh = -1,
			.skin = -1,
			.camera = -1};
		joint[i] = (int)i;
	}
	node[6].rest.translation[0] = node[12].rest.translation[0] = right_x;
	for (int i = 5; i <= 14; i += 3) {
		node[i - 1].rest.translation[1] = knee_y;
		node[i - 1].rest.translation[2] += bend;
		node[i].rest.translation[2] -= bend;
		node[i].rest.translation[1] = ankle_y;
	}
	node[0].rest.rotation[1] = sinf(0.5f * angle_rad);
	node[0].rest.rotation[3] = cosf(0.5f * angle_rad);
	return acting_sketch(&model, NULL);
}

static char *sketch_legs(float right_x, float knee_y, float ankle_y, float bend)
{
	return sketch_turned_legs(right_x, knee_y, ankle_y, bend, 0);
}

static char *sketch_four_legs(float right_x, float ankle_y)
{
	return sketch_legs(right_x, -0.4f, ankle_y, 0);
}

static void test_a_sketch_suggests_feet_for_pairs_of_legs(void **state)
{
	struct acting acting;
	char *text;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	text = acting_sketch(acting.model, NULL);
	assert_contains(text,
		";[feet feet1]\n;hips = hips\n;left = thigh.L shin.L foot.L\n"
		";right = thigh.R shin.R foot.R\n\n");
	assert_null(strstr(text, "feet2"));
	free(text);
	acting_end(&acting);
	/* What carries other legs has to come first. */
	text = sketch_four_legs(-0.2f, -0.35f);
	assert_contains(text,
		";[feet feet1]\n;hips = hips\n"
		";left = \"thigh l\" \"shin l\" \"foot l\"\n"
		";right = \"thigh r\" \"shin r\" \"foot r\"\n\n"
		";[feet feet2]\n;hips = spine\n"
		";left = \"arm l\" \"hand l\" \"paw l\"\n"
		";right = \"arm r\" \"hand r\" \"paw r\"\n\n");
	free(text);
}

static void test_a_sketch_suggests_feet_whatever_way_a_model_faces(void **state)
{
	(void)state;
	for (int degrees = -175; degrees <= 175; degrees += 10) {
		bool behind = degrees < -90 || degrees > 90;
		char *text = sketch_turned_legs(-0.2f, -0.4f, -0.35f, 0,
			(float)degrees * GLM_PIf / 180);

		/* It takes a model for one that faces the camera. */
		assert_contains(text,
			behind ? ";[feet feet1]\n;hips = hips\n"
				 ";left = \"thigh r\" \"shin r\" \"foot r\"\n"
			       : ";[feet feet1]\n;hips = hips\n"
				 ";left = \"thigh l\" \"shin l\" \"foot l\"\n");
		assert_contains(text, ";[feet feet2]\n;hips = spine\n");
		assert_null(strstr(text, "feet3"));
		free(text);
	}
}

static void test_a_sketch_suggests_no_feet_without_legs(void **state)
{
	static const struct {
		float right_x, ankle_y;
	} wrong[] = {{0.1f, -0.35f}, {-0.6f, -0.35f}, {-0.2f, 0.35f},
		{-0.2f, -0.02f}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(wrong); i++) {
		char *text =
			sketch_four_legs(wrong[i].right_x, wrong[i].ankle_y);

		assert_null(strstr(text, "[feet"));
		free(text);
	}
}

/* Of two bones with a name, only the first can be suggested. */
/* Below the hip, and above the ankle. */
static void test_a_leg_has_its_knee_between_hip_and_ankle(void **state)
{
	static const struct {
		float knee_y, ankle_y;
		bool is_leg;
	} cases[] = {{-0.05f, -0.6f, true}, {0, -0.6f, false},
		{0.02f, -0.7f, false}, {-0.6f, -0.15f, true},
		{-0.55f, 0, false}, {-0.8f, 0.05f, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		char *text = sketch_legs(
			-0.2f, cases[i].knee_y, cases[i].ankle_y, 0.3f);

		assert_int_equal(strstr(text, "[feet") != NULL, cases[i].is_leg);
		free(text);
	}
}

static void test_a_sketch_suggests_no_bone_that_a_name_does_not_find(
	void **state)
{
	struct acting acting;
	char *text;
	int foot, other;

	(void)state;
	acting_begin(&acting, "assets/walker.glb");
	foot = model_find_node(acting.model, "foot.R");
	other = model_find_node(acting.model, "foot.L");
	text = acting_sketch(acting.model, NULL);
	assert_non_null(strstr(text, ";right = thigh.R shin.R foot.R"));
	free(text);
	acting.model->node[foot > other ? foot : other].name =
		acting.model->node[foot > other ? other : foot].name;
	text = acting_sketch(acting.model, NULL);
	assert_null(strstr(text, ";[feet"));
	free(text);
	acting_end(&acting);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_sketch_suggests_each_chain_of_two_or_more),
		cmocka_unit_test(
			test_a_sketch_suggests_no_bone_that_a_name_does_not_find),
		cmocka_unit_test(test_a_sketch_suggests_feet_for_pairs_of_legs),
		cmocka_unit_test(
			test_a_sketch_suggests_feet_whatever_way_a_model_faces),
		cmocka_unit_test(test_a_sketch_suggests_no_feet_without_legs),
		cmocka_unit_test(test_a_leg_has_its_knee_between_hip_and_ankle),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
