#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/bone.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <string.h>

enum {
	BODY,
	ARM,
	HAND,
	OTHER
};

/* Rotations of unlike numbers whose length is 1. */
static const float TURN[4] = {0.1f, 0.5f, -0.7f, 0.5f};
static const float BENT[4] = {0.7f, -0.1f, 0.5f, 0.5f};

/* The body may be scaled; the arm is turned and the hand bent. */
static void set_up(struct bones *bones, float x, float y, float z)
{
	bones_begin(bones);
	bones_add(bones, -1, 1, 2, 3);
	bones_add(bones, BODY, 0.5f, 0, 0);
	bones_add(bones, ARM, 0, 0.25f, 0);
	bones_add(bones, -1, 0, 0, 0);
	memcpy(bones->node[BODY].rest.rotation, BENT, sizeof(BENT));
	memcpy(bones->node[BODY].rest.scale, (float[3]){x, y, z}, 12);
	memcpy(bones->node[ARM].rest.rotation, TURN, sizeof(TURN));
	memcpy(bones->node[HAND].rest.rotation, BENT, sizeof(BENT));
	bones_pose(bones);
}

static const mat4 *world_of(const struct bones *bones)
{
	return (const mat4 *)bones->world;
}

/* Rotations are alike if they turn two directions alike. */
static void assert_turns_alike(const float a[4], const float b[4])
{
	static const float direction[2][3] = {{1, 2, 3}, {-3, 1, 2}};

	for (int i = 0; i < 2; i++) {
		float by_a[3], by_b[3];

		quat_rotate(a, direction[i], by_a);
		quat_rotate(b, direction[i], by_b);
		assert_all_near(by_a, by_b, 3, 1e-5);
	}
}

static void test_a_root_has_the_worlds_axes_above_it(void **state)
{
	static const float identity[4] = {0, 0, 0, 1};
	struct bones bones;
	float rotation[4];

	(void)state;
	set_up(&bones, 1, 1, -1);
	bone_parent_rotation(&bones.pose, world_of(&bones), BODY, rotation);
	assert_all_near(rotation, identity, 4, 0);
	bone_parent_rotation(&bones.pose, world_of(&bones), OTHER, rotation);
	assert_all_near(rotation, identity, 4, 0);
	bone_parent_rotation(&bones.pose, world_of(&bones), ARM, rotation);
	assert_turns_alike(rotation, BENT);
	assert_false(bone_is_mirrored(&bones.pose, world_of(&bones), BODY));
	assert_false(bone_is_mirrored(&bones.pose, world_of(&bones), OTHER));
	bones_end(&bones);
}

static void test_a_negative_scale_mirrors(void **state)
{
	static const struct {
		float scale[3];
		bool mirrored;
	} cases[] = {{{1, 1, 1}, false}, {{0.5f, 0.5f, 0.5f}, false},
		{{0, 1, 1}, false}, {{1, 1, -0.25f}, true}, {{-2, 1, 1}, true},
		{{-1, -1, 1}, false}, {{-1, -1, -1}, true}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const float *scale = cases[i].scale;
		struct bones bones;

		set_up(&bones, scale[0], scale[1], scale[2]);
		assert_int_equal(
			bone_is_mirrored(&bones.pose, world_of(&bones), ARM),
			cases[i].mirrored);
		assert_int_equal(
			bone_is_mirrored(&bones.pose, world_of(&bones), HAND),
			cases[i].mirrored);
		bones_end(&bones);
	}
}

