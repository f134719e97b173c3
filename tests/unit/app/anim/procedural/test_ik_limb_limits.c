/* Limbs of any size, straight ones, and limbs that cannot be bent. */
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/procedural/limb.h"

#include <math.h>
#include <string.h>

/* Bones of these lengths along x, with the elbow bent about z. */
static void set_up(struct fixture *f, float upper, float lower, float bend_rad)
{
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 0, 0);
	bones_add(&f->bones, TORSO, 0, 0, 0);
	bones_add(&f->bones, UPPER, upper, 0, 0);
	bones_add(&f->bones, LOWER, lower, 0, 0);
	f->bones.node[LOWER].rest.rotation[2] = sinf(bend_rad / 2);
	f->bones.node[LOWER].rest.rotation[3] = cosf(bend_rad / 2);
	bones_pose(&f->bones);
	f->limb = (struct ik_limb){UPPER, LOWER, TIP, 1};
}

/* The elbow bends at the pole and about its own axis, z, alone. */
static void check_size(float upper, float lower)
{
	struct fixture f;
	const double whole = (double)upper + (double)lower;

	set_up(&f, upper, lower, 0.2f);
	for (int i = 0; i < 60; i++) {
		const float *q = f.bones.pose.local[LOWER].rotation;
		float direction[3], aside[3], target[3], pole[3];
		float elbow[3], tip[3], normal[3];

		reset(&f);
		scattered_direction(i, direction);
		scattered_direction(i + 77, aside);
		bones_point(&f.bones, UPPER, direction,
			0.3f * upper + 0.68f * lower, target);
		bones_point(&f.bones, UPPER, aside, upper, pole);
		vec_cross(direction, aside, normal);
		if (vec_normalize(normal) < 0.1f) {
			continue;
		}
		assert_near(solve_limb(&f, target, pole), 0, 1e-5 * whole);
		bones_place(&f.bones, TIP, tip);
		bones_place(&f.bones, LOWER, elbow);
		assert_all_near(tip, target, 3, 1e-3 * whole);
		assert_near(vec_dot(elbow, normal), 0, 1e-3 * whole);
		assert_true(vec_dot(elbow, aside) >
			vec_dot(elbow, direction) * vec_dot(aside, direction));
		assert_near(q[0], 0, 2e-3);
		assert_near(q[1], 0, 2e-3);
	}
	bones_end(&f.bones);
}

static void test_limbs_of_all_sizes_bend_as_hinges(void **state)
{
	(void)state;
	check_size(0.004f, 0.003f);
	check_size(0.003f, 0.004f);
	check_size(1, 0.75f);
	check_size(0.75f, 1);
	check_size(400, 300);
}

/* The elbow lies behind the shoulder then: its angle there is above 90. */
static void test_a_longer_lower_bone_reaches_near_targets(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 0.3f, 0.4f, 0.2f);
	for (int i = 0; i < 100; i++) {
		float direction[3], target[3];

		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, UPPER, direction,
			0.101f + 0.005f * (float)i, target);
		assert_near(solve_limb(&f, target, NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
	}
	reset(&f);
	assert_near(solve_limb(&f, (float[3]){0.01f, 0, 0}, NULL), 0.09, 1e-5);
	assert_near(bones_length(&f.bones, UPPER, TIP), 0.1, 1e-3);
	bones_end(&f.bones);
}

/* Equal bones can fold onto the shoulder and all but reach it. */
static void test_equal_bones_fold_onto_the_shoulder(void **state)
{
	static const float size[] = {0.001f, 1, 500};
	static const float part[] = {0, 1e-4f, 0.01f, 0.4f};

	(void)state;
	for (int i = 0; i < 3 * 4; i++) {
		float bone = size[i / 4];
		const float target[3] = {0, 0, bone * part[i % 4]};
		struct fixture f;

		set_up(&f, bone, bone, 1);
		assert_near(
			solve_limb(&f, target, NULL), 0, 1e-5 * (double)bone);
		bones_assert_finite(&f.bones);
		assert_near(bones_distance(&f.bones, TIP, target), 0,
			1e-3 * (double)bone);
		assert_near(bones_length(&f.bones, UPPER, LOWER), (double)bone,
			1e-4 * (double)bone);
		bones_end(&f.bones);
	}
}

