#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/procedural/sprung.h"

#include <math.h>
#include <string.h>

enum {
	HEAD,
	FIRST,
	SECOND
};

/*
 * A bone of 0.5 that points back from a head at (0, 1, 0), and one behind it.
 * The first bone is a spring on which no force acts.
 */
static void set_up(struct fixture *f)
{
	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 1, 0);
	bones_add(&f->bones, HEAD, 0, 0, 0);
	bones_add(&f->bones, FIRST, 0, 0, -0.5f);
	bones_pose(&f->bones);
	assert_int_equal(spring_init(&f->spring, &f->bones.model, FIRST, 1), 0);
	f->spring.end[2] = -0.5f;
	memset(f->spring.gravity, 0, sizeof(f->spring.gravity));
	f->spring.frequency_hz = 0;
}

/* Turns the first bone up by an angle. */
static void put_up(struct fixture *f, float angle_rad)
{
	f->spring.position[0][0] = 0;
	f->spring.position[0][1] = 1 + 0.5f * sinf(angle_rad);
	f->spring.position[0][2] = -0.5f * cosf(angle_rad);
}

static void test_bones_turn_no_further_than_their_limit(void **state)
{
	static const struct {
		float turned, limit, left;
	} cases[] = {{0.5f, 0.3f, 0.3f}, {0.5f, 0.49f, 0.49f},
		{0.5f, 0.51f, 0.5f}, {0.5f, 0, 0.5f}, {0.5f, -1, 0.5f},
		{2, 1.5f, 1.5f}, {2, 0.5f, 0.5f}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;
		double left = (double)cases[i].left;
		bool limited = cases[i].left < cases[i].turned;

		set_up(&f);
		frame(&f, INSTANT_S);
		put_up(&f, cases[i].turned);
		f.spring.velocity[0][0] = 2;
		f.spring.limit_rad = cases[i].limit;
		frame(&f, INSTANT_S);
		assert_near(quat_angle(f.bones.pose.local[FIRST].rotation),
			left, 1e-3);
		assert_near(f.spring.position[0][1], 1 + 0.5 * sin(left), 5e-4);
		assert_near(f.spring.position[0][2], -0.5 * cos(left), 5e-4);
		assert_near(f.spring.velocity[0][0], limited ? 0 : 2, 0.01);
		tear_down(&f);
	}
}

/* Two balls: the first is elsewhere. */
static void test_capsules_stop_what_leads_into_them(void **state)
{
	static const struct capsule_world balls[2] = {{{9, 9, 9}, {9, 9, 9}, 1},
		{{0, 0.9f, -0.5f}, {0, 0.9f, -0.5f}, 0.12f}};
	static const struct {
		int count;
		double y;
		float speed, left;
	} cases[] = {{2, 1.04975, -5, 0}, {2, 1.04975, 5, 4.95f},
		{2, 1.04975, 0.5f, 0.5f}, {1, 1, -5, -5}, {1, 1, 5, 5}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		set_up(&f);
		f.spring.radius = 0.03f;
		frame(&f, INSTANT_S);
		f.spring.velocity[0][0] = 2;
		f.spring.velocity[0][1] = cases[i].speed;
		frame_beside(&f, INSTANT_S, balls, cases[i].count);
		assert_near(f.spring.position[0][1], cases[i].y, 6e-4);
		assert_near(f.spring.velocity[0][0], 2, 0.03);
		assert_near(f.spring.velocity[0][1], cases[i].left, 0.03);
		assert_near(hypot((double)f.spring.position[0][1] - 1,
				    (double)f.spring.position[0][2]),
			0.5, 1e-5);
		tear_down(&f);
	}
}

static void test_what_leads_along_a_capsule_goes_on(void **state)
{
	static const struct capsule_world ball = {
		{-0.08f, 0.94f, -0.5f}, {-0.08f, 0.94f, -0.5f}, 0.15f};
	static const double want[2] = {3.12, -4.16};
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, INSTANT_S);
	f.spring.velocity[0][0] = 2;
	f.spring.velocity[0][1] = -5;
	frame_beside(&f, INSTANT_S, &ball, 1);
	for (int k = 0; k < 2; k++) {
		assert_near(f.spring.velocity[0][k], want[k], 0.1);
	}
	assert_near(f.spring.position[0][0], 0.04, 1e-3);
	assert_near(f.spring.position[0][1], 1.03, 1e-3);
	tear_down(&f);
}

/* Gravity pulls along all axes but that of the bone. */
static void test_forces_act_across_the_bone(void **state)
{
	static const float ends[3][3] = {
		{0.5f, 0, 0}, {0, 0.5f, 0}, {0, 0, 0.5f}};

	(void)state;
	for (int i = 0; i < 3; i++) {
		struct fixture f;

		set_up(&f);
		memcpy(f.spring.end, ends[i], 12);
		memcpy(f.spring.gravity, (float[3]){1, 2, 3}, 12);
		frame(&f, 0.008f);
		for (int k = 0; k < 3; k++) {
			assert_near(f.spring.velocity[0][k],
				k == i ? 0 : 0.008 * (k + 1), 1e-4);
		}
		tear_down(&f);
	}
}

