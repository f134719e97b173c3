#include "app/anim/math/matrix.h"
#include "app/anim/math/quat.h"
#include "app/anim/math/transform.h"
#include "app/anim/math/vec.h"
#include "tests/support/model/scattered.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

static void make_matrix(int seed, const float scale[3], mat4 out)
{
	struct transform t = transform_identity();

	for (int i = 0; i < 3; i++) {
		t.translation[i] = scattered(seed + i);
		t.rotation[i] = scattered(seed + 3 + i);
		t.scale[i] = scale[i];
	}
	quat_normalize(t.rotation);
	transform_to_matrix(&t, out);
}

/* Transforms a triangle and checks the normal that the matrix makes of its. */
static void assert_at_right_angles(mat4 matrix, int seed, bool mirrored)
{
	float a[3], b[3], normal[3], out[3], want[3];
	mat4 normals;

	for (int i = 0; i < 3; i++) {
		a[i] = scattered(seed + i);
		b[i] = scattered(seed + 3 + i);
	}
	vec_cross(a, b, normal);
	matrix_normals((const mat4 *)matrix, (mat4 *)normals);
	matrix_apply(normals, normal, out);
	matrix_apply_direction(matrix, a, a);
	matrix_apply_direction(matrix, b, b);
	assert_true(vec_normalize(a) > 0 && vec_normalize(b) > 0);
	vec_cross(a, b, want);
	assert_true(vec_normalize(want) > 0 && vec_normalize(out) > 0);
	for (int i = 0; i < 3; i++) {
		assert_near(out[i], mirrored ? -want[i] : want[i], 1e-5);
	}
}

static void test_normals_stay_at_right_angles_to_the_surface(void **state)
{
	static const float scale[][3] = {{1, 1, 1}, {2, 0.5f, 1}, {1, 1, 9},
		{1e-9f, 2e-9f, 1e-9f}, {1e9f, 1e9f, 3e9f}, {-1, 2, 1},
		{-1, -2, -1}, {-3, -2, 1}};

	(void)state;
	for (int i = 0; i < 8 * 20; i++) {
		const float *s = scale[i % 8];
		mat4 matrix;

		make_matrix(7 * i, s, matrix);
		assert_at_right_angles(matrix, i, s[0] * s[1] * s[2] < 0);
	}
}

static void test_an_even_matrix_is_its_own_for_normals(void **state)
{
	(void)state;
	for (int i = 0; i < 20; i++) {
		float size = 0.1f * (float)(i + 1);
		const float scale[3] = {size, i % 2 ? size : -size, size};
		mat4 matrix, normals;

		make_matrix(7 * i, scale, matrix);
		assert_true(matrix_is_even((const mat4 *)matrix));
		matrix_normals((const mat4 *)matrix, (mat4 *)normals);
		for (int k = 0; k < 9; k++) {
			assert_near(normals[k / 3][k % 3], matrix[k / 3][k % 3],
				1e-5 * (double)size);
		}
	}
}

static void test_uneven_scale_and_shear_are_noticed(void **state)
{
	const float even[3] = {2, 2, 2}, uneven[3] = {2, 2.1f, 2};
	mat4 matrix;

	(void)state;
	make_matrix(3, uneven, matrix);
	assert_false(matrix_is_even((const mat4 *)matrix));
	make_matrix(3, even, matrix);
	vec_add_scaled(matrix[0], matrix[1], 0.05f, matrix[0]);
	assert_false(matrix_is_even((const mat4 *)matrix));
}

static void test_flat_matrices_keep_the_normal_of_the_plane(void **state)
{
	const float flat[3] = {1, 0, 1}, line[3] = {0, 1, 0},
		    none[3] = {0, 0, 0};
	const float up[3] = {0, 1, 0};
	mat4 matrix, normals;
	float axis[3], out[3];

	(void)state;
	make_matrix(5, flat, matrix);
	vec_cross(matrix[2], matrix[0], axis);
	matrix_normals((const mat4 *)matrix, (mat4 *)normals);
	matrix_apply(normals, up, out);
	assert_true(vec_normalize(out) > 0 && vec_normalize(axis) > 0);
	assert_near(vec_dot(out, axis), 1, 1e-5);
	make_matrix(5, line, matrix);
	matrix_normals((const mat4 *)matrix, (mat4 *)normals);
	assert_memory_equal(normals, matrix, sizeof(matrix));
	make_matrix(5, none, matrix);
	matrix_normals((const mat4 *)matrix, (mat4 *)normals);
	assert_memory_equal(normals, matrix, sizeof(matrix));
}

static void set_scale(float x, float y, float z, mat4 out)
{
	memset(out, 0, sizeof(mat4));
	out[0][0] = x;
	out[1][1] = y;
	out[2][2] = z;
	out[3][3] = 1;
}

