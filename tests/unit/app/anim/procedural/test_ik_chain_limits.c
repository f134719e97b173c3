/* Chains of one bone, of unlike bones and any size, and what ends a search. */
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/ik.h"
#include "tests/support/model/bones.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

/* Lengths of bones, which are unlike. */
static const float LENGTHS[] = {0.3f, 0.1f, 0.25f, 0.15f, 0.2f};

struct fixture {
	struct bones bones;
	struct ik_chain chain;
	float total;
};

/* A straight chain of up to 5 bones along one axis, each times size. */
static void set_up(struct fixture *f, int bones, int axis, float size)
{
	int last;

	bones_begin(&f->bones);
	last = bones_add(&f->bones, -1, size, -2 * size, 3 * size);
	f->total = 0;
	for (int i = 0; i < bones; i++) {
		float length = LENGTHS[i] * size;

		f->total += length;
		last = bones_add(&f->bones, last, axis == 0 ? length : 0,
			axis == 1 ? length : 0, axis == 2 ? length : 0);
	}
	bones_pose(&f->bones);
	assert_int_equal(
		ik_chain_init(&f->chain, &f->bones.model, last, bones + 1), 0);
	f->chain.tolerance *= size;
}

static void reset(struct fixture *f)
{
	pose_rest(&f->bones.pose, &f->bones.model);
	bones_update(&f->bones);
}

static float solve(struct fixture *f, const float target[3])
{
	float left = ik_chain_solve(&f->chain, target,
		(const mat4 *)f->bones.world, &f->bones.pose);

	bones_update(&f->bones);
	return left;
}

static int tip_of(const struct fixture *f)
{
	return f->chain.node[f->chain.count - 1];
}

static void test_a_chain_begins_with_these_settings(void **state)
{
	struct fixture f;

	(void)state;
	for (int bones = 1; bones <= 5; bones++) {
		set_up(&f, bones, 1, 1);
		assert_int_equal(f.chain.iterations, 32);
		assert_near(f.chain.tolerance, 0.0005, 1e-9);
		assert_near(f.chain.weight, 1, 0);
		for (int i = 0; i <= bones; i++) {
			assert_int_equal(f.chain.node[i], i);
			assert_near(f.chain.limit_rad[i], 0, 0);
		}
		bones_end(&f.bones);
	}
}

static void test_one_bone_points_at_its_target(void **state)
{
	static const float part[] = {0.2f, 1, 4};
	struct fixture f;

	(void)state;
	set_up(&f, 1, 1, 1);
	for (int i = 0; i < 60; i++) {
		float far = part[i % 3] * f.total;
		float direction[3], target[3], end[3];

		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, 0, direction, far, target);
		bones_point(&f.bones, 0, direction, f.total, end);
		assert_near(
			solve(&f, target), fabs((double)(far - f.total)), 1e-3);
		assert_near(bones_distance(&f.bones, 1, end), 0, 1e-3);
	}
	bones_end(&f.bones);
}

static void test_unlike_bones_of_any_size_reach(void **state)
{
	static const float sizes[] = {0.001f, 1, 500};

	(void)state;
	for (int s = 0; s < 3; s++) {
		double size = (double)sizes[s];
		struct fixture f;

		set_up(&f, 5, s, sizes[s]);
		for (int i = 0; i < 60; i++) {
			float direction[3], target[3];

			reset(&f);
			scattered_direction(i, direction);
			bones_point(&f.bones, 0, direction,
				(0.02f + 0.016f * (float)i) * f.total, target);
			assert_near(solve(&f, target), 0, 1e-3 * size);
			assert_near(bones_distance(&f.bones, 5, target), 0,
				1e-3 * size);
			for (int n = 0; n < 5; n++) {
				assert_near(bones_length(&f.bones, n, n + 1),
					(double)LENGTHS[n] * size, 1e-4 * size);
			}
		}
		bones_end(&f.bones);
	}
}

/* Ahead, behind, and at the root itself: along each axis. */
static void test_straight_chains_along_each_axis_buckle(void **state)
{
	static const float part[] = {-0.9f, -0.3f, 0, 0.2f, 0.6f, 0.95f};

	(void)state;
	for (int i = 0; i < 3 * 6 * 2; i++) {
		float size = i / 18 ? 1 : 0.01f;
		float direction[3] = {0, 0, 0}, target[3];
		struct fixture f;

		direction[i % 3] = 1;
		set_up(&f, 5, i % 3, size);
		bones_point(&f.bones, 0, direction, part[i / 3 % 6] * f.total,
			target);
		assert_near(solve(&f, target), 0, 1e-3 * (double)size);
		assert_near(bones_distance(&f.bones, 5, target), 0,
			1e-3 * (double)size);
		bones_end(&f.bones);
	}
}

