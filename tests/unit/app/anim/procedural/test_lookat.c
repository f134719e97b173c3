#include "app/anim/math/matrix.h"
#include "app/anim/math/vec.h"
#include "app/anim/procedural/lookat.h"
#include "tests/support/model/bones.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	BODY,
	HEAD
};

static const float DEGREE = 0.0174532925f;

struct fixture {
	struct bones bones;
	struct lookat lookat;
};

static void set_up(struct fixture *f)
{
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 5, 0, 0);
	bones_add(&f->bones, BODY, 0, 1.5f, 0);
	bones_pose(&f->bones);
	f->lookat = lookat_default(HEAD);
	f->lookat.rate = 0;
}

static void tear_down(struct fixture *f)
{
	bones_end(&f->bones);
}

/* Updates once from the rest pose; out is the direction of the head. */
static void look(
	struct fixture *f, const float target[3], float step_s, float out[3])
{
	bones_update(&f->bones);
	lookat_update(&f->lookat, target, step_s, (const mat4 *)f->bones.world,
		&f->bones.pose);
	bones_update(&f->bones);
	matrix_apply_direction(f->bones.world[HEAD], f->lookat.forward, out);
}

static double angle_to(
	struct fixture *f, const float target[3], const float looks[3])
{
	float want[3];

	vec_subtract(target, f->bones.world[HEAD][3], want);
	vec_normalize(want);
	return acos(fmin(1, (double)vec_dot(want, looks)));
}

static void test_it_looks_at_a_target_within_its_limits(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	/* The rotation of the body does not matter. */
	f.bones.pose.local[BODY].rotation[1] = sinf(0.4f);
	f.bones.pose.local[BODY].rotation[3] = cosf(0.4f);
	for (int i = 0; i < 100; i++) {
		float target[3] = {5 + sinf(0.8f + (float)i * 0.01f) * 3,
			1.5f + (float)(i % 7 - 3) * 0.5f,
			cosf(0.8f + (float)i * 0.01f) * 3};
		float looks[3];

		f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
		look(&f, target, 0.1f, looks);
		assert_near(angle_to(&f, target, looks), 0, 1e-3);
	}
	tear_down(&f);
}

static void test_positive_yaw_is_to_the_left_and_pitch_up(void **state)
{
	struct fixture f;
	const float target[3] = {6, 1.5f, 1}; /* +X is left of +Z with +Y up */
	const float above[3] = {5, 2.5f, 2};
	float looks[3];

	(void)state;
	set_up(&f);
	look(&f, target, 0.1f, looks);
	assert_near(f.lookat.yaw_rad, 45 * DEGREE, 1e-5);
	assert_near(f.lookat.pitch_rad, 0, 1e-5);
	f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
	look(&f, above, 0.1f, looks);
	assert_near(f.lookat.yaw_rad, 0, 1e-5);
	assert_near(f.lookat.pitch_rad, atan2(1, 2), 1e-5);
	assert_near(looks[1], 1 / sqrt(5), 1e-5);
	tear_down(&f);
}

static void test_limits_hold(void **state)
{
	struct fixture f;
	const float aside[3] = {
		5 + 3 * sinf(100 * DEGREE), 1.5f, 3 * cosf(100 * DEGREE)};
	const float below[3] = {5, -50, 1};
	float looks[3];

	(void)state;
	set_up(&f);
	look(&f, aside, 0.1f, looks);
	assert_near(f.lookat.yaw_rad, 80 * DEGREE, 1e-3);
	assert_near(atan2(looks[0], looks[2]), 80 * DEGREE, 1e-3);
	f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
	look(&f, below, 0.1f, looks);
	assert_near(f.lookat.pitch_rad, -50 * DEGREE, 1e-3);
	assert_near(looks[1], -sin(50 * DEGREE), 1e-3);
	tear_down(&f);
}

static void test_a_target_behind_is_given_up(void **state)
{
	struct fixture f;
	const float behind[3] = {5.1f, 1.7f, -3};
	float looks[3];

	(void)state;
	set_up(&f);
	f.lookat.yaw_rad = 0.5f;
	look(&f, behind, 0.1f, looks);
	assert_near(looks[2], 1, 1e-5);
	f.lookat.release_rad = 0;
	f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
	look(&f, behind, 0.1f, looks);
	assert_near(f.lookat.yaw_rad, 80 * DEGREE, 1e-3);
	tear_down(&f);
}

