#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/ik.h"
#include "tests/support/model/bones.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>

/* A straight chain of bones along +Y, each 0.2 long, on a moved root. */
static int set_up_chain(struct bones *bones, int count)
{
	int last;

	bones_begin(bones);
	last = bones_add(bones, -1, -1, 0.5f, 2);
	for (int i = 1; i < count; i++) {
		last = bones_add(bones, last, 0, 0.2f, 0);
	}
	bones_pose(bones);
	return last;
}

static float solve_chain(struct bones *bones, const struct ik_chain *chain,
	const float target[3])
{
	float left = ik_chain_solve(
		chain, target, (const mat4 *)bones->world, &bones->pose);

	bones_update(bones);
	return left;
}

static void test_a_chain_reaches_within_a_millimetre(void **state)
{
	(void)state;
	for (int count = 3; count <= IK_CHAIN_MAX; count += 3) {
		struct bones bones;
		struct ik_chain chain;
		int tip = set_up_chain(&bones, count);
		float total = 0.2f * (float)(count - 1);

		assert_int_equal(
			ik_chain_init(&chain, &bones.model, tip, count), 0);
		for (int i = 0; i < 300; i++) {
			float direction[3], target[3];
			float far = 0.02f + 0.97f * fabsf(scattered(i * 3));

			pose_rest(&bones.pose, &bones.model);
			bones_update(&bones);
			scattered_direction(i, direction);
			bones_point(&bones, 0, direction, far * total, target);
			assert_near(
				solve_chain(&bones, &chain, target), 0, 1e-3);
			assert_near(
				bones_distance(&bones, tip, target), 0, 1e-3);
		}
		for (int i = 1; i < count; i++) {
			assert_near(bones_length(&bones, i - 1, i), 0.2, 1e-5);
		}
		bones_end(&bones);
	}
}

static void test_a_straight_chain_reaches_a_target_on_its_line(void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 6);
	const float up[3] = {0, 1, 0};

	(void)state;
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 6), 0);
	for (int i = -9; i <= 9; i++) {
		float target[3];

		pose_rest(&bones.pose, &bones.model);
		bones_update(&bones);
		bones_point(&bones, 0, up, 0.1f * (float)i, target);
		assert_near(solve_chain(&bones, &chain, target), 0, 1e-3);
		assert_near(bones_distance(&bones, tip, target), 0, 1e-3);
	}
	bones_end(&bones);
}

static void test_an_unreachable_target_stretches_the_chain(void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 6);

	(void)state;
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 6), 0);
	for (int i = 0; i < 100; i++) {
		float direction[3], target[3], end[3];

		scattered_direction(i, direction);
		bones_point(&bones, 0, direction, 3, target);
		bones_point(&bones, 0, direction, 1, end);
		assert_near(solve_chain(&bones, &chain, target), 2, 2e-3);
		assert_near(bones_distance(&bones, tip, end), 0, 2e-3);
	}
	bones_end(&bones);
}

static double turned(const struct bones *bones, int node)
{
	float back[4];

	quat_conjugate(bones->node[node].rest.rotation, back);
	quat_multiply(back, bones->pose.local[node].rotation, back);
	return (double)quat_angle(back);
}

static void test_joint_limits_hold(void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 7);
	int reached = 0;

	(void)state;
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 7), 0);
	for (int i = 0; i < 7; i++) {
		chain.limit_rad[i] = 0.6f;
	}
	for (int i = 0; i < 400; i++) {
		float direction[3], target[3];

		pose_rest(&bones.pose, &bones.model);
		bones_update(&bones);
		scattered_direction(i, direction);
		bones_point(&bones, 0, direction, 1.1f, target);
		reached += solve_chain(&bones, &chain, target) < 1e-3f;
		for (int n = 0; n < 7; n++) {
			assert_true(turned(&bones, n) < 0.6 + 1e-3);
		}
	}
	/* Many targets ahead of the chain are within the limits. */
	assert_true(reached > 100);
	bones_end(&bones);
}

