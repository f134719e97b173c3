#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/math/vec.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static const float ROOT_HALF = 0.70710678f;

/* Normalises a quaternion in double. */
static void unit_quat(double x, double y, double z, double w, float out[4])
{
	double length = sqrt(x * x + y * y + z * z + w * w);

	out[0] = (float)(x / length);
	out[1] = (float)(y / length);
	out[2] = (float)(z / length);
	out[3] = (float)(w / length);
}

static void scattered_quat(int i, float out[4])
{
	unit_quat(scattered(4 * i) + 1e-3, scattered(4 * i + 1),
		scattered(4 * i + 2), scattered(4 * i + 3), out);
}

static void slerp_reference(
	const float a[4], const float b[4], double t, double out[4])
{
	double cosine = 0;
	double sign, angle, from, to;

	for (int i = 0; i < 4; i++) {
		cosine += (double)a[i] * b[i];
	}
	sign = cosine < 0 ? -1 : 1;
	angle = acos(fmin(fabs(cosine), 1));
	from = angle < 1e-9 ? 1 - t : sin((1 - t) * angle) / sin(angle);
	to = angle < 1e-9 ? t : sin(t * angle) / sin(angle);
	for (int i = 0; i < 4; i++) {
		out[i] = from * a[i] + sign * to * b[i];
	}
}

static void test_slerp_matches_the_formula_in_double(void **state)
{
	double worst = 0;

	(void)state;
	for (int i = 0; i < 4000; i++) {
		float a[4], b[4], out[4];
		double want[4];
		float t = (float)(i % 17) / 16;
		double length = 0;

		scattered_quat(i, a);
		scattered_quat(i + 1711, b);
		quat_slerp(a, b, t, out);
		slerp_reference(a, b, t, want);
		for (int k = 0; k < 4; k++) {
			worst = fmax(worst, fabs(out[k] - want[k]));
			length += (double)out[k] * out[k];
		}
		assert_near(sqrt(length), 1, 1e-6);
	}
	assert_near(worst, 0, 4e-6);
}

static void test_slerp_of_close_quaternions_is_smooth(void **state)
{
	(void)state;
	/* Angles around the limits of the series, and far below them. */
	for (double angle = 1e-6; angle < 0.2; angle *= 1.05) {
		float a[4] = {0, 0, 0, 1};
		float b[4] = {(float)sin(angle), 0, 0, (float)cos(angle)};
		float out[4];

		quat_slerp(a, b, 0.3f, out);
		assert_near(out[0], sin(0.3 * angle), 1e-6);
		assert_near(out[3], cos(0.3 * angle), 1e-6);
	}
}

static void test_pitfall_5_slerp_takes_the_shorter_arc(void **state)
{
	float a[4] = {0, 0, 0, 1};
	/* The negative of 80 degrees about z, which is the same rotation. */
	float b[4] = {0, 0, -(float)sin(40 * acos(-1) / 180),
		-(float)cos(40 * acos(-1) / 180)};
	float out[4];

	(void)state;
	quat_slerp(a, b, 0.5f, out);
	assert_near(out[2], sin(20 * acos(-1) / 180), 1e-6);
	assert_near(out[3], cos(20 * acos(-1) / 180), 1e-6);
}

static void test_slerp_ends_at_its_inputs(void **state)
{
	(void)state;
	for (int i = 0; i < 200; i++) {
		float a[4], b[4], out[4];
		double dot = 0;

		scattered_quat(i, a);
		scattered_quat(i + 77, b);
		quat_slerp(a, b, 0, out);
		assert_all_near(out, a, 4, 1e-6);
		quat_slerp(a, b, 1, out);
		for (int k = 0; k < 4; k++) {
			dot += (double)out[k] * b[k];
		}
		assert_near(fabs(dot), 1, 1e-6);
	}
}

static void test_slerp_of_opposite_and_equal_stays_finite(void **state)
{
	float a[4] = {0.5f, 0.5f, 0.5f, 0.5f};
	float b[4] = {-0.5f, -0.5f, -0.5f, -0.5f};
	float out[4];

	(void)state;
	quat_slerp(a, b, 0.5f, out);
	assert_all_near(out, a, 4, 1e-6);
	quat_slerp(a, a, 0.5f, a);
	assert_near(a[0], 0.5, 1e-6);
}