/* Squares of lengths may be 2 in 256 apart, and angles 1 in 256 off. */
static void test_even_ends_at_1_in_256_for_each_axis(void **state)
{
	static const float part[] = {0, 0.999f, 1.001f};

	(void)state;
	for (int i = 0; i < 3 * 3 * 2 * 3; i++) {
		float by = part[i % 3] * (i / 27 ? -1 : 1) / 256;
		float size = i / 9 % 3 == 0 ? 1 : i / 9 % 3 == 1 ? 0.01f : 30;
		int c = i / 3 % 3, next = (c + 1) % 3;
		mat4 matrix;

		set_scale(size, size, size, matrix);
		matrix[c][next] = by * size;
		assert_int_equal(
			matrix_is_even((const mat4 *)matrix), i % 3 < 2);
		/* The first axis is what the others are compared with. */
		set_scale(size, size, size, matrix);
		matrix[c][c] = size * sqrtf(1 + (c > 0 ? 2 : 0) * by);
		assert_int_equal(matrix_is_even((const mat4 *)matrix),
			i % 3 < 2 || c == 0);
	}
}

static void test_a_matrix_that_is_no_number_is_not_even(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		mat4 matrix;

		set_scale(2, 2, 2, matrix);
		assert_true(matrix_is_even((const mat4 *)matrix));
		matrix[i / 3][i % 3] = NAN;
		assert_false(matrix_is_even((const mat4 *)matrix));
	}
}

/* Half turns and more, about each axis and between: each largest component. */
static void test_rotations_beyond_a_third_of_a_turn_are_found(void **state)
{
	(void)state;
	for (int i = 0; i < 27 * 5; i++) {
		float axis[3] = {(float)(i % 3) - 1, (float)(i / 3 % 3) - 1,
			(float)(i / 9 % 3) - 1};
		struct transform t = transform_identity();
		float out[4], cosine;
		mat4 matrix;

		if (vec_normalize(axis) == 0) {
			continue;
		}
		/* 120 to 200 degrees: the trace is 0 and less. */
		quat_from_axis_angle(
			axis, 2.0944f + 0.35f * (float)(i / 27), t.rotation);
		transform_to_matrix(&t, matrix);
		matrix_rotation(matrix, out);
		cosine = vec_dot(out, t.rotation) + out[3] * t.rotation[3];
		for (int k = 0; k < 4; k++) {
			assert_near(out[k],
				cosine < 0 ? -t.rotation[k] : t.rotation[k],
				1e-6);
		}
	}
}

/* The rotation of a mirrored frame is that of its first two axes. */
static void test_rotation_of_a_mirror_reverses_the_third_axis(void **state)
{
	(void)state;
	for (int i = 0; i < 40; i++) {
		const float scale[3] = {2, 0.5f, 3}, mirror[3] = {2, 0.5f, -3};
		float want[4], got[4];
		mat4 matrix;

		make_matrix(7 * i, scale, matrix);
		matrix_rotation(matrix, want);
		make_matrix(7 * i, mirror, matrix);
		matrix_rotation(matrix, got);
		assert_all_near(got, want, 4, 1e-5);
	}
}

static void test_rotation_without_an_axis_is_the_identity(void **state)
{
	const float identity[4] = {0, 0, 0, 1};

	(void)state;
	for (int i = 0; i < 3; i++) {
		const float scale[3] = {i != 0, i != 1, i != 2};
		float out[4];
		mat4 matrix;

		make_matrix(5, scale, matrix);
		matrix_rotation(matrix, out);
		assert_memory_equal(out, identity, sizeof(out));
	}
}

static void test_the_greatest_scale_is_any_axis_of_any_matrix(void **state)
{
	mat4 matrix[3];

	(void)state;
	for (int i = 0; i < 9; i++) {
		float scale[3] = {0.2f, -0.3f, 0.25f};

		for (int k = 0; k < 3; k++) {
			make_matrix(k, scale, matrix[k]);
		}
		assert_near(matrix_greatest_scale((const mat4 *)matrix, 3), 0.3,
			1e-6);
		scale[i % 3] = -0.7f;
		make_matrix(9, scale, matrix[i / 3]);
		for (int count = 0; count <= 3; count++) {
			assert_near(matrix_greatest_scale(
					    (const mat4 *)matrix, count),
				count == 0              ? 0
					: count > i / 3 ? 0.7
							: 0.3,
				1e-6);
		}
		assert_near(matrix_scale((const mat4 *)matrix[i / 3]),
			i % 3 == 0 ? 0.7 : 0.2, 1e-6);
	}
}

