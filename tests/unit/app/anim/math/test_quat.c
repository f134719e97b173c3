/* Rotations at and beside the limits where their formulas change. */
#include "app/anim/math/quat.h"
#include "app/anim/math/vec.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const float IDENTITY[4] = {0, 0, 0, 1};

/* Both sides of x = -0.05, where the series ends; the ends of x. */
static void test_slerp_weights_are_right_on_both_sides(void **state)
{
	static const float xs[] = {-0.001f, -0.03f, -0.0499f, -0.05f, -0.0501f,
		-0.2f, -0.6f, -0.999f};

	(void)state;
	for (size_t i = 0; i < sizeof(xs) / sizeof(*xs); i++) {
		double angle = acos(1 + (double)xs[i]);

		for (int n = 0; n <= 64; n++) {
			double t = n / 64.0;
			float weight[2];

			quat_slerp_weights(xs[i], (float)t, weight);
			assert_near(weight[0], sin((1 - t) * angle) / sin(angle),
				xs[i] > -0.05f ? 2.5e-7 : 1e-6);
			assert_near(weight[1], sin(t * angle) / sin(angle),
				xs[i] > -0.05f ? 2.5e-7 : 1e-6);
		}
	}
}

/* Errors of a length are no angle: the result is as long as the inputs. */
static void test_slerp_of_close_ones_forgives_their_lengths(void **state)
{
	static const float length[] = {0.9998f, 1.0002f};

	(void)state;
	for (int i = 0; i < 2; i++) {
		for (int axis = 0; axis < 4; axis++) {
			float a[4] = {0, 0, 0, 0}, out[4];

			a[axis] = length[i];
			quat_slerp(a, a, 0.5f, out);
			assert_all_near(out, a, 4, 1e-6);
		}
	}
}

/* Each component counts for the distance of close rotations. */
static void test_slerp_of_close_ones_is_right_in_each_plane(void **state)
{
	const double angle = 0.028;

	(void)state;
	for (int from = 0; from < 4; from++) {
		for (int to = 0; to < 4; to++) {
			float a[4] = {0, 0, 0, 0}, b[4] = {0, 0, 0, 0};
			float out[4];

			if (from == to) {
				continue;
			}
			a[from] = 1;
			b[from] = (float)cos(angle);
			b[to] = (float)sin(angle);
			quat_slerp(a, b, 0.5f, out);
			assert_near(out[from], cos(angle / 2), 1e-6);
			assert_near(out[to], sin(angle / 2), 1e-7);
		}
	}
}

static void test_normalize_ends_where_squares_do(void **state)
{
	static const struct {
		float length;
		bool kept;
	} cases[] = {
		{0.999e-15f, false},
		{1.001e-15f, true},
		{0.999e15f, true},
		{1.001e15f, false},
	};

	(void)state;
	for (int i = 0; i < 4; i++) {
		for (int axis = 0; axis < 4; axis++) {
			float q[4] = {0, 0, 0, 0}, unit[4] = {0, 0, 0, 0};

			q[axis] = -cases[i].length;
			unit[axis] = -1;
			quat_normalize(q);
			assert_all_near(
				q, cases[i].kept ? unit : IDENTITY, 4, 1e-6);
		}
	}
}

static void test_vectors_end_at_a_shortest_length(void **state)
{
	static const float length[] = {0.5e-18f, 1e-18f, 1.1e-18f};

	(void)state;
	for (int i = 0; i < 3; i++) {
		for (int axis = 0; axis < 3; axis++) {
			float v[3] = {0, 0, 0};
			float was;

			v[axis] = -length[i];
			was = vec_normalize(v);
			assert_near(was, i < 2 ? 0 : (double)length[i], 1e-23);
			assert_near(v[axis], i < 2 ? -(double)length[i] : -1,
				i < 2 ? 0 : 1e-6);
		}
	}
}

/* Beside an axis by so little that the square of it is nothing. */
static void test_half_turns_are_whole_beside_each_axis(void **state)
{
	for (int i = 0; i < 3 * 9; i++) {
		float beside[3] = {0, 1e-22f, 1e-21f};
		float from[3], to[3], q[5], out[3];

		(void)state;
		from[i / 9] = 1;
		from[(i / 9 + 1) % 3] = beside[i % 3];
		from[(i / 9 + 2) % 3] = beside[i / 3 % 3];
		for (int k = 0; k < 3; k++) {
			to[k] = -from[k];
		}
		for (int k = 0; k < 5; k++) {
			q[k] = 7; /* what was there does not matter */
		}
		quat_between(from, to, q);
		assert_near(quat_angle(q), acos(-1), 1e-6);
		assert_near(vec_length(q), 1, 1e-6);
		assert_true(q[3] == 0 && q[4] == 7);
		quat_rotate(q, from, out);
		assert_all_near(out, to, 3, 1e-6);
	}
}

static void test_a_turn_of_the_limit_itself_is_kept(void **state)
{
	float q[4] = {0.36f, 0, 0.48f, 0.8f};
	const float was[4] = {0.36f, 0, 0.48f, 0.8f};
	float limit_rad = quat_angle(q);

	(void)state;
	assert_false(quat_limit(q, IDENTITY, limit_rad));
	assert_memory_equal(q, was, sizeof(q));
	assert_true(quat_limit(q, IDENTITY, 0.999f * limit_rad));
	assert_near(quat_angle(q), 0.999 * (double)limit_rad, 1e-5);
}

static void test_limits_shorten_turns_of_any_angle(void **state)
{
	static const float axis[3] = {0, 0.6f, -0.8f};
	static const float angle[] = {0.5f, 2, 3};

	(void)state;
	for (int i = 0; i < 3; i++) {
		float q[4], want[4];

		quat_from_axis_angle(axis, angle[i], q);
		quat_from_axis_angle(axis, 0.25f, want);
		assert_true(quat_limit(q, IDENTITY, 0.25f));
		assert_all_near(q, want, 4, 2e-6);
	}
}

/* Lengths that are off by rounding do not grow from limit to limit. */
static void test_a_limited_turn_is_of_unit_length(void **state)
{
	const float base[4] = {0, 1.01f * 0.6f, 0, 1.01f * 0.8f};
	float q[4] = {0.6f, 0, 0, 0.8f};
	double square = 0;

	(void)state;
	assert_true(quat_limit(q, base, 0.1f));
	for (int i = 0; i < 4; i++) {
		square += (double)q[i] * q[i];
	}
	assert_near(square, 1, 1e-6);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_slerp_weights_are_right_on_both_sides),
		cmocka_unit_test(test_slerp_of_close_ones_forgives_their_lengths),
		cmocka_unit_test(test_slerp_of_close_ones_is_right_in_each_plane),
		cmocka_unit_test(test_normalize_ends_where_squares_do),
		cmocka_unit_test(test_vectors_end_at_a_shortest_length),
		cmocka_unit_test(test_half_turns_are_whole_beside_each_axis),
		cmocka_unit_test(test_a_turn_of_the_limit_itself_is_kept),
		cmocka_unit_test(test_limits_shorten_turns_of_any_angle),
		cmocka_unit_test(test_a_limited_turn_is_of_unit_length),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
