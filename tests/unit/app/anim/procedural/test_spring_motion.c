#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "tests/support/test.h"
#include "tests/unit/app/anim/procedural/sprung.h"

#include <errno.h>
#include <math.h>
#include <string.h>

enum {
	HEAD,
	EAR,
	FIRST,
	SECOND
};

/*
 * Bones of 0.5 and 0.25 that point back from a head at (0, 1, 0). No force acts.
 */
static void set_up(struct fixture *f, int count)
{
	static const float first[3] = {0, 0, -0.5f}, second[3] = {0, 0, -0.25f};

	bones_begin(&f->bones);
	bones_add(&f->bones, -1, 0, 1, 0);
	bones_add(&f->bones, HEAD, 9, 9, 9);
	bones_add(&f->bones, HEAD, 0, 0, 0);
	bones_add(&f->bones, FIRST, 0, 0, -0.5f);
	bones_pose(&f->bones);
	assert_int_equal(spring_init(&f->spring, &f->bones.model,
				 FIRST + count - 1, count),
		0);
	memcpy(f->spring.end, count == 1 ? first : second, sizeof(first));
	memset(f->spring.gravity, 0, sizeof(f->spring.gravity));
	f->spring.frequency_hz = 0;
}

static void test_a_spring_has_these_settings_unless_told(void **state)
{
	static const float gravity[3] = {0, -9.81f, 0};
	struct bones bones;
	struct spring spring;

	(void)state;
	bones_begin(&bones);
	for (int i = 0; i < 18; i++) {
		bones_add(&bones, i - 1, (float)i, 2, 3);
	}
	assert_int_equal(spring_init(&spring, &bones.model, 17, SPRING_MAX), 0);
	assert_int_equal(spring.count, SPRING_MAX);
	for (int i = 0; i < SPRING_MAX; i++) {
		assert_int_equal(spring.node[i], i + 2);
	}
	assert_all_near(spring.end, ((float[3]){17, 2, 3}), 3, 0);
	assert_near(spring.frequency_hz, 2, 0);
	assert_near(spring.damping, 0.3, 1e-6);
	assert_all_near(spring.gravity, gravity, 3, 0);
	assert_near(spring.limit_rad, 0, 0);
	assert_near(spring.radius, 0, 0);
	assert_near(spring.weight, 1, 0);
	assert_false(spring.begun);
	assert_int_equal(spring_init(&spring, &bones.model, 17, SPRING_MAX + 1),
		-EINVAL);
	assert_int_equal(spring_init(&spring, &bones.model, 17, 0), -EINVAL);
	assert_int_equal(spring_init(&spring, &bones.model, 0, 1), 0);
	assert_int_equal(spring_init(&spring, &bones.model, 0, 2), -EINVAL);
	assert_int_equal(spring_init(&spring, &bones.model, 18, 1), -EINVAL);
	bones_end(&bones);
}

static void test_ends_begin_where_the_bones_end(void **state)
{
	static const float scales[4][3] = {
		{1, 1, 1}, {2, 2, 2}, {0.5f, 0.5f, 0.5f}, {1, 1, -1}};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct fixture f;
		float end[3];

		set_up(&f, 2);
		f.bones.node[SECOND].rest.translation[0] = 0.3f;
		f.bones.node[SECOND].rest.translation[1] = 0.1f;
		memcpy(f.spring.end, (float[3]){0.1f, 0.2f, 0.3f}, 12);
		memcpy(f.bones.node[FIRST].rest.rotation,
			(float[4]){0.1f, 0.5f, -0.7f, 0.5f}, 16);
		memcpy(f.bones.node[SECOND].rest.rotation,
			(float[4]){0.7f, -0.1f, 0.5f, 0.5f}, 16);
		memcpy(f.bones.pose.local[HEAD].scale, scales[i], 12);
		frame(&f, 0.016f);
		matrix_apply(f.bones.world[SECOND], f.spring.end, end);
		assert_all_near(f.spring.position[0], f.bones.world[SECOND][3],
			3, 1e-5);
		assert_all_near(f.spring.position[1], end, 3, 1e-5);
		for (int n = FIRST; n <= SECOND; n++) {
			float turn[4];

			quat_conjugate(f.bones.node[n].rest.rotation, turn);
			quat_multiply(
				turn, f.bones.pose.local[n].rotation, turn);
			assert_near(quat_angle(turn), 0, 2e-3);
		}
		tear_down(&f);
	}
}