static void test_directions_turn_into_a_nodes_axes(void **state)
{
	/* Columns: a turn by 90 degrees about z, then scaled. */
	static const mat4 world[5] = {
		{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, 1, 0}, {7, 8, 9, 1}},
		{{0, 2, 0, 0}, {-2, 0, 0, 0}, {0, 0, 2, 0}, {7, 8, 9, 1}},
		{{0, 0.5f, 0, 0}, {-0.5f, 0, 0, 0}, {0, 0, 0.5f, 0}, {0}},
		{{0, 1, 0, 0}, {-1, 0, 0, 0}, {0, 0, -1, 0}, {0}},
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 0, 0}, {0}},
	};
	static const float direction[4] = {1, 2, 3, 4};
	static const float want[6][3] = {{1, 2, 3}, {2, -1, 3}, {2, -1, 3},
		{2, -1, 3}, {2, -1, -3}, {1, 2, 3}};

	(void)state;
	for (int node = -1; node < 5; node++) {
		float out[4] = {9, 9, 9, 9};

		bone_to_axes(world, node, direction, out);
		assert_all_near(out, want[node + 1], 3, 1e-5);
		assert_near(out[3], 9, 0);
	}
}

/* Below a mirror too, a turn in the world moves what the node holds. */
static void test_a_turn_in_the_world_turns_what_follows(void **state)
{
	static const float mirrors[2] = {1, -1};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct bones bones;
		float before[3], after[3];

		set_up(&bones, 1, 1, mirrors[i]);
		vec_subtract(bones.world[HAND][3], bones.world[ARM][3], before);
		quat_rotate(TURN, before, before);
		bone_turn_world(&bones.pose, world_of(&bones), ARM, TURN, 1);
		assert_true(bones.pose.animated[ARM]);
		assert_false(bones.pose.animated[HAND]);
		bones_update(&bones);
		vec_subtract(bones.world[HAND][3], bones.world[ARM][3], after);
		assert_all_near(after, before, 3, 1e-5);
		bones_end(&bones);
	}
}

static void test_a_rotation_in_the_world_is_taken_over(void **state)
{
	static const float mirrors[2] = {1, -1};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct bones bones;
		float got[4];

		set_up(&bones, 1, 1, mirrors[i]);
		bone_set_world_rotation(
			&bones.pose, world_of(&bones), HAND, TURN, 1);
		assert_true(bones.pose.animated[HAND]);
		bones_update(&bones);
		matrix_rotation(bones.world[HAND], got);
		assert_turns_alike(got, TURN);
		bones_end(&bones);
	}
}

/* About x by up to 0.8; more than all of it is all of it. */
static void test_weight_turns_by_a_part(void **state)
{
	static const float axis[3] = {1, 0, 0};
	static const struct {
		float weight, angle_rad;
	} cases[] = {{0, 0}, {0.25f, 0.2f}, {0.5f, 0.4f}, {0.99f, 0.792f},
		{1, 0.8f}, {1.5f, 0.8f}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct bones bones;
		float turn[4], want[4];

		set_up(&bones, 1, 1, 1);
		quat_from_axis_angle(axis, 0.8f, turn);
		quat_from_axis_angle(axis, cases[i].angle_rad, want);
		bone_turn_world(&bones.pose, world_of(&bones), OTHER, turn,
			cases[i].weight);
		assert_turns_alike(bones.pose.local[OTHER].rotation, want);
		bone_set_world_rotation(&bones.pose, world_of(&bones), OTHER,
			turn, cases[i].weight > 0 ? 1 : 0);
		assert_turns_alike(bones.pose.local[OTHER].rotation,
			cases[i].weight > 0 ? turn : want);
		bones_end(&bones);
	}
}

static void test_turned_rotations_have_unit_length(void **state)
{
	struct bones bones;
	float *rotation;

	(void)state;
	set_up(&bones, 1, 1, 1);
	rotation = bones.pose.local[OTHER].rotation;
	rotation[3] = 2;
	bone_turn_world(&bones.pose, world_of(&bones), OTHER, TURN, 1);
	assert_all_near(rotation, TURN, 4, 1e-6);
	bones_end(&bones);
}