static void test_a_chain_near_enough_is_left_as_it_is(void **state)
{
	static const float aside[] = {0, 0.009f, 0.011f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		float target[3];
		struct fixture f;

		set_up(&f, 4, 0, 1);
		f.bones.pose.local[1].rotation[2] = 0.6f;
		f.bones.pose.local[1].rotation[3] = 0.8f;
		bones_update(&f.bones);
		f.chain.tolerance = 0.01f;
		bones_place(&f.bones, 4, target);
		target[2] += aside[i];
		assert_near(solve(&f, target), (double)aside[i],
			i < 2 ? 1e-6 : 0.0111);
		assert_true((f.bones.pose.local[0].rotation[3] == 1 &&
				    f.bones.pose.local[2].rotation[3] == 1) ==
			(i < 2));
		bones_end(&f.bones);
	}
}

/* Without iterations the distance is what it was, and so is the pose. */
static void test_no_iterations_and_no_weight_change_nothing(void **state)
{
	const float target[3] = {1.2f, -1.8f, 3.3f};

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct fixture f;
		double before;

		set_up(&f, 4, 1, 1);
		before = bones_distance(&f.bones, 4, target);
		f.chain.iterations = i == 0 ? 0 : 32;
		f.chain.weight = i == 0 ? 1 : 0;
		assert_near(solve(&f, target), i == 0 ? before : 0, 1e-3);
		for (int n = 0; n < 5; n++) {
			assert_all_near(f.bones.pose.local[n].rotation,
				f.bones.node[n].rest.rotation, 4, 1e-6);
		}
		bones_end(&f.bones);
	}
}

static void test_half_the_weight_turns_half_as_far(void **state)
{
	const float target[3] = {1.2f, -1.8f, 3.3f};
	struct fixture f;
	float whole[4];

	(void)state;
	set_up(&f, 4, 1, 1);
	solve(&f, target);
	for (int n = 0; n < 4; n++) {
		whole[n] = quat_angle(f.bones.pose.local[n].rotation);
	}
	reset(&f);
	f.chain.weight = 0.5f;
	assert_near(solve(&f, target), 0, 1e-3);
	for (int n = 0; n < 4; n++) {
		assert_near(quat_angle(f.bones.pose.local[n].rotation),
			(double)whole[n] / 2, 1e-4);
	}
	bones_end(&f.bones);
}

static void test_bones_but_not_the_tip_count_as_animated(void **state)
{
	const float target[3] = {1.2f, -1.8f, 3.3f};
	struct fixture f;

	(void)state;
	set_up(&f, 4, 1, 1);
	solve(&f, target);
	for (int n = 0; n < 5; n++) {
		assert_int_equal(f.bones.pose.animated[n], n != tip_of(&f));
	}
	bones_end(&f.bones);
}

static void test_a_chain_without_length_is_left_alone(void **state)
{
	const float target[3] = {1, -2, 5};
	struct fixture f;

	(void)state;
	set_up(&f, 4, 1, 1);
	for (int n = 1; n < 5; n++) {
		f.bones.node[n].rest.translation[1] = 0;
	}
	reset(&f);
	assert_near(solve(&f, target), 2, 1e-6);
	for (int n = 0; n < 5; n++) {
		assert_false(f.bones.pose.animated[n]);
	}
	bones_end(&f.bones);
}

/* Each joint has its own limit, from the rest and not from the present pose. */
static void test_each_joint_has_its_own_limit_from_the_rest(void **state)
{
	static const float limit_rad[] = {0.2f, -1, 0.5f, 0.05f};
	struct fixture f;

	(void)state;
	set_up(&f, 4, 1, 1);
	for (int n = 0; n < 4; n++) {
		scattered_direction(n, f.bones.node[n].rest.rotation);
		quat_normalize(f.bones.node[n].rest.rotation);
		f.chain.limit_rad[n] = limit_rad[n];
	}
	for (int i = 0; i < 60; i++) {
		float direction[3], target[3];

		reset(&f);
		scattered_direction(i, f.bones.pose.local[2].rotation);
		quat_normalize(f.bones.pose.local[2].rotation);
		bones_update(&f.bones);
		scattered_direction(i + 7, direction);
		bones_point(&f.bones, 0, direction, 5, target);
		solve(&f, target);
		for (int n = 0; n < 4; n++) {
			float turn[4];

			quat_conjugate(f.bones.node[n].rest.rotation, turn);
			quat_multiply(
				turn, f.bones.pose.local[n].rotation, turn);
			assert_true(n == 1 ||
				quat_angle(turn) < limit_rad[n] + 1e-3f);
		}
	}
	bones_end(&f.bones);
}

