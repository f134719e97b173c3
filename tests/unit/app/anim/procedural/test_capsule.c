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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_points_inside_are_pushed_straight_out),
		cmocka_unit_test(test_points_outside_stay),
		cmocka_unit_test(test_points_on_the_line_go_somewhere_outside),
		cmocka_unit_test(test_capsules_go_with_their_nodes),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
