#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/spring.h"
#include "platform/base/scalar.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	HEAD,
	FIRST,
	LAST = 4,
	BONES = 4
};

/* A ponytail of four bones, 0.1 long each, which points back from a head. */
struct fixture {
	struct bones bones;
	struct spring spring;
};

static void set_up(struct fixture *f)
{
	int last;

	bones_begin(&f->bones);
	last = bones_add(&f->bones, -1, 0, 1.6f, 0);
	for (int i = 0; i < BONES; i++) {
		last = bones_add(&f->bones, last, 0, 0, -0.1f);
	}
	bones_pose(&f->bones);
	assert_int_equal(
		spring_init(&f->spring, &f->bones.model, LAST, BONES), 0);
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

static void no_gravity(struct fixture *f)
{
	memset(f->spring.gravity, 0, sizeof(f->spring.gravity));
}

/* Advances one frame. The animated pose is the rest pose. */
static void frame(struct fixture *f, float step_s)
{
	for (int i = FIRST; i <= LAST; i++) {
		f->bones.pose.local[i] = f->bones.node[i].rest;
	}
	bones_update(&f->bones);
	spring_update(&f->spring, step_s, NULL, 0, (const mat4 *)f->bones.world,
		&f->bones.pose);
	bones_update(&f->bones);
}

static void run(struct fixture *f, float duration_s, float step_s)
{
	int frames = (int)(duration_s / step_s + 0.5f);

	for (int i = 0; i < frames; i++) {
		frame(f, step_s);
	}
}

/* The position of the ponytail's end. */
static void tip(const struct fixture *f, float out[3])
{
	matrix_apply(((mat4 *)f->bones.world)[LAST], f->spring.end, out);
}

static void test_without_forces_it_stays_as_animated(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	no_gravity(&f);
	run(&f, 1, 0.016f);
	for (int i = FIRST; i <= LAST; i++) {
		assert_all_near(f.bones.pose.local[i].rotation,
			f.bones.node[i].rest.rotation, 4, 1e-4);
	}
	tear_down(&f);
}

static void test_bones_follow_their_ends(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	run(&f, 0.3f, 0.016f);
	for (int i = 0; i < BONES; i++) {
		float at[3];

		matrix_apply(
			((mat4 *)f.bones.world)[FIRST + i], f.spring.end, at);
		assert_all_near(at, f.spring.position[i], 3, 1e-4);
	}
	tear_down(&f);
}

/*
 * A single bone at rest: the spring's force towards the animated position and
 * gravity balance along the arc, so omega^2 L sin(a) = g cos(a).
 */
static void test_a_bone_hangs_where_forces_balance(void **state)
{
	struct fixture f;
	float at[3];
	double omega2 = pow(2 * acos(-1) * 2, 2);
	double angle = atan(9.81 / (omega2 * 0.1));

	(void)state;
	set_up(&f);
	assert_int_equal(spring_init(&f.spring, &f.bones.model, LAST, 1), 0);
	f.spring.damping = 1;
	run(&f, 5, 0.01f);
	tip(&f, at);
	assert_near(at[1] - 1.6, -0.1 * sin(angle), 1e-3);
	assert_near(at[2] + 0.4, -0.1 * cos(angle), 1e-3);
	tear_down(&f);
}

static void test_a_limp_chain_hangs_straight_down(void **state)
{
	struct fixture f;
	float at[3];

	(void)state;
	set_up(&f);
	f.spring.frequency_hz = 0.05f;
	f.spring.damping = 8;
	run(&f, 20, 0.016f);
	tip(&f, at);
	assert_true(at[1] < 1.6f - 0.38f);
	tear_down(&f);
}

/* A small undamped swing has the spring's frequency. */
static void test_it_swings_at_its_frequency(void **state)
{
	struct fixture f;
	int crossings = 0;
	float before = 1;

	(void)state;
	set_up(&f);
	no_gravity(&f);
	assert_int_equal(spring_init(&f.spring, &f.bones.model, LAST, 1), 0);
	no_gravity(&f);
	f.spring.damping = 0;
	frame(&f, 0.002f);
	f.spring.position[0][0] += 0.01f;
	for (int i = 0; i < 1000; i++) {
		float now;

		frame(&f, 0.002f);
		now = f.spring.position[0][0];
		crossings += now * before < 0;
		before = now;
	}
	/* 2 Hz, two crossings a period, two seconds. */
	assert_in_range(crossings, 7, 8);
	tear_down(&f);
}

static void test_frame_times_hardly_matter(void **state)
{
	static const float steps[3] = {0.005f, 0.016f, 0.04f};
	float at[3][3];

	(void)state;
	for (int s = 0; s < 3; s++) {
		struct fixture f;

		set_up(&f);
		run(&f, 0.4f, steps[s]);
		tip(&f, at[s]);
		tear_down(&f);
	}
	assert_all_near(at[1], at[0], 3, 0.02);
	assert_all_near(at[2], at[0], 3, 0.02);
}

static void test_moving_the_head_makes_it_lag(void **state)
{
	struct fixture f;
	float at[3];

	(void)state;
	set_up(&f);
	no_gravity(&f);
	run(&f, 0.5f, 0.016f);
	for (int i = 0; i < 10; i++) {
		f.bones.pose.local[HEAD].translation[0] += 0.03f;
		frame(&f, 0.016f);
	}
	tip(&f, at);
	assert_true(at[0] < f.bones.pose.local[HEAD].translation[0] - 0.05f);
	run(&f, 6, 0.016f);
	tip(&f, at);
	assert_near(at[0], 0.3, 2e-3);
	tear_down(&f);
}

static void test_without_drag_a_steady_motion_changes_nothing(void **state)
{
	static const float speeds[2] = {0, 6};
	float at[2][3];

	(void)state;
	for (int s = 0; s < 2; s++) {
		struct fixture f;

		set_up(&f);
		no_gravity(&f);
		f.spring.damping = 0;
		frame(&f, 0.002f);
		for (int i = 0; i < BONES; i++) {
			f.spring.velocity[i][0] += 0.2f;
			f.spring.velocity[i][1] += speeds[s];
		}
		for (int i = 0; i < 100; i++) {
			f.bones.pose.local[HEAD].translation[1] +=
				0.002f * speeds[s];
			frame(&f, 0.002f);
		}
		tip(&f, at[s]);
		at[s][1] -= f.bones.pose.local[HEAD].translation[1];
		tear_down(&f);
	}
	assert_true(at[0][0] > 0.02f);
	assert_all_near(at[1], at[0], 3, 0.02);
}

static void test_it_keeps_out_of_capsules(void **state)
{
	struct fixture f;
	/* The capsule of a back, just below and behind the head. */
	const struct capsule_world back = {
		{-0.5f, 1.45f, -0.2f}, {0.5f, 1.45f, -0.2f}, 0.1f};

	(void)state;
	set_up(&f);
	f.spring.frequency_hz = 0.3f;
	f.spring.radius = 0.02f;
	for (int i = 0; i < 400; i++) {
		for (int n = FIRST; n <= LAST; n++) {
			f.bones.pose.local[n] = f.bones.node[n].rest;
		}
		bones_update(&f.bones);
		spring_update(&f.spring, 0.016f, &back, 1,
			(const mat4 *)f.bones.world, &f.bones.pose);
		bones_update(&f.bones);
	}
	for (int i = 0; i < BONES; i++) {
		double y = (double)f.spring.position[i][1] - 1.45;
		double z = (double)f.spring.position[i][2] + 0.2;

		/* The length takes precedence: a little overlap is left. */
		assert_true(sqrt(y * y + z * z) > 0.105);
	}
	tear_down(&f);
}

static void test_the_limit_holds(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.spring.frequency_hz = 0.1f;
	f.spring.limit_rad = 0.3f;
	for (int i = 0; i < 200; i++) {
		frame(&f, 0.016f);
		for (int n = FIRST; n <= LAST; n++) {
			assert_true(quat_angle(f.bones.pose.local[n].rotation) <
				0.301f);
		}
	}
	tear_down(&f);
}

static void test_weight_zero_shows_the_animation(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.spring.weight = 0;
	run(&f, 0.5f, 0.016f);
	for (int i = FIRST; i <= LAST; i++) {
		assert_all_near(f.bones.pose.local[i].rotation,
			f.bones.node[i].rest.rotation, 4, 1e-6);
	}
	tear_down(&f);
}

static void test_a_jump_begins_anew(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	no_gravity(&f);
	run(&f, 0.2f, 0.016f);
	f.bones.pose.local[HEAD].translation[0] = 100;
	frame(&f, 0.016f);
	for (int i = FIRST; i <= LAST; i++) {
		assert_all_near(f.bones.pose.local[i].rotation,
			f.bones.node[i].rest.rotation, 4, 1e-3);
	}
	tear_down(&f);
}

/* A head that moves wildly, with a stiff and hardly damped spring. */
static void throw_about(int bones, int count, float step_s)
{
	struct fixture f;

	set_up(&f);
	assert_int_equal(spring_init(&f.spring, &f.bones.model, LAST, bones), 0);
	f.spring.frequency_hz = 8;
	f.spring.damping = 0.02f;
	for (int i = 0; i < count; i++) {
		struct transform *head = &f.bones.pose.local[HEAD];
		float turn = 0.9f * (float)(i % 7 - 3);

		head->translation[0] = i % 3 ? 0.3f : -0.3f;
		head->translation[1] = 1.6f + 0.1f * (float)(i % 5);
		head->rotation[0] = scalar_sin(turn);
		head->rotation[3] = scalar_cos(turn);
		bones_update(&f.bones);
		spring_update(&f.spring, step_s, NULL, 0,
			(const mat4 *)f.bones.world, &f.bones.pose);
		for (int b = 0; b < bones; b++) {
			assert_true(vec_length(f.spring.position[b]) < 3);
			assert_true(vec_length(f.spring.velocity[b]) < 300);
		}
	}
	bones_update(&f.bones);
	bones_assert_finite(&f.bones);
	tear_down(&f);
}

static void test_it_stays_bounded_for_100000_steps(void **state)
{
	(void)state;
	throw_about(1, 100000, 0.005f);
	throw_about(1, 100000, 0.016f);
	throw_about(1, 100000, 0.2f);
}

static void test_a_chain_stays_bounded_too(void **state)
{
	(void)state;
	throw_about(4, 5000, 0.005f);
	throw_about(4, 5000, 0.016f);
	throw_about(4, 5000, 0.2f);
}

static void test_degenerate_springs_stay_finite(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	for (int i = FIRST; i <= LAST; i++) {
		f.bones.node[i].rest.translation[2] = i == 2 ? -0.1f : 0;
	}
	memset(f.spring.end, 0, sizeof(f.spring.end));
	run(&f, 0.5f, 0.016f);
	bones_assert_finite(&f.bones);
	frame(&f, 0);
	frame(&f, -1);
	frame(&f, NAN);
	frame(&f, 1e9f);
	bones_assert_finite(&f.bones);
	tear_down(&f);
}

static void test_a_spring_needs_enough_ancestors(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	assert_int_equal(
		spring_init(&f.spring, &f.bones.model, LAST, 6), -EINVAL);
	assert_int_equal(
		spring_init(&f.spring, &f.bones.model, LAST, 0), -EINVAL);
	assert_int_equal(
		spring_init(&f.spring, &f.bones.model, LAST, SPRING_MAX + 1),
		-EINVAL);
	assert_int_equal(spring_init(&f.spring, &f.bones.model, -1, 1), -EINVAL);
	tear_down(&f);
}

static void test_bones_below_a_mirror_follow_their_ends(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.bones.pose.local[HEAD].scale[2] = -1;
	for (int i = FIRST; i <= LAST; i++) {
		f.bones.node[i].rest.rotation[i % 3] = 0.28f;
		f.bones.node[i].rest.rotation[3] = 0.96f;
	}
	run(&f, 0.3f, 0.016f);
	for (int i = 0; i < BONES; i++) {
		float at[3];

		matrix_apply(
			((mat4 *)f.bones.world)[FIRST + i], f.spring.end, at);
		assert_all_near(at, f.spring.position[i], 3, 1e-4);
	}
	/* Gravity pulls the same way as without the mirror. */
	assert_true(f.bones.world[LAST][3][1] < 1.6f);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_forces_it_stays_as_animated),
		cmocka_unit_test(test_bones_follow_their_ends),
		cmocka_unit_test(test_a_bone_hangs_where_forces_balance),
		cmocka_unit_test(test_a_limp_chain_hangs_straight_down),
		cmocka_unit_test(test_it_swings_at_its_frequency),
		cmocka_unit_test(test_frame_times_hardly_matter),
		cmocka_unit_test(test_moving_the_head_makes_it_lag),
		cmocka_unit_test(
			test_without_drag_a_steady_motion_changes_nothing),
		cmocka_unit_test(test_it_keeps_out_of_capsules),
		cmocka_unit_test(test_the_limit_holds),
		cmocka_unit_test(test_weight_zero_shows_the_animation),
		cmocka_unit_test(test_a_jump_begins_anew),
		cmocka_unit_test(test_it_stays_bounded_for_100000_steps),
		cmocka_unit_test(test_a_chain_stays_bounded_too),
		cmocka_unit_test(test_degenerate_springs_stay_finite),
		cmocka_unit_test(test_a_spring_needs_enough_ancestors),
		cmocka_unit_test(test_bones_below_a_mirror_follow_their_ends),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