/* What gravity makes of a bone in parts of 0.008 s. */
static void test_a_spring_gives_way_by_its_stiffness(void **state)
{
	static const struct {
		float hz, damping;
		double speed, down, later;
	} cases[] = {{2, 0.3f, -0.0759960, -0.000303984, -0.1468094},
		{0, 0.3f, -0.07848, -0.00031392, -0.15696},
		{-3, 0.3f, -0.07848, -0.00031392, -0.15696},
		{14, 0, -0.0698343, -0.000279337, -0.1088952},
		{15, 0.3f, -0.0573551, -0.000229420, -0.0719186},
		{20, 0.3f, -0.0573551, -0.000229420, -0.0719186}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		set_up(&f, 1);
		f.spring.gravity[1] = -9.81f;
		f.spring.frequency_hz = cases[i].hz;
		f.spring.damping = cases[i].damping;
		frame(&f, 0.008f);
		assert_near(f.spring.velocity[0][1], cases[i].speed, 2e-5);
		assert_near(f.spring.position[0][1] - 1, cases[i].down, 3e-7);
		frame(&f, 0.008f);
		assert_near(f.spring.velocity[0][1], cases[i].later, 5e-5);
		tear_down(&f);
	}
}

/* To 40 rad/s: 20 for the first bone and 10, on top of it, for the second. */
static void test_speed_is_limited_across_the_bone(void **state)
{
	static const struct {
		float moved, first[3], second[3];
		double to_first[2], to_second[2];
	} cases[] = {{0, {15, 0, 7}, {15, 9, 0}, {15, 0}, {15, 9}},
		{0, {0, -19.9f, 0}, {0, -29, 0}, {0, -19.9}, {0, -29}},
		{0, {0, 25, 0}, {0, 31, 0}, {0, 20}, {0, 30}},
		{0, {30, 40, 0}, {12, 12, 0}, {12, 16}, {12, 12}},
		{1e-3f, {10, 30, 0}, {10, 20, 9}, {10, 20}, {10, 20}},
		{1e-3f, {25, 0, 0}, {40, 0, 0}, {25, 0}, {35, 0}},
		{1e-3f, {-15, 0, 0}, {-15, 0, 0}, {-10, 0}, {-15, 0}}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;

		set_up(&f, 2);
		frame(&f, INSTANT_S);
		memcpy(f.spring.velocity[0], cases[i].first, 12);
		memcpy(f.spring.velocity[1], cases[i].second, 12);
		f.bones.pose.local[HEAD].translation[0] = cases[i].moved;
		frame(&f, INSTANT_S);
		for (int k = 0; k < 2; k++) {
			assert_near(f.spring.velocity[0][k],
				cases[i].to_first[k], 0.05);
			assert_near(f.spring.velocity[1][k],
				cases[i].to_second[k], 0.05);
		}
		assert_near(f.spring.velocity[0][2], 0, 0.3);
		tear_down(&f);
	}
}

static void test_a_chain_may_have_all_its_bones(void **state)
{
	struct bones bones;
	struct spring spring;

	(void)state;
	bones_begin(&bones);
	for (int i = 0; i < 18; i++) {
		bones_add(&bones, i - 1, 0.1f, 0, 0.01f * (float)i);
	}
	bones_pose(&bones);
	assert_int_equal(spring_init(&spring, &bones.model, 17, SPRING_MAX), 0);
	for (int i = 0; i < 3; i++) {
		spring_update(&spring, 0.008f, NULL, 0,
			(const mat4 *)bones.world, &bones.pose);
		bones_update(&bones);
	}
	for (int i = 0; i + 1 < SPRING_MAX; i++) {
		assert_all_near(
			spring.position[i], bones.world[i + 3][3], 3, 1e-4);
	}
	bones_end(&bones);
}