/* The targets come from poses within the limits. */
static void test_a_limited_chain_reaches_what_it_can(void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 6);
	int missed = 0;

	(void)state;
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 6), 0);
	for (int i = 0; i < 6; i++) {
		chain.limit_rad[i] = 0.8f;
	}
	for (int i = 0; i < 300; i++) {
		float target[3];

		pose_rest(&bones.pose, &bones.model);
		for (int n = 0; n < 5; n++) {
			float axis[3] = {
				scattered(i + n), 0, scattered(i * 5 + n)};

			vec_normalize(axis);
			quat_from_axis_angle(axis, 0.7f * scattered(i * 7 + n),
				bones.pose.local[n].rotation);
		}
		bones_update(&bones);
		bones_place(&bones, tip, target);
		pose_rest(&bones.pose, &bones.model);
		bones_update(&bones);
		missed += solve_chain(&bones, &chain, target) > 1e-3f;
	}
	assert_int_equal(missed, 0);
	bones_end(&bones);
}

static void test_degenerate_chains_stay_finite(void **state)
{
	static const float targets[5][3] = {{-1, 0.5f, 2}, {-1, 0.5f, 2.0001f},
		{1e7f, 1e7f, 0}, {0, 0, 0}, {-1, 0.7f, 2}};

	(void)state;
	for (int shape = 0; shape < 3; shape++) {
		struct bones bones;
		struct ik_chain chain;
		int tip = set_up_chain(&bones, 5);

		/* All bones have a length; then all but one; then none. */
		for (int i = 1; i < 5; i++) {
			if (shape == 2 || (shape == 1 && i == 2)) {
				bones.node[i].rest.translation[1] = 0;
			}
		}
		assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 5), 0);
		for (int t = 0; t < 5; t++) {
			pose_rest(&bones.pose, &bones.model);
			bones_update(&bones);
			assert_true(
				solve_chain(&bones, &chain, targets[t]) >= 0);
			bones_assert_finite(&bones);
			chain.limit_rad[1] = 0.1f;
		}
		bones_end(&bones);
	}
}

static void test_a_chain_needs_enough_ancestors(void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 5);

	(void)state;
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 6), -EINVAL);
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 1), -EINVAL);
	assert_int_equal(
		ik_chain_init(&chain, &bones.model, tip, IK_CHAIN_MAX + 1),
		-EINVAL);
	assert_int_equal(ik_chain_init(&chain, &bones.model, -1, 2), -EINVAL);
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 5), 0);
	assert_int_equal(chain.node[0], 0);
	assert_int_equal(chain.node[4], tip);
	bones_end(&bones);
}

static void test_a_chain_below_a_mirror_reaches_and_keeps_its_limits(
	void **state)
{
	struct bones bones;
	struct ik_chain chain;
	int tip = set_up_chain(&bones, 7);

	(void)state;
	bones.node[0].rest.scale[0] = -1;
	for (int n = 0; n < 3; n++) {
		bones.node[n].rest.rotation[n] = 0.6f;
		bones.node[n].rest.rotation[3] = 0.8f;
	}
	assert_int_equal(ik_chain_init(&chain, &bones.model, tip, 6), 0);
	for (int i = 0; i < 100; i++) {
		bool limited = i % 2;
		float direction[3], target[3];

		for (int n = 0; n < 6; n++) {
			chain.limit_rad[n] = limited ? 0.4f : 0;
		}
		pose_rest(&bones.pose, &bones.model);
		bones_update(&bones);
		scattered_direction(i, direction);
		bones_point(&bones, 1, direction, 0.7f, target);
		solve_chain(&bones, &chain, target);
		if (!limited) {
			assert_near(
				bones_distance(&bones, tip, target), 0, 1e-3);
		}
		for (int n = 1; n < 6 && limited; n++) {
			float turn[4];

			quat_conjugate(bones.node[n].rest.rotation, turn);
			quat_multiply(turn, bones.pose.local[n].rotation, turn);
			assert_true(quat_angle(turn) < 0.401f);
		}
	}
	bones_end(&bones);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_chain_reaches_within_a_millimetre),
		cmocka_unit_test(
			test_a_straight_chain_reaches_a_target_on_its_line),
		cmocka_unit_test(test_an_unreachable_target_stretches_the_chain),
		cmocka_unit_test(test_joint_limits_hold),
		cmocka_unit_test(test_a_limited_chain_reaches_what_it_can),
		cmocka_unit_test(test_degenerate_chains_stay_finite),
		cmocka_unit_test(test_a_chain_needs_enough_ancestors),
		cmocka_unit_test(
			test_a_chain_below_a_mirror_reaches_and_keeps_its_limits),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