static void test_slerp_may_write_over_an_input(void **state)
{
	float a[4], b[4], out[4], over[4];

	(void)state;
	scattered_quat(3, a);
	scattered_quat(8, b);
	quat_slerp(a, b, 0.25f, out);
	memcpy(over, b, sizeof(over));
	quat_slerp(a, over, 0.25f, over);
	assert_memory_equal(over, out, sizeof(out));
}

static void test_normalize_repairs_what_it_can(void **state)
{
	float zero[4] = {0, 0, 0, 0};
	float nan[4] = {0, NAN, 0, 1};
	float large[4] = {0, 3000, 0, 4000};
	const float identity[4] = {0, 0, 0, 1};

	(void)state;
	quat_normalize(zero);
	assert_memory_equal(zero, identity, sizeof(identity));
	quat_normalize(nan);
	assert_memory_equal(nan, identity, sizeof(identity));
	quat_normalize(large);
	assert_near(large[1], 0.6, 1e-6);
	assert_near(large[3], 0.8, 1e-6);
}

static void test_multiply_applies_the_right_one_first(void **state)
{
	/* 90 degrees about x, then 90 about y: +y goes to +z and on to +x. */
	float about_x[4] = {ROOT_HALF, 0, 0, ROOT_HALF};
	float about_y[4] = {0, ROOT_HALF, 0, ROOT_HALF};
	const float up[3] = {0, 1, 0};
	const float want[3] = {1, 0, 0};
	float both[4], out[3];

	(void)state;
	quat_multiply(about_y, about_x, both);
	quat_rotate(both, up, out);
	assert_all_near(out, want, 3, 1e-6);
	quat_multiply(about_y, about_x, about_x);
	assert_memory_equal(about_x, both, sizeof(both));
}

static void test_conjugate_undoes_a_rotation(void **state)
{
	float q[4], back[4], out[4];
	const float identity[4] = {0, 0, 0, 1};

	(void)state;
	scattered_quat(5, q);
	quat_conjugate(q, back);
	quat_multiply(q, back, out);
	assert_all_near(out, identity, 4, 1e-6);
}

static void test_axis_and_angle_make_a_rotation(void **state)
{
	const float axis[3] = {0, 0, 1};
	const float v[3] = {1, 0, 5};
	float q[4], out[3];

	(void)state;
	quat_from_axis_angle(axis, 0.5f, q);
	quat_rotate(q, v, out);
	assert_near(out[0], cos(0.5), 1e-6);
	assert_near(out[1], sin(0.5), 1e-6);
	assert_near(out[2], 5, 1e-6);
	assert_near(quat_angle(q), 0.5, 3e-6);
	quat_from_axis_angle(axis, -3, q);
	assert_near(quat_angle(q), 3, 3e-6);
}

static void test_a_limit_shortens_the_turn_about_its_own_axis(void **state)
{
	static const float axis[3] = {0.6f, 0, 0.8f};
	static const float limit_rad[] = {-1, 0, 0.25f, 0.999f, 1.001f, 4};

	(void)state;
	for (int i = 0; i < 6; i++) {
		float base[4], turn[4], q[4], want[4];
		float angle = limit_rad[i] < 0 ? 0
			: limit_rad[i] > 1     ? 1
					       : limit_rad[i];

		quat_from_axis_angle((float[3]){0, 1, 0}, 2.5f, base);
		quat_from_axis_angle(axis, 1, turn);
		quat_multiply(base, turn, q);
		assert_int_equal(quat_limit(q, base, limit_rad[i]), angle < 1);
		quat_from_axis_angle(axis, angle, turn);
		quat_multiply(base, turn, want);
		assert_all_near(q, want, 4, 1e-5);
	}
}

static void test_between_turns_one_direction_into_the_other(void **state)
{
	(void)state;
	for (int i = 0; i < 500; i++) {
		float from[3] = {
			scattered(i), scattered(i + 900), scattered(i + 33)};
		float to[3] = {
			2 * scattered(i + 5), 2 * scattered(i + 71), 0.3f};
		float q[4];

		quat_between(from, to, q);
		assert_true(vec_normalize(from) > 0);
		assert_true(vec_normalize(to) > 0);
		quat_rotate(q, from, from);
		assert_all_near(from, to, 3, 3e-6);
	}
}

