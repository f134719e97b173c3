#include "app/anim/math/vec.h"
#include "app/anim/procedural/capsule.h"
#include "tests/support/test.h"

#include <math.h>

static const struct capsule_world LYING = {{-1, 0, 0}, {1, 0, 0}, 0.5f};

static void test_points_inside_are_pushed_straight_out(void **state)
{
	float beside[3] = {0.25f, 0.1f, 0};
	const float want[3] = {0.25f, 0.6f, 0};
	float beyond[3] = {1.3f, 0, 0.4f};

	(void)state;
	assert_true(capsule_push(&LYING, 0.1f, beside));
	assert_all_near(beside, want, 3, 1e-6);
	/* Beyond its ends a capsule is a sphere; this point is at 0.5. */
	assert_true(capsule_push(&LYING, 0.25f, beyond));
	assert_near(beyond[0], 1 + 0.75 * 0.6, 1e-6);
	assert_near(beyond[2], 0.75 * 0.8, 1e-6);
}

static void test_points_outside_stay(void **state)
{
	float above[3] = {0, 0.61f, 0};
	float past[3] = {1.7f, 0, 0};

	(void)state;
	assert_false(capsule_push(&LYING, 0.1f, above));
	assert_true(above[1] == 0.61f);
	assert_false(capsule_push(&LYING, 0.1f, past));
}

static void test_points_on_the_line_go_somewhere_outside(void **state)
{
	static const struct capsule_world places[4] = {
		{{-1, 0, 0}, {1, 0, 0}, 0.5f},
		{{0, 0, -1}, {0, 0, 1}, 0.5f},
		{{0, -2, 0}, {0, 3, 0}, 0.5f},
		{{0, 0, 0}, {0, 0, 0}, 0.5f},
	};

	(void)state;
	for (int i = 0; i < 4; i++) {
		float point[3] = {0, 0, 0};

		assert_true(capsule_push(&places[i], 0, point));
		assert_near(vec_length(point), 0.5, 1e-6);
		assert_false(capsule_push(&places[i], -1e-5f, point));
	}
}

static void test_points_beside_the_ends_go_out_from_them(void **state)
{
	static const struct capsule_world shorter = {{2, 0, 0}, {3, 0, 0}, 0.5f};
	static const struct {
		float from[3], to[3];
	} cases[] = {
		{{2.5f, 0.25f, 0}, {2.5f, 0.5f, 0}},
		{{2.25f, 0, -0.25f}, {2.25f, 0, -0.5f}},
		{{1.85f, 0.2f, 0}, {1.7f, 0.4f, 0}},
		{{3.2f, 0, 0.15f}, {3.4f, 0, 0.3f}},
		{{2, 0.125f, 0}, {2, 0.5f, 0}},
		{{3, -0.125f, 0}, {3, -0.5f, 0}},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		float point[3] = {
			cases[i].from[0], cases[i].from[1], cases[i].from[2]};

		assert_true(capsule_push(&shorter, 0, point));
		assert_all_near(point, cases[i].to, 3, 1e-6);
	}
}

static void test_points_that_touch_stay(void **state)
{
	static const struct capsule_world ball = {{0, 0, 0}, {0, 0, 0}, 0.5f};
	float point[3] = {0, 0.75f, 0};

	(void)state;
	assert_false(capsule_push(&ball, 0.25f, point));
	assert_true(capsule_push(&ball, 0.2501f, point));
}

