#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/ik.h"
#include "tests/support/bones.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

static double scatter(int i)
{
	return fmod(i * 0.754877666 + 0.5, 1) * 2 - 1;
}

/* A direction all round, by index. */
static void direction(int i, float out[3])
{
	double z = scatter(i);
	double turn = 2.399963 * i;

	out[0] = (float)(sqrt(1 - z * z) * cos(turn));
	out[1] = (float)(sqrt(1 - z * z) * sin(turn));
	out[2] = (float)z;
}

/*
 * A torso, and below it a limb with bones of 0.4 and 0.3: its elbow is bent
 * by 0.2 rad about z. The whole is turned and moved.
 */
enum {
	TORSO,
	UPPER,
	LOWER,
	TIP
};

struct fixture {
	struct bones bones;
	struct ik_limb limb;
};

static void set_up_limb(struct fixture *f)
{
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 1, 2, 3);
	bones_add(&f->bones, TORSO, 0, 0.5f, 0);
	bones_add(&f->bones, UPPER, 0.4f, 0, 0);
	bones_add(&f->bones, LOWER, 0.3f, 0, 0);
	f->bones.node[TORSO].rest.rotation[1] = sinf(0.35f);
	f->bones.node[TORSO].rest.rotation[3] = cosf(0.35f);
	f->bones.node[LOWER].rest.rotation[2] = sinf(0.1f);
	f->bones.node[LOWER].rest.rotation[3] = cosf(0.1f);
	bones_pose(&f->bones);
	f->limb = (struct ik_limb){UPPER, LOWER, TIP, 1};
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

static void reset(struct fixture *f)
{
	pose_rest(&f->bones.pose, &f->bones.model);
	bones_update(&f->bones);
}

static float solve_limb(
	struct fixture *f, const float target[3], const float pole[3])
{
	float missing = ik_limb_solve(&f->limb, target, pole,
		(const mat4 *)f->bones.world, &f->bones.pose);

	bones_update(&f->bones);
	return missing;
}

static double distance(const struct bones *bones, int a, int b)
{
	float at[3];

	bones_place(bones, b, at);
	return bones_distance(bones, a, at);
}

static void target_at(const struct bones *bones, int node, const float way[3],
	float far, float out[3])
{
	bones_place(bones, node, out);
	vec_add_scaled(out, way, far, out);
}

static void test_a_limb_reaches_within_a_millimetre(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 2000; i++) {
		float way[3], target[3];

		reset(&f);
		direction(i, way);
		target_at(&f.bones, UPPER, way,
			0.101f + 0.598f * (float)fabs(scatter(i * 3)), target);
		assert_near(solve_limb(&f, target, NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
		assert_near(distance(&f.bones, UPPER, LOWER), 0.4, 1e-5);
		assert_near(distance(&f.bones, LOWER, TIP), 0.3, 1e-5);
	}
	tear_down(&f);
}

static void test_an_unreachable_target_stretches_the_limb(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 200; i++) {
		float way[3], target[3], end[3];

		reset(&f);
		direction(i, way);
		target_at(&f.bones, UPPER, way, 5, target);
		target_at(&f.bones, UPPER, way, 0.7f, end);
		assert_near(solve_limb(&f, target, NULL), 4.3, 1e-4);
		assert_near(bones_distance(&f.bones, TIP, end), 0, 1e-3);
	}
	tear_down(&f);
}

static void test_a_target_too_near_folds_the_limb(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 200; i++) {
		float way[3], target[3];

		reset(&f);
		direction(i, way);
		target_at(&f.bones, UPPER, way, i ? 0.05f : 0, target);
		assert_near(solve_limb(&f, target, NULL), i ? 0.05 : 0.1, 1e-4);
		bones_assert_finite(&f.bones);
		assert_near(distance(&f.bones, UPPER, TIP), 0.1, 1e-3);
	}
	tear_down(&f);
}

static void test_the_elbow_points_at_the_pole(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 300; i++) {
		float way[3], target[3], pole[3], aside[3], elbow[3];
		float shoulder[3], normal[3];

		reset(&f);
		direction(i, way);
		direction(i + 77, aside);
		target_at(&f.bones, UPPER, way, 0.5f, target);
		target_at(&f.bones, UPPER, aside, 2, pole);
		if (fabs((double)vec_dot(way, aside)) > 0.99) {
			continue;
		}
		solve_limb(&f, target, pole);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
		bones_place(&f.bones, UPPER, shoulder);
		bones_place(&f.bones, LOWER, elbow);
		vec_subtract(elbow, shoulder, elbow);
		/* In the plane of the pole, and on its side. */
		vec_cross(way, aside, normal);
		vec_normalize(normal);
		assert_near(vec_dot(elbow, normal), 0, 1e-4);
		vec_add_scaled(aside, way, -vec_dot(way, aside), aside);
		assert_true(vec_dot(elbow, aside) > 0);
	}
	tear_down(&f);
}

/* The elbow's axis is local z; swung by the pole it remains a hinge. */
static void test_the_elbow_stays_a_hinge(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 300; i++) {
		float way[3], target[3], pole[3], aside[3];
		const float *q = f.bones.pose.local[LOWER].rotation;

		reset(&f);
		direction(i, way);
		direction(i + 50, aside);
		target_at(&f.bones, UPPER, way, 0.45f, target);
		target_at(&f.bones, UPPER, aside, 2, pole);
		solve_limb(&f, target, pole);
		assert_near(q[0], 0, 2e-3);
		assert_near(q[1], 0, 2e-3);
	}
	tear_down(&f);
}