static void test_between_opposites_is_half_a_turn(void **state)
{
	static const float direction[5][3] = {
		{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 1, 1}, {-2, 0.5f, 0.1f}};

	(void)state;
	for (int i = 0; i < 5; i++) {
		float to[3], q[4], out[3];

		for (int k = 0; k < 3; k++) {
			to[k] = -direction[i][k];
		}
		quat_between(direction[i], to, q);
		quat_rotate(q, direction[i], out);
		assert_all_near(out, to, 3, 1e-5);
	}
}

static void test_between_without_a_direction_is_the_identity(void **state)
{
	const float none[3] = {0, 0, 0};
	const float up[3] = {0, 1, 0};
	const float identity[4] = {0, 0, 0, 1};
	float q[4];

	(void)state;
	quat_between(none, up, q);
	assert_memory_equal(q, identity, sizeof(identity));
	quat_between(up, none, q);
	assert_memory_equal(q, identity, sizeof(identity));
}

static void test_a_slope_turns_up_into_its_normal(void **state)
{
	static const float rise[7][2] = {{0, 0}, {0.1f, 0}, {0, -0.5f},
		{0.81f, 0}, {-1, 0.5f}, {2, 3}, {0, -20}};

	(void)state;
	for (int i = 0; i < 7; i++) {
		/* Along x and z, and across both: the normal. */
		const float x[3] = {1, rise[i][0], 0}, z[3] = {0, rise[i][1], 1};
		float up[3] = {0, 1, 0}, normal[3], q[4];

		vec_cross(z, x, normal);
		vec_normalize(normal);
		quat_from_slope(rise[i][0], rise[i][1], q);
		quat_rotate(q, up, up);
		assert_all_near(up, normal, 3, 1e-6);
		assert_float_equal(q[1], 0, 0);
	}
}

static void test_matrix_scales_then_turns_then_moves(void **state)
{
	/* 90 degrees about z. */
	struct transform t = {
		{10, 20, 30}, {0, 0, ROOT_HALF, ROOT_HALF}, {2, 3, 4}};
	const float point[3] = {1, 1, 1};
	/* (2, 3, 4) is rotated to (-3, 2, 4). */
	const float want[3] = {7, 22, 34};
	const float turned[3] = {-3, 2, 4};
	float out[3];
	mat4 m;

	(void)state;
	transform_to_matrix(&t, m);
	matrix_apply(m, point, out);
	assert_all_near(out, want, 3, 1e-5);
	matrix_apply_direction(m, point, out);
	assert_all_near(out, turned, 3, 1e-5);
	assert_true(m[0][3] == 0 && m[1][3] == 0 && m[2][3] == 0);
	assert_true(m[3][3] == 1);
}

static struct transform scattered_transform(int i, float scale)
{
	struct transform t = transform_identity();

	for (int k = 0; k < 3; k++) {
		t.translation[k] = scattered(i * 3 + k);
		t.scale[k] = scale;
	}
	scattered_quat(i, t.rotation);
	return t;
}

static void test_matrix_product_is_the_product(void **state)
{
	struct transform ta = scattered_transform(4, 1.5f);
	struct transform tb = scattered_transform(9, 0.5f);
	mat4 a, b, out;

	(void)state;
	transform_to_matrix(&ta, a);
	transform_to_matrix(&tb, b);
	matrix_multiply(a, b, out);
	for (int c = 0; c < 4; c++) {
		for (int r = 0; r < 4; r++) {
			double want = 0;

			for (int k = 0; k < 4; k++) {
				want += (double)a[k][r] * b[c][k];
			}
			assert_near(out[c][r], want, 1e-6);
		}
	}
	matrix_multiply(a, b, b);
	assert_memory_equal(b, out, sizeof(out));
}

static void test_compose_agrees_with_matrices(void **state)
{
	(void)state;
	for (int i = 0; i < 50; i++) {
		struct transform parent = scattered_transform(i, 1.5f);
		struct transform child = scattered_transform(i + 99, 0.8f);
		mat4 a, b, want, got;

		transform_to_matrix(&parent, a);
		transform_to_matrix(&child, b);
		matrix_multiply(a, b, want);
		transform_compose(&parent, &child, &child);
		transform_to_matrix(&child, got);
		assert_all_near(got, want, 16, 3e-6);
	}
}