/* Further than four times 0.5 and 0.25. */
static void test_only_a_far_jump_begins_anew(void **state)
{
	static const struct {
		float scale, to[3];
		bool anew;
	} cases[] = {{1, {3, 1, 0}, false}, {1, {3.01f, 1, 0}, true},
		{1, {0, -1.9f, 0}, false}, {1, {0, -2.1f, 0}, true},
		{1, {2.2f, 3.2f, 0}, true}, {2, {5.9f, 1, 0}, false},
		{2, {6.1f, 1, 0}, true}};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct fixture f;
		struct transform *head;

		set_up(&f, 2);
		head = &f.bones.pose.local[HEAD];
		for (int k = 0; k < 3; k++) {
			head->scale[k] = cases[i].scale;
		}
		frame(&f, 0.008f);
		f.spring.velocity[1][1] = 3;
		memcpy(head->translation, cases[i].to, 12);
		frame(&f, 0.008f);
		assert_int_equal(vec_length(f.spring.velocity[1]) < 0.01f,
			cases[i].anew);
		if (cases[i].anew) {
			assert_near(
				f.spring.position[1][0], cases[i].to[0], 1e-4);
			assert_near(f.spring.position[1][2],
				-0.75 * (double)cases[i].scale, 1e-4);
		}
		tear_down(&f);
	}
}

static void move(struct fixture *f, float part)
{
	struct transform *head = &f->bones.pose.local[HEAD];
	const float axis[3] = {0.6f, 0, 0.8f};

	head->translation[0] = 0.6f * part;
	head->translation[1] = 1 - 0.3f * part;
	head->translation[2] = 0.2f * part;
	quat_from_axis_angle(axis, 1.2f * part, head->rotation);
}

/* The head moves and turns evenly: a step is worth its parts. */
static void test_a_step_is_worth_its_parts(void **state)
{
	struct fixture f[2];

	(void)state;
	for (int i = 0; i < 2; i++) {
		int frames = i ? 12 : 1;

		set_up(&f[i], 2);
		f[i].spring.frequency_hz = 1.5f;
		f[i].spring.gravity[1] = -9.81f;
		frame(&f[i], 0.008f);
		for (int n = 1; n <= frames; n++) {
			move(&f[i], (float)n / (float)frames);
			frame(&f[i], 0.096f / (float)frames);
		}
	}
	assert_all_near(f[0].spring.position, f[1].spring.position, 6, 2e-4);
	assert_all_near(f[0].spring.velocity, f[1].spring.velocity, 6, 5e-3);
	/* Bones end where the next ones begin, and keep their lengths. */
	assert_all_near(
		f[0].spring.position[0], f[0].bones.world[SECOND][3], 3, 1e-4);
	assert_near(bones_distance(&f[0].bones, FIRST, f[0].spring.position[0]),
		0.5, 1e-5);
	assert_near(bones_distance(&f[0].bones, SECOND, f[0].spring.position[1]),
		0.25, 1e-4);
	tear_down(&f[0]);
	tear_down(&f[1]);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_spring_has_these_settings_unless_told),
		cmocka_unit_test(test_ends_begin_where_the_bones_end),
		cmocka_unit_test(test_a_spring_gives_way_by_its_stiffness),
		cmocka_unit_test(test_speed_is_limited_across_the_bone),
		cmocka_unit_test(test_a_chain_may_have_all_its_bones),
		cmocka_unit_test(test_only_a_far_jump_begins_anew),
		cmocka_unit_test(test_a_step_is_worth_its_parts),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
