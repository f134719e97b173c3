/* The ball: a closed surface that faces outward. */
#include "app/scene/stage/ball.h"

#include "app/anim/math/vec.h"
#include "tests/support/test.h"

#include <math.h>

static struct ball ball;

static void test_every_vertex_lies_on_the_ball(void **state)
{
	(void)state;
	ball_init(&ball);
	for (int v = 0; v < BALL_VERTICES; v++) {
		assert_near(vec_length(ball.normal[v]), 1.0, 1e-5);
	}
	assert_near(ball.normal[0][1], 1.0, 1e-6);
	assert_near(ball.normal[BALL_VERTICES - 1][1], -1.0, 1e-6);
}

/* Of the whole surface: a triangle too few, or a wrong one, would show. */
static void test_triangles_face_outward_and_leave_no_hole(void **state)
{
	double area = 0.0, expected = 0.0;

	(void)state;
	ball_init(&ball);
	for (int i = 0; i < BALL_INDICES; i += 3) {
		const float *a = ball.normal[ball.index[i]];
		float b[3], c[3], cross[3];

		assert_in_range(ball.index[i], 0, BALL_VERTICES - 1);
		vec_subtract(ball.normal[ball.index[i + 1]], a, b);
		vec_subtract(ball.normal[ball.index[i + 2]], a, c);
		vec_cross(b, c, cross);
		assert_true(vec_dot(cross, a) > -1e-6f);
		area += 0.5 * (double)vec_length(cross);
	}
	/* Rings of trapezoids between circles of the ball. */
	for (int ring = 0; ring < BALL_RINGS; ring++) {
		double step = 3.14159265358979 / BALL_RINGS;
		double half = 3.14159265358979 / BALL_SPOKES;
		double upper = sin(ring * step), lower = sin((ring + 1) * step);
		double fall = cos(ring * step) - cos((ring + 1) * step);
		double out = (lower - upper) * cos(half);

		expected += BALL_SPOKES * sin(half) * (upper + lower) *
			sqrt(fall * fall + out * out);
	}
	assert_near(area, expected, 1e-4);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_every_vertex_lies_on_the_ball),
		cmocka_unit_test(test_triangles_face_outward_and_leave_no_hole),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