static void test_the_determinant_is_the_product_of_scales(void **state)
{
	static const float scale[][3] = {
		{1, 1, 1}, {2, 3, 5}, {-2, 3, 5}, {2, -3, -5}, {2, 0, 5}};

	(void)state;
	for (int i = 0; i < 5; i++) {
		const float *s = scale[i];
		mat4 matrix;

		make_matrix(4 * i, s, matrix);
		assert_near(matrix_determinant((const mat4 *)matrix),
			(double)(s[0] * s[1] * s[2]), 1e-4);
	}
}

/* Normals keep the size of the matrix, and a line's are still at an angle. */
static void test_normals_have_the_size_of_the_matrix(void **state)
{
	static const float scale[][3] = {{1, 2, 3}, {3, 0.1f, -1}, {1, 0, 2},
		{1, 1e-6f, 2e-6f}, {5e-7f, 1, 1e-6f}, {1e6f, 2e6f, 1e6f},
		{1e-6f, 1e-6f, 3e-6f}};

	(void)state;
	for (int i = 0; i < 7 * 3; i++) {
		double want = 0, got = 0;
		mat4 matrix, normals;

		make_matrix(3 * i, scale[i / 3], matrix);
		matrix_normals((const mat4 *)matrix, (mat4 *)normals);
		for (int k = 0; k < 9; k++) {
			want += pow(matrix[k / 3][k % 3], 2);
			got += pow(normals[k / 3][k % 3], 2);
		}
		assert_near(sqrt(got / want), 1, 1e-5);
		assert_true(normals[3][0] == 0 && normals[3][1] == 0 &&
			normals[3][2] == 0 && normals[3][3] == 1);
	}
}

/* Wherever the one axis lies: all but one are less than 1e-10 of it. */
static void test_matrices_that_all_but_flatten_two_axes_are_copied(void **state)
{
	(void)state;
	for (int i = 0; i < 9; i++) {
		int c = i / 3, r = i % 3;
		mat4 matrix, normals;

		memset(matrix, 0, sizeof(matrix));
		matrix[c][r] = 1;
		matrix[(c + 1) % 3][(r + 1) % 3] = 1e-11f;
		matrix[(c + 2) % 3][(r + 2) % 3] = 1e-11f;
		matrix[3][i % 3] = 5;
		matrix[3][3] = 1;
		matrix_normals((const mat4 *)matrix, (mat4 *)normals);
		assert_memory_equal(normals, matrix, sizeof(matrix));
	}
}

/* Signs and sizes of single elements do not matter, only all together. */
static void test_normals_of_flat_frames_stand_on_the_plane(void **state)
{
	static const float plane[][2] = {
		{1, 1}, {1, -1}, {-1, 1}, {2, 1}, {1, 2}, {3, -2}};

	(void)state;
	for (int i = 0; i < 6 * 3 * 3; i++) {
		const float *p = plane[i / 9];
		int c = i / 3 % 3, d = (c + 1) % 3, e = (c + 2) % 3;
		int r = i % 3, s = (r + 1) % 3, t = (r + 2) % 3;
		mat4 matrix, normals;

		/* Columns c and d lie in the plane of r and s. */
		memset(matrix, 0, sizeof(matrix));
		matrix[c][r] = p[0];
		matrix[c][s] = p[1];
		matrix[d][r] = -p[1];
		matrix[d][s] = p[0];
		matrix[e][t] = 1e-30f;
		matrix[3][3] = 1;
		matrix_normals((const mat4 *)matrix, (mat4 *)normals);
		vec_normalize(normals[e]);
		assert_near(normals[e][r], 0, 1e-6);
		assert_near(normals[e][s], 0, 1e-6);
		assert_near(normals[e][t], 1, 1e-6);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_normals_stay_at_right_angles_to_the_surface),
		cmocka_unit_test(test_an_even_matrix_is_its_own_for_normals),
		cmocka_unit_test(test_uneven_scale_and_shear_are_noticed),
		cmocka_unit_test(test_flat_matrices_keep_the_normal_of_the_plane),
		cmocka_unit_test(test_even_ends_at_1_in_256_for_each_axis),
		cmocka_unit_test(test_a_matrix_that_is_no_number_is_not_even),
		cmocka_unit_test(
			test_rotations_beyond_a_third_of_a_turn_are_found),
		cmocka_unit_test(
			test_rotation_of_a_mirror_reverses_the_third_axis),
		cmocka_unit_test(test_rotation_without_an_axis_is_the_identity),
		cmocka_unit_test(
			test_the_greatest_scale_is_any_axis_of_any_matrix),
		cmocka_unit_test(test_the_determinant_is_the_product_of_scales),
		cmocka_unit_test(test_normals_have_the_size_of_the_matrix),
		cmocka_unit_test(
			test_matrices_that_all_but_flatten_two_axes_are_copied),
		cmocka_unit_test(test_normals_of_flat_frames_stand_on_the_plane),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
