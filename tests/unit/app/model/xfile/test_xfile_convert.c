/* From Direct3D's left-handed space, and matrices with six decimals. */
#include "app/model/xfile/xfile_convert.h"
#include "tests/support/test.h"

#include <cglm/mat4.h>
#include <math.h>

/* Scales of which another one is the largest, and a bend of one column. */
static bool is_decomposed(int largest, int column, int row, float bend)
{
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;
	struct transform out;

	matrix[largest][largest] = 3.0f;
	matrix[column][row] += bend;
	return xfile_decompose(matrix, &out);
}

/* Less than a ten thousandth of the largest scale is no shear. */
static void test_a_small_error_of_any_element_is_no_shear(void **state)
{
	(void)state;
	for (int i = 0; i < 27; i++) {
		int largest = i / 9, column = i / 3 % 3, row = i % 3;

		if (row == column) {
			continue;
		}
		for (int sign = -1; sign <= 1; sign += 2) {
			assert_true(is_decomposed(
				largest, column, row, (float)sign * 2.5e-4f));
			assert_false(is_decomposed(
				largest, column, row, (float)sign * 4e-3f));
		}
	}
}

static void test_scales_and_translations_are_decomposed(void **state)
{
	mat4 matrix = GLM_MAT4_IDENTITY_INIT;
	struct transform out;

	(void)state;
	for (int i = 0; i < 3; i++) {
		matrix[i][i] = 2.0f + (float)i;
		matrix[3][i] = 7.0f - (float)i;
	}
	assert_true(xfile_decompose(matrix, &out));
	assert_all_near(out.scale, ((const float[]){2, 3, 4}), 3, 1e-6);
	assert_all_near(out.translation, ((const float[]){7, 6, 5}), 3, 0.0);
	assert_all_near(out.rotation, ((const float[]){0, 0, 0, 1}), 4, 1e-6);
}

/* Each number has its place; what is not affine is left out. */
static void test_matrices_are_mirrored_along_z(void **state)
{
	static const float in[16] = {
		1, 2, 3, 90, 4, 5, 6, 91, 7, 8, 9, 92, 10, 11, 12, 93};
	static const float wanted[16] = {
		1, 2, -3, 0, 4, 5, -6, 0, -7, -8, 9, 0, 10, 11, -12, 1};
	mat4 out;

	(void)state;
	xfile_convert_matrix(in, out);
	assert_all_near(out[0], wanted, 16, 0.0);
}

/* z changes its sign, and so do turns about x and y: the opposite ones. */
static void test_rotations_are_mirrored_and_normalised(void **state)
{
	static const float wxyz[][4] = {{2, 0, 0, 0}, {1, 1, 0, 0},
		{1, 0, -1, 0}, {3, 0, 0, 4}, {1, -1, 1, -1}, {0, 0, 0, -5}};
	const float half = sqrtf(0.5f);
	const float wanted[][4] = {{0, 0, 0, 1}, {half, 0, 0, half},
		{0, -half, 0, half}, {0, 0, -0.8f, 0.6f},
		{-0.5f, 0.5f, 0.5f, 0.5f}, {0, 0, 1, 0}};

	(void)state;
	for (size_t i = 0; i < sizeof(wxyz) / sizeof(wxyz[0]); i++) {
		float out[4];

		xfile_convert_rotation(wxyz[i], out);
		assert_all_near(out, wanted[i], 4, 1e-6);
	}
}

static void test_a_rotation_of_zeros_is_none(void **state)
{
	static const float zeros[4];
	float out[4];

	(void)state;
	xfile_convert_rotation(zeros, out);
	assert_all_near(out, ((const float[]){0, 0, 0, 1}), 4, 0.0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_small_error_of_any_element_is_no_shear),
		cmocka_unit_test(test_scales_and_translations_are_decomposed),
		cmocka_unit_test(test_matrices_are_mirrored_along_z),
		cmocka_unit_test(test_rotations_are_mirrored_and_normalised),
		cmocka_unit_test(test_a_rotation_of_zeros_is_none),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