/* Along z as far as the line is not, and otherwise along x. */
static void test_the_way_out_of_a_line_is_fixed(void **state)
{
	static const struct {
		float line[3], out[3];
	} cases[] = {
		{{4, 0, 0}, {0, 0, 0.5f}},
		{{0, 0.25f, 0}, {0, 0, 0.5f}},
		{{0, 0, 3}, {0.5f, 0, 0}},
		{{0, 0, -3}, {0.5f, 0, 0}},
		{{0, 0, 0}, {0, 0, 0.5f}},
		{{3, 0, 4}, {-0.4f, 0, 0.3f}},
		{{0, 3, 4}, {0, -0.4f, 0.3f}},
		{{0, 0.28f, 0.96f}, {0.5f, 0, 0}},
		{{-0.28f, 0, 0.96f}, {0.48f, 0, 0.14f}},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct capsule_world capsule = {.radius = 0.5f};
		float point[3] = {0, 0, 0};

		for (int k = 0; k < 3; k++) {
			capsule.b[k] = cases[i].line[k];
		}
		assert_true(capsule_push(&capsule, 0, point));
		assert_all_near(point, cases[i].out, 3, 1e-6);
	}
}

static void test_capsules_push_one_after_the_other(void **state)
{
	static const struct capsule_world balls[3] = {{{0, 0, 0}, {0, 0, 0}, 1},
		{{2, 0, 0}, {2, 0, 0}, 1.5f}, {{0, 9, 0}, {0, 9, 0}, 1}};
	static const double ends[4] = {0.25, 1, 0.5, 0.5};

	(void)state;
	for (int count = 0; count < 4; count++) {
		float point[3] = {0.25f, 0, 0};

		assert_int_equal(
			capsule_push_all(balls, count, 0, point), count > 0);
		assert_near(point[0], ends[count], 1e-6);
	}
	/* The first, or the last, alone counts as well. */
	assert_true(capsule_push_all(balls, 3, 0, (float[3]){-0.5f, 0, 0}));
	assert_true(capsule_push_all(balls, 3, 0, (float[3]){0, 9.5f, 0}));
	assert_false(capsule_push_all(balls, 3, 0, (float[3]){0, 5, 0}));
}

static void test_capsules_go_with_their_nodes(void **state)
{
	mat4 world[2] = {
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {5, 0, 0, 1}},
		{{0, 2, 0, 0}, {-2, 0, 0, 0}, {0, 0, 2, 0}, {5, 3, 0, 1}},
	};
	const struct capsule capsule = {0, 1, {0, 1, 0}, {1, 0, 0}, 0.25f};
	const float a[3] = {5, 1, 0};
	const float b[3] = {5, 5, 0};
	struct capsule_world posed;

	(void)state;
	capsule_to_world(&capsule, 1, (const mat4 *)world, &posed);
	assert_all_near(posed.a, a, 3, 1e-6);
	assert_all_near(posed.b, b, 3, 1e-6);
	assert_near(posed.radius, 0.25, 0);
}

static void test_each_capsule_has_its_own_nodes(void **state)
{
	static const mat4 world[2] = {
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {5, 0, 0, 1}},
		{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 7, 0, 1}},
	};
	static const struct capsule capsules[3] = {
		{0, 0, {1, 2, 3}, {4, 5, 6}, 1}, {1, 0, {1, 2, 3}, {4, 5, 6}, 2},
		{1, 1, {0, 0, 0}, {0, 0, 0}, 3}};
	static const struct capsule_world want[3] = {{{6, 2, 3}, {9, 5, 6}, 1},
		{{1, 9, 3}, {9, 5, 6}, 2}, {{9, 9, 9}, {9, 9, 9}, 9}};
	struct capsule_world posed[3];

	(void)state;
	posed[2] = want[2];
	capsule_to_world(capsules, 2, world, posed);
	assert_all_near(posed, want, 21, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_points_inside_are_pushed_straight_out),
		cmocka_unit_test(test_points_outside_stay),
		cmocka_unit_test(test_points_on_the_line_go_somewhere_outside),
		cmocka_unit_test(test_points_beside_the_ends_go_out_from_them),
		cmocka_unit_test(test_points_that_touch_stay),
		cmocka_unit_test(test_the_way_out_of_a_line_is_fixed),
		cmocka_unit_test(test_capsules_push_one_after_the_other),
		cmocka_unit_test(test_capsules_go_with_their_nodes),
		cmocka_unit_test(test_each_capsule_has_its_own_nodes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
