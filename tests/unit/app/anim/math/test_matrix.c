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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_normals_stay_at_right_angles_to_the_surface),
		cmocka_unit_test(test_an_even_matrix_is_its_own_for_normals),
		cmocka_unit_test(test_uneven_scale_and_shear_are_noticed),
		cmocka_unit_test(test_flat_matrices_keep_the_normal_of_the_plane),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