/* A straight limb has no bend to keep: it bends to z, and along z to x. */
static void test_a_straight_limb_bends_to_z_or_else_to_x(void **state)
{
	/* The quaternions turn x to these directions. */
	static const struct {
		float rotation[4], direction[3], bend[3];
	} cases[] = {
		{{0, 0, 0, 1}, {1, 0, 0}, {0, 0, 1}},
		{{0, 0, 0.6f, 0.8f}, {0.28f, 0.96f, 0}, {0, 0, 1}},
		{{0, -0.70710678f, 0, 0.70710678f}, {0, 0, 1}, {1, 0, 0}},
	};

	(void)state;
	for (int i = 0; i < 3 * 2; i++) {
		const float *direction = cases[i / 2].direction;
		struct fixture f;
		float target[3], pole[3], elbow[3], want[3];

		set_up(&f, 0.5f, 0.5f, 0);
		memcpy(f.bones.node[UPPER].rest.rotation, cases[i / 2].rotation,
			sizeof(float[4]));
		reset(&f);
		bones_point(&f.bones, UPPER, direction, 0.6f, target);
		bones_point(&f.bones, UPPER, direction, 3, pole);
		/* A pole ahead is no help. */
		assert_near(
			solve_limb(&f, target, i % 2 ? pole : NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
		bones_place(&f.bones, LOWER, elbow);
		for (int k = 0; k < 3; k++) {
			want[k] = 0.3f * direction[k] +
				0.4f * cases[i / 2].bend[k];
		}
		assert_all_near(elbow, want, 3, 1e-4);
		bones_end(&f.bones);
	}
}

/* Any rotation of the elbow below a mirror, not only about the mirror. */
static void test_a_turned_elbow_below_a_mirror_reaches(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 0.4f, 0.3f, 0.2f);
	for (int i = 0; i < 90; i++) {
		float *q = f.bones.node[LOWER].rest.rotation;
		float direction[3], target[3];

		f.bones.node[TORSO].rest.scale[0] = i % 3 == 0 ? -1 : 1;
		f.bones.node[TORSO].rest.scale[1] = i % 3 == 1 ? -1 : 1;
		f.bones.node[TORSO].rest.scale[2] = i % 3 == 2 ? -1 : 1;
		scattered_direction(i, q);
		q[3] = 0.7f;
		quat_normalize(q);
		scattered_direction(i + 31, f.bones.node[UPPER].rest.rotation);
		quat_normalize(f.bones.node[UPPER].rest.rotation);
		reset(&f);
		scattered_direction(i + 9, direction);
		bones_point(&f.bones, UPPER, direction, 0.55f, target);
		assert_near(solve_limb(&f, target, NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
	}
	bones_end(&f.bones);
}

static void test_a_solved_limb_counts_as_animated(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f, 0.4f, 0.3f, 0.2f);
	assert_false(f.bones.pose.animated[LOWER]);
	solve_limb(&f, (float[3]){0.1f, 0.2f, 0.4f}, NULL);
	assert_true(f.bones.pose.animated[UPPER]);
	assert_true(f.bones.pose.animated[LOWER]);
	assert_false(f.bones.pose.animated[TORSO]);
	assert_false(f.bones.pose.animated[TIP]);
	bones_end(&f.bones);
}

static void test_a_bone_without_length_leaves_the_limb_alone(void **state)
{
	static const float length[3][2] = {{0, 0.3f}, {0.3f, 0}, {0, 0}};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct fixture f;
		const float target[3] = {1, 2, 2};

		set_up(&f, length[i][0], length[i][1], 0);
		assert_near(solve_limb(&f, target, target),
			bones_distance(&f.bones, TIP, target), 1e-5);
		for (int n = UPPER; n <= LOWER; n++) {
			assert_memory_equal(&f.bones.pose.local[n],
				&f.bones.node[n].rest, sizeof(struct transform));
			assert_false(f.bones.pose.animated[n]);
		}
		bones_end(&f.bones);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_limbs_of_all_sizes_bend_as_hinges),
		cmocka_unit_test(test_a_longer_lower_bone_reaches_near_targets),
		cmocka_unit_test(test_equal_bones_fold_onto_the_shoulder),
		cmocka_unit_test(test_a_straight_limb_bends_to_z_or_else_to_x),
		cmocka_unit_test(test_a_turned_elbow_below_a_mirror_reaches),
		cmocka_unit_test(test_a_solved_limb_counts_as_animated),
		cmocka_unit_test(
			test_a_bone_without_length_leaves_the_limb_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