/* One iteration will do where only a straight chain comes nearest. */
static void test_a_bent_chain_stretches_at_once(void **state)
{
	(void)state;
	for (int i = 0; i < 30; i++) {
		float direction[3], target[3], end[3];
		struct fixture f;

		set_up(&f, 5, i % 3, 1);
		for (int n = 0; n < 5; n++) {
			scattered_direction(
				i + n, f.bones.pose.local[n].rotation);
			quat_normalize(f.bones.pose.local[n].rotation);
		}
		bones_update(&f.bones);
		f.chain.iterations = 1;
		scattered_direction(i + 50, direction);
		bones_point(&f.bones, 0, direction, 1.5f, target);
		bones_point(&f.bones, 0, direction, f.total, end);
		assert_near(solve(&f, target), 1.5 - (double)f.total, 1e-5);
		assert_near(bones_distance(&f.bones, 5, end), 0, 1e-5);
		bones_end(&f.bones);
	}
}

static void test_the_longest_chain_reaches(void **state)
{
	const float target[3] = {0.5f, 1, -0.25f};
	struct ik_chain chain;
	struct bones bones;
	int last;

	(void)state;
	bones_begin(&bones);
	last = bones_add(&bones, -1, 0, 0, 0);
	for (int i = 1; i < IK_CHAIN_MAX; i++) {
		last = bones_add(&bones, last, 0, 0.1f, 0);
	}
	bones_pose(&bones);
	assert_int_equal(
		ik_chain_init(&chain, &bones.model, last, IK_CHAIN_MAX), 0);
	assert_near(ik_chain_solve(&chain, target, (const mat4 *)bones.world,
			    &bones.pose),
		0, 1e-3);
	bones_update(&bones);
	assert_near(bones_distance(&bones, last, target), 0, 1e-3);
	bones_end(&bones);
}

/* Along and between the axes of each plane. */
static void test_straight_chains_between_axes_buckle(void **state)
{
	(void)state;
	for (int i = 0; i < 3 * 8; i++) {
		float axis[3] = {0, 0, 0}, tip[3], root[3], target[3];
		float *rotation;
		struct fixture f;

		set_up(&f, 5, i % 3, 1);
		axis[(i + 1) % 3] = 1;
		rotation = f.bones.pose.local[0].rotation;
		quat_from_axis_angle(
			axis, acosf(-1) / 4 * (float)(i / 3), rotation);
		bones_update(&f.bones);
		bones_place(&f.bones, 0, root);
		bones_place(&f.bones, 5, tip);
		vec_mix(root, tip, 0.6f, target);
		assert_near(solve(&f, target), 0, 1e-3);
		assert_near(bones_distance(&f.bones, 5, target), 0, 1e-3);
		bones_end(&f.bones);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_chain_begins_with_these_settings),
		cmocka_unit_test(test_one_bone_points_at_its_target),
		cmocka_unit_test(test_unlike_bones_of_any_size_reach),
		cmocka_unit_test(test_straight_chains_along_each_axis_buckle),
		cmocka_unit_test(test_a_chain_near_enough_is_left_as_it_is),
		cmocka_unit_test(test_no_iterations_and_no_weight_change_nothing),
		cmocka_unit_test(test_half_the_weight_turns_half_as_far),
		cmocka_unit_test(test_bones_but_not_the_tip_count_as_animated),
		cmocka_unit_test(test_a_chain_without_length_is_left_alone),
		cmocka_unit_test(test_each_joint_has_its_own_limit_from_the_rest),
		cmocka_unit_test(test_a_bent_chain_stretches_at_once),
		cmocka_unit_test(test_the_longest_chain_reaches),
		cmocka_unit_test(test_straight_chains_between_axes_buckle),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