static void test_a_limb_on_target_is_left_as_it_is(void **state)
{
	struct fixture f;
	float target[3];

	(void)state;
	set_up_limb(&f);
	bones_place(&f.bones, TIP, target);
	solve_limb(&f, target, NULL);
	for (int i = UPPER; i <= TIP; i++) {
		assert_all_near(f.bones.pose.local[i].rotation,
			f.bones.node[i].rest.rotation, 4, 1e-4);
	}
	tear_down(&f);
}

static void test_weight_blends_with_the_animation(void **state)
{
	struct fixture f;
	float way[3] = {0, 0, 1};
	float target[3];
	double full, half;

	(void)state;
	set_up_limb(&f);
	target_at(&f.bones, UPPER, way, 0.5f, target);
	f.limb.weight = 0;
	solve_limb(&f, target, NULL);
	assert_all_near(f.bones.pose.local[UPPER].rotation,
		f.bones.node[UPPER].rest.rotation, 4, 1e-6);
	full = bones_distance(&f.bones, TIP, target);
	f.limb.weight = 0.5f;
	solve_limb(&f, target, NULL);
	half = bones_distance(&f.bones, TIP, target);
	assert_true(half > 0.1 * full && half < 0.8 * full);
	tear_down(&f);
}

static void test_degenerate_limbs_stay_finite(void **state)
{
	static const float targets[6][3] = {{1, 2.5f, 3}, {1, 2.5f, 3.000001f},
		{1e6f, 0, 0}, {0, 0, 0}, {1, 2, 3}, {-1e-20f, 1e-20f, 0}};

	(void)state;
	for (int shape = 0; shape < 4; shape++) {
		struct fixture f;

		set_up_limb(&f);
		/* Straight, folded, without an upper or a lower bone. */
		f.bones.node[LOWER].rest.rotation[2] = shape == 1 ? 1 : 0;
		f.bones.node[LOWER].rest.rotation[3] = shape == 1 ? 0 : 1;
		f.bones.node[LOWER].rest.translation[0] = shape == 2 ? 0 : 0.4f;
		f.bones.node[TIP].rest.translation[0] = shape == 3 ? 0 : 0.3f;
		for (int t = 0; t < 6; t++) {
			reset(&f);
			assert_true(solve_limb(&f, targets[t], targets[t]) >= 0);
			bones_assert_finite(&f.bones);
			reset(&f);
			solve_limb(&f, targets[t], NULL);
			bones_assert_finite(&f.bones);
		}
		tear_down(&f);
	}
}

/* A straight chain of bones along +Y, each of 0.2, on a moved root. */
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
	float missing = ik_chain_solve(
		chain, target, (const mat4 *)bones->world, &bones->pose);

	bones_update(bones);
	return missing;
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
			float way[3], target[3];
			float far = 0.02f + 0.97f * (float)fabs(scatter(i * 3));

			pose_rest(&bones.pose, &bones.model);
			bones_update(&bones);
			direction(i, way);
			target_at(&bones, 0, way, far * total, target);
			assert_near(
				solve_chain(&bones, &chain, target), 0, 1e-3);
			assert_near(
				bones_distance(&bones, tip, target), 0, 1e-3);
		}
		for (int i = 1; i < count; i++) {
			assert_near(distance(&bones, i - 1, i), 0.2, 1e-5);
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
		target_at(&bones, 0, up, 0.1f * (float)i, target);
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
		float way[3], target[3], end[3];

		direction(i, way);
		target_at(&bones, 0, way, 3, target);
		target_at(&bones, 0, way, 1, end);
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
		float way[3], target[3];

		pose_rest(&bones.pose, &bones.model);
		bones_update(&bones);
		direction(i, way);
		target_at(&bones, 0, way, 1.1f, target);
		reached += solve_chain(&bones, &chain, target) < 1e-3f;
		for (int n = 0; n < 7; n++) {
			assert_true(turned(&bones, n) < 0.6 + 1e-3);
		}
	}
	/* Ahead of it there is much that it reaches all the same. */
	assert_true(reached > 100);
	bones_end(&bones);
}

/* Targets made from a pose within the limits can be reached again. */
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
			float axis[3] = {(float)scatter(i + n), 0,
				(float)scatter(i * 5 + n)};

			vec_normalize(axis);
			quat_from_axis_angle(axis,
				0.7f * (float)scatter(i * 7 + n),
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

		/* One bone without length, then none with any. */
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_limb_reaches_within_a_millimetre),
		cmocka_unit_test(test_an_unreachable_target_stretches_the_limb),
		cmocka_unit_test(test_a_target_too_near_folds_the_limb),
		cmocka_unit_test(test_the_elbow_points_at_the_pole),
		cmocka_unit_test(test_the_elbow_stays_a_hinge),
		cmocka_unit_test(test_a_limb_on_target_is_left_as_it_is),
		cmocka_unit_test(test_weight_blends_with_the_animation),
		cmocka_unit_test(test_degenerate_limbs_stay_finite),
		cmocka_unit_test(test_a_chain_reaches_within_a_millimetre),
		cmocka_unit_test(
			test_a_straight_chain_reaches_a_target_on_its_line),
		cmocka_unit_test(test_an_unreachable_target_stretches_the_chain),
		cmocka_unit_test(test_joint_limits_hold),
		cmocka_unit_test(test_a_limited_chain_reaches_what_it_can),
		cmocka_unit_test(test_degenerate_chains_stay_finite),
		cmocka_unit_test(test_a_chain_needs_enough_ancestors),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