static void test_rotation_is_found_in_a_scaled_matrix(void **state)
{
	(void)state;
	for (int i = 0; i < 300; i++) {
		struct transform t = scattered_transform(i, 1);
		float out[4];
		double dot = 0;
		mat4 m;

		t.scale[0] = 0.5f;
		t.scale[1] = 2;
		t.scale[2] = 3;
		transform_to_matrix(&t, m);
		matrix_rotation(m, out);
		for (int k = 0; k < 4; k++) {
			dot += (double)out[k] * t.rotation[k];
		}
		assert_near(fabs(dot), 1, 1e-5);
	}
}

static void test_rotation_of_odd_matrices_stays_unit(void **state)
{
	mat4 flat = {{1, 0, 0, 0}, {0, 0, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	mat4 mirrored = {
		{-1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
	const float identity[4] = {0, 0, 0, 1};
	float out[4];
	double length = 0;

	(void)state;
	matrix_rotation(flat, out);
	assert_memory_equal(out, identity, sizeof(identity));
	matrix_rotation(mirrored, out);
	for (int k = 0; k < 4; k++) {
		length += (double)out[k] * out[k];
	}
	assert_near(length, 1, 1e-6);
}

static void test_mix_is_exact_at_both_ends(void **state)
{
	struct transform a = scattered_transform(1, 1.25f);
	struct transform b = scattered_transform(2, 0.7f);
	struct transform out;

	(void)state;
	transform_mix(&a, &b, 0, &out);
	assert_memory_equal(out.translation, a.translation, 12);
	assert_memory_equal(out.scale, a.scale, 12);
	transform_mix(&a, &b, 1, &out);
	assert_memory_equal(out.translation, b.translation, 12);
	assert_memory_equal(out.scale, b.scale, 12);
	transform_mix(&a, &b, 0.25f, &out);
	assert_near(out.scale[0], 1.25 * 0.75 + 0.7 * 0.25, 1e-6);
}

static void test_vectors_become_unit_or_stay_zero(void **state)
{
	float v[3] = {3, 0, -4};
	float zero[3] = {0, 0, 0};

	(void)state;
	assert_near(vec_normalize(v), 5, 1e-6);
	assert_near(v[0], 0.6, 1e-6);
	assert_near(v[2], -0.8, 1e-6);
	assert_true(vec_normalize(zero) == 0);
	assert_true(zero[0] == 0 && zero[1] == 0 && zero[2] == 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_slerp_matches_the_formula_in_double),
		cmocka_unit_test(test_slerp_of_close_quaternions_is_smooth),
		cmocka_unit_test(test_pitfall_5_slerp_takes_the_shorter_arc),
		cmocka_unit_test(test_slerp_ends_at_its_inputs),
		cmocka_unit_test(test_slerp_of_opposite_and_equal_stays_finite),
		cmocka_unit_test(test_slerp_may_write_over_an_input),
		cmocka_unit_test(test_normalize_repairs_what_it_can),
		cmocka_unit_test(test_multiply_applies_the_right_one_first),
		cmocka_unit_test(test_conjugate_undoes_a_rotation),
		cmocka_unit_test(test_axis_and_angle_make_a_rotation),
		cmocka_unit_test(
			test_a_limit_shortens_the_turn_about_its_own_axis),
		cmocka_unit_test(test_between_turns_one_direction_into_the_other),
		cmocka_unit_test(test_between_opposites_is_half_a_turn),
		cmocka_unit_test(
			test_between_without_a_direction_is_the_identity),
		cmocka_unit_test(test_a_slope_turns_up_into_its_normal),
		cmocka_unit_test(test_matrix_scales_then_turns_then_moves),
		cmocka_unit_test(test_matrix_product_is_the_product),
		cmocka_unit_test(test_compose_agrees_with_matrices),
		cmocka_unit_test(test_rotation_is_found_in_a_scaled_matrix),
		cmocka_unit_test(test_rotation_of_odd_matrices_stays_unit),
		cmocka_unit_test(test_mix_is_exact_at_both_ends),
		cmocka_unit_test(test_vectors_become_unit_or_stay_zero),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