static void test_chains_end_at_their_tip(void **state)
{
	struct bones bones;
	int node[4] = {9, 9, 9, 9};

	(void)state;
	set_up(&bones, 1, 1, 1);
	assert_true(bone_chain(&bones.model, HAND, 3, node));
	for (int i = 0; i < 3; i++) {
		assert_int_equal(node[i], BODY + i);
	}
	assert_int_equal(node[3], 9);
	assert_false(bone_chain(&bones.model, HAND, 4, node));
	assert_true(bone_chain(&bones.model, OTHER, 1, node));
	assert_int_equal(node[0], OTHER);
	assert_false(bone_chain(&bones.model, OTHER, 2, node));
	assert_false(bone_chain(&bones.model, OTHER + 1, 1, node));
	assert_false(bone_chain(&bones.model, -1, 1, node));
	assert_true(bone_chain(&bones.model, BODY, 1, node));
	bones_end(&bones);
}

/* Of children that lie along an axis each: to (almost) 0 nothing is divided. */
static void test_children_are_divided_by_what_stretches_them(void **state)
{
	static const struct {
		float factor, scale;
	} cases[] = {{2, 0.5f}, {0.25f, 4}, {-2, 0.5f}, {2e-6f, 5e5f},
		{9e-7f, 1}, {0, 1}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		const float factor[3] = {1, 5, cases[i].factor};
		struct bones bones;

		set_up(&bones, 3, 3, 3);
		quat_set_identity(bones.pose.local[ARM].rotation);
		bone_swell(&bones.pose, BODY, factor);
		assert_near(bones.pose.local[BODY].scale[0], 3, 1e-6);
		assert_near(bones.pose.local[BODY].scale[1], 15, 1e-5);
		assert_near(bones.pose.local[BODY].scale[2],
			3 * (double)cases[i].factor, 1e-6);
		assert_near(bones.pose.local[ARM].scale[0], 1, 1e-6);
		assert_near(bones.pose.local[ARM].scale[1], 0.2, 1e-6);
		assert_near(bones.pose.local[ARM].scale[2], cases[i].scale,
			(double)cases[i].scale * 1e-5);
		assert_near(bones.pose.local[HAND].scale[2], 1, 0);
		assert_near(bones.pose.local[OTHER].scale[2], 1, 0);
		assert_true(bones.pose.animated[BODY]);
		assert_true(bones.pose.animated[ARM]);
		assert_false(bones.pose.animated[HAND]);
		assert_false(bones.pose.animated[OTHER]);
		bones_end(&bones);
	}
}

/* A child that is turned by 90 degrees about z has x along the parent's y. */
static void test_a_turned_child_is_divided_along_its_own_axes(void **state)
{
	static const float factor[3] = {2, 4, 5};
	static const float want[3] = {0.25f, 0.5f, 0.2f};
	struct bones bones;
	float *rotation;

	(void)state;
	set_up(&bones, 1, 1, 1);
	rotation = bones.pose.local[ARM].rotation;
	quat_from_axis_angle((float[3]){0, 0, 1}, 1.5707964f, rotation);
	bone_swell(&bones.pose, BODY, factor);
	assert_all_near(bones.pose.local[ARM].scale, want, 3, 1e-5);
	/* The last node has no children. */
	bone_swell(&bones.pose, OTHER, factor);
	assert_all_near(bones.pose.local[OTHER].scale, factor, 3, 1e-6);
	assert_all_near(bones.pose.local[ARM].scale, want, 3, 1e-5);
	bones_end(&bones);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_root_has_the_worlds_axes_above_it),
		cmocka_unit_test(test_a_negative_scale_mirrors),
		cmocka_unit_test(test_directions_turn_into_a_nodes_axes),
		cmocka_unit_test(test_a_turn_in_the_world_turns_what_follows),
		cmocka_unit_test(test_a_rotation_in_the_world_is_taken_over),
		cmocka_unit_test(test_weight_turns_by_a_part),
		cmocka_unit_test(test_turned_rotations_have_unit_length),
		cmocka_unit_test(test_chains_end_at_their_tip),
		cmocka_unit_test(
			test_children_are_divided_by_what_stretches_them),
		cmocka_unit_test(
			test_a_turned_child_is_divided_along_its_own_axes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