static void test_short_bones_are_slower(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	f.spring.end[2] = -0.01f;
	frame(&f, INSTANT_S);
	f.spring.velocity[0][0] = 0.8f;
	frame(&f, INSTANT_S);
	assert_near(vec_length(f.spring.velocity[0]), 0.4, 1e-3);
	tear_down(&f);
}

static void test_a_speed_that_is_no_number_is_forgotten(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, INSTANT_S);
	f.spring.velocity[0][0] = NAN;
	frame(&f, INSTANT_S);
	assert_near(vec_length(f.spring.velocity[0]), 0, 1e-3);
	assert_near(f.spring.position[0][2], -0.5, 1e-5);
	tear_down(&f);
}

/* Also of a bone that is animated. */
static void test_the_limit_is_from_the_animated_rotation(void **state)
{
	static const float animated[4] = {0.1f, 0.5f, -0.7f, 0.5f};
	struct fixture f;
	const float *rotation;
	float across[3], turn[4];

	(void)state;
	set_up(&f);
	rotation = f.bones.pose.local[FIRST].rotation;
	memcpy(f.bones.node[FIRST].rest.rotation, animated, 16);
	f.spring.limit_rad = 0.3f;
	frame(&f, INSTANT_S);
	quat_rotate(animated, (float[3]){0.3f, 0.4f, 0}, across);
	vec_add_scaled((float[3]){0, 1, 0}, across, 1, f.spring.position[0]);
	f.spring.weight = 0.5f;
	frame(&f, INSTANT_S);
	quat_conjugate(animated, turn);
	quat_multiply(turn, rotation, turn);
	assert_near(quat_angle(turn), 0.15, 2e-3);
	assert_near(bones_distance(&f.bones, FIRST, f.spring.position[0]), 0.5,
		1e-5);
	tear_down(&f);
}

static void test_below_a_mirror_a_single_bone_begins_at_its_end(void **state)
{
	struct fixture f;
	float end[3];

	(void)state;
	set_up(&f);
	memcpy(f.spring.end, (float[3]){0.1f, 0.2f, 0.3f}, 12);
	f.bones.pose.local[HEAD].scale[2] = -1;
	frame(&f, 0.016f);
	matrix_apply(f.bones.world[FIRST], f.spring.end, end);
	assert_all_near(f.spring.position[0], end, 3, 1e-5);
	assert_near(end[2], -0.3, 1e-4);
	tear_down(&f);
}

static void test_an_end_at_its_beginning_goes_ahead(void **state)
{
	struct fixture f;

	(void)state;
	set_up(&f);
	frame(&f, INSTANT_S);
	f.spring.position[0][1] = 1;
	f.spring.position[0][2] = 0;
	frame(&f, INSTANT_S);
	assert_near(f.spring.position[0][1], 1, 1e-6);
	assert_near(f.spring.position[0][2], -0.5, 1e-6);
	tear_down(&f);
}

static void test_weight_shows_a_part_of_the_motion(void **state)
{
	static const float weights[4] = {0, 0.25f, 0.5f, 1};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct fixture f;
		const float *rotation;

		set_up(&f);
		rotation = f.bones.pose.local[FIRST].rotation;
		f.spring.weight = weights[i];
		frame(&f, INSTANT_S);
		put_up(&f, 0.4f);
		frame(&f, INSTANT_S);
		assert_near(rotation[0], sin(0.2 * (double)weights[i]), 1e-4);
		assert_near(rotation[3], cos(0.2 * (double)weights[i]), 1e-4);
		assert_true(f.bones.pose.animated[FIRST]);
		assert_false(f.bones.pose.animated[HEAD]);
		assert_false(f.bones.pose.animated[SECOND]);
		tear_down(&f);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_bones_turn_no_further_than_their_limit),
		cmocka_unit_test(test_capsules_stop_what_leads_into_them),
		cmocka_unit_test(test_what_leads_along_a_capsule_goes_on),
		cmocka_unit_test(test_forces_act_across_the_bone),
		cmocka_unit_test(test_short_bones_are_slower),
		cmocka_unit_test(test_a_speed_that_is_no_number_is_forgotten),
		cmocka_unit_test(test_the_limit_is_from_the_animated_rotation),
		cmocka_unit_test(
			test_below_a_mirror_a_single_bone_begins_at_its_end),
		cmocka_unit_test(test_an_end_at_its_beginning_goes_ahead),
		cmocka_unit_test(test_weight_shows_a_part_of_the_motion),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