static void test_it_follows_at_its_rate_whatever_the_frames(void **state)
{
	const float target[3] = {6, 1.5f, 1};
	double want = 45 * DEGREE * (1 - exp(-8 * 0.25));

	(void)state;
	for (int frames = 1; frames <= 25; frames += 8) {
		struct fixture f;
		float looks[3];

		set_up(&f);
		f.lookat.rate = 8;
		for (int i = 0; i < frames; i++) {
			f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
			look(&f, target, 0.25f / (float)frames, looks);
		}
		assert_near(f.lookat.yaw_rad, want, 1e-4);
		tear_down(&f);
	}
}

static void test_weight_takes_a_share(void **state)
{
	struct fixture f;
	const float target[3] = {6, 1.5f, 1};
	float looks[3];

	(void)state;
	set_up(&f);
	f.lookat.weight = 0.25f;
	look(&f, target, 0.1f, looks);
	assert_near(atan2(looks[0], looks[2]), 45 * DEGREE / 4, 1e-5);
	f.lookat.weight = 0;
	f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
	look(&f, target, 0.1f, looks);
	assert_near(looks[2], 1, 1e-6);
	tear_down(&f);
}

static void test_without_a_target_it_looks_ahead(void **state)
{
	struct fixture f;
	float looks[3];

	(void)state;
	set_up(&f);
	f.lookat.yaw_rad = 1;
	look(&f, NULL, 0.1f, looks);
	assert_near(looks[2], 1, 1e-6);
	tear_down(&f);
}

static void test_a_target_in_the_head_is_harmless(void **state)
{
	struct fixture f;
	const float inside[3] = {5, 1.5f, 0};
	const float above[3] = {5, 9, 0};
	float looks[3];

	(void)state;
	set_up(&f);
	look(&f, inside, 0.1f, looks);
	bones_assert_finite(&f.bones);
	assert_near(looks[2], 1, 1e-6);
	look(&f, above, 0.1f, looks);
	bones_assert_finite(&f.bones);
	tear_down(&f);
}

static void test_a_head_below_a_mirror_looks_at_the_target(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.bones.pose.local[BODY].scale[0] = -1;
	f.bones.pose.local[BODY].rotation[1] = sinf(0.4f);
	f.bones.pose.local[BODY].rotation[3] = cosf(0.4f);
	for (int i = 0; i < 100; i++) {
		float target[3] = {5 + sinf(0.8f + (float)i * 0.01f) * 3,
			1.5f + (float)(i % 7 - 3) * 0.5f,
			cosf(0.8f + (float)i * 0.01f) * 3};
		float looks[3];

		f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
		f.bones.pose.local[HEAD].rotation[0] = 0.1f;
		f.bones.pose.local[HEAD].rotation[3] = sqrtf(0.99f);
		look(&f, target, 0.1f, looks);
		assert_near(angle_to(&f, target, looks), 0, 1e-3);
	}
	tear_down(&f);
}

/* Beside the angle at which it gives up, and the angle itself. */
static void test_it_gives_up_beyond_the_angle_of_release(void **state)
{
	static const float release_rad[] = {0.3f, 0.9f, 2.094f};

	(void)state;
	for (int i = 0; i < 3 * 5; i++) {
		float angle =
			release_rad[i / 5] * (0.8f + 0.1f * (float)(i % 5));
		const float target[3] = {
			5 + 2 * sinf(angle), 1.5f, 2 * cosf(angle)};
		struct fixture f;
		float looks[3], yaw_rad;

		set_up(&f);
		f.lookat.yaw_limit_rad = 4;
		f.lookat.release_rad = 0;
		look(&f, target, 0.1f, looks);
		yaw_rad = f.lookat.yaw_rad;
		assert_near(yaw_rad, (double)angle, 1e-5);
		f.lookat.release_rad = release_rad[i / 5];
		if (i % 5 == 2) {
			f.lookat.release_rad = yaw_rad;
		}
		f.bones.pose.local[HEAD] = f.bones.node[HEAD].rest;
		look(&f, target, 0.1f, looks);
		assert_near(f.lookat.yaw_rad, i % 5 > 2 ? 0 : (double)yaw_rad,
			1e-6);
		tear_down(&f);
	}
}

