#include "app/anim/math/vec.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/procedural/limb.h"

#include <math.h>

/*
 * A torso, which is rotated and moved, with a limb whose bones have lengths of
 * 0.4 and 0.3. The elbow is bent by 0.2 rad about z.
 */
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

static void test_a_limb_reaches_within_a_millimetre(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 2000; i++) {
		float direction[3], target[3];

		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, UPPER, direction,
			0.101f + 0.598f * fabsf(scattered(i * 3)), target);
		assert_near(solve_limb(&f, target, NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
		assert_near(bones_length(&f.bones, UPPER, LOWER), 0.4, 1e-5);
		assert_near(bones_length(&f.bones, LOWER, TIP), 0.3, 1e-5);
	}
	tear_down(&f);
}

static void test_an_unreachable_target_stretches_the_limb(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 200; i++) {
		float direction[3], target[3], end[3];

		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, UPPER, direction, 5, target);
		bones_point(&f.bones, UPPER, direction, 0.7f, end);
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
		float direction[3], target[3];

		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, UPPER, direction, i ? 0.05f : 0, target);
		assert_near(solve_limb(&f, target, NULL), i ? 0.05 : 0.1, 1e-4);
		bones_assert_finite(&f.bones);
		assert_near(bones_length(&f.bones, UPPER, TIP), 0.1, 1e-3);
	}
	tear_down(&f);
}

static void test_the_elbow_points_at_the_pole(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 300; i++) {
		float direction[3], target[3], pole[3], aside[3], elbow[3];
		float shoulder[3], normal[3];

		reset(&f);
		scattered_direction(i, direction);
		scattered_direction(i + 77, aside);
		bones_point(&f.bones, UPPER, direction, 0.5f, target);
		bones_point(&f.bones, UPPER, aside, 2, pole);
		if (fabs((double)vec_dot(direction, aside)) > 0.99) {
			continue;
		}
		solve_limb(&f, target, pole);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
		bones_place(&f.bones, UPPER, shoulder);
		bones_place(&f.bones, LOWER, elbow);
		vec_subtract(elbow, shoulder, elbow);
		/* The elbow is in the plane of the pole and on its side. */
		vec_cross(direction, aside, normal);
		vec_normalize(normal);
		assert_near(vec_dot(elbow, normal), 0, 1e-4);
		vec_add_scaled(
			aside, direction, -vec_dot(direction, aside), aside);
		assert_true(vec_dot(elbow, aside) > 0);
	}
	tear_down(&f);
}

/* The elbow's axis is local z, and it bends about no other one. */
static void test_the_elbow_stays_a_hinge(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 300; i++) {
		float direction[3], target[3], pole[3], aside[3];
		const float *q = f.bones.pose.local[LOWER].rotation;

		reset(&f);
		scattered_direction(i, direction);
		scattered_direction(i + 50, aside);
		bones_point(&f.bones, UPPER, direction, 0.45f, target);
		bones_point(&f.bones, UPPER, aside, 2, pole);
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
	float direction[3] = {0, 0, 1};
	float target[3];
	double full, half;

	(void)state;
	set_up_limb(&f);
	bones_point(&f.bones, UPPER, direction, 0.5f, target);
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
		/* Straight, folded, upper or lower bone without length. */
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

/* Exporters mirror a body, or one side of it, by a negative scale. */
static void test_a_limb_below_a_mirror_reaches_too(void **state)
{
	struct fixture f;

	(void)state;
	set_up_limb(&f);
	for (int i = 0; i < 300; i++) {
		float direction[3], target[3];

		f.bones.node[TORSO].rest.scale[i % 3] = -1;
		f.bones.node[TORSO].rest.scale[(i + 1) % 3] = 1;
		f.bones.node[TORSO].rest.scale[(i + 2) % 3] = 1;
		reset(&f);
		scattered_direction(i, direction);
		bones_point(&f.bones, UPPER, direction,
			0.101f + 0.598f * fabsf(scattered(i * 3)), target);
		assert_near(solve_limb(&f, target, NULL), 0, 1e-5);
		assert_near(bones_distance(&f.bones, TIP, target), 0, 1e-3);
	}
	tear_down(&f);
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
		cmocka_unit_test(test_a_limb_below_a_mirror_reaches_too),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