static void test_by_default_it_gives_up_at_120_degrees(void **state)
{
	(void)state;
	for (int i = 0; i < 2; i++) {
		float angle = (i ? 121 : 119) * DEGREE;
		const float target[3] = {
			5 + 2 * sinf(angle), 1.5f, 2 * cosf(angle)};
		struct fixture f;
		float looks[3];

		set_up(&f);
		assert_near(lookat_default(HEAD).rate, 8, 0);
		look(&f, target, 0.1f, looks);
		assert_near(
			f.lookat.yaw_rad, i ? 0 : (double)(80 * DEGREE), 1e-3);
		tear_down(&f);
	}
}

static void test_it_looks_at_what_is_near(void **state)
{
	struct fixture f;
	const float target[3] = {5.03f, 1.53f, 0.03f};
	float looks[3];

	(void)state;
	set_up(&f);
	look(&f, target, 0.1f, looks);
	assert_near(f.lookat.yaw_rad, 45 * DEGREE, 1e-4);
	assert_near(f.lookat.pitch_rad, atan(sqrt(0.5)), 1e-4);
	tear_down(&f);
}

/* Both angles follow at the same rate, slow ones too, by the same weight. */
static void test_both_angles_take_their_time_and_share(void **state)
{
	static const float rate[] = {0.5f, 1, 3};
	const float target[3] = {6, 2.5f, 1};

	(void)state;
	for (int i = 0; i < 3; i++) {
		double part = 1 - exp(-(double)rate[i] * 0.5);
		double pitch = part * atan(sqrt(0.5));
		struct fixture f;
		float looks[3];

		set_up(&f);
		f.lookat.rate = rate[i];
		f.lookat.weight = 0.5f;
		look(&f, target, 0.5f, looks);
		assert_near(f.lookat.yaw_rad, part * 45 * (double)DEGREE, 1e-5);
		assert_near(f.lookat.pitch_rad, pitch, 1e-5);
		assert_near(asin((double)looks[1]), pitch / 2, 1e-5);
		tear_down(&f);
	}
}

/* Rotations that are off by rounding do not grow from frame to frame. */
static void test_a_looking_head_is_animated_and_of_unit_length(void **state)
{
	struct fixture f;
	const float target[3] = {6, 1.5f, 1};
	const float *q;
	float looks[3];

	(void)state;
	set_up(&f);
	q = f.bones.pose.local[HEAD].rotation;
	f.bones.pose.local[HEAD].rotation[3] = 1.01f;
	assert_false(f.bones.pose.animated[HEAD]);
	look(&f, target, 0.1f, looks);
	assert_near(
		q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3], 1, 1e-6);
	assert_true(f.bones.pose.animated[HEAD]);
	assert_false(f.bones.pose.animated[BODY]);
	tear_down(&f);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_it_looks_at_a_target_within_its_limits),
		cmocka_unit_test(test_positive_yaw_is_to_the_left_and_pitch_up),
		cmocka_unit_test(test_limits_hold),
		cmocka_unit_test(test_a_target_behind_is_given_up),
		cmocka_unit_test(test_it_follows_at_its_rate_whatever_the_frames),
		cmocka_unit_test(test_weight_takes_a_share),
		cmocka_unit_test(test_without_a_target_it_looks_ahead),
		cmocka_unit_test(test_a_target_in_the_head_is_harmless),
		cmocka_unit_test(test_a_head_below_a_mirror_looks_at_the_target),
		cmocka_unit_test(test_it_gives_up_beyond_the_angle_of_release),
		cmocka_unit_test(test_by_default_it_gives_up_at_120_degrees),
		cmocka_unit_test(test_it_looks_at_what_is_near),
		cmocka_unit_test(test_both_angles_take_their_time_and_share),
		cmocka_unit_test(
			test_a_looking_head_is_animated_and_of_unit_length),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
