/* Matrices taken apart into translation, rotation and scale. */
#include "app/model/transform_decompose.h"
#include "tests/support/random.h"
#include "tests/support/test.h"

#include <math.h>
#include <string.h>

enum {
	TRIALS = 300
};

static double between(uint32_t *seed, double low, double high)
{
	return low + (high - low) * random_between(seed, 0, 10000) / 10000.0;
}

/* Column by column: where the rotation takes the axes. */
static void axes_of(const float q[4], double axis[3][3])
{
	double x = (double)q[0], y = (double)q[1], z = (double)q[2],
	       w = (double)q[3];
	const double columns[3][3] = {
		{1 - 2 * (y * y + z * z), 2 * (x * y + z * w),
			2 * (x * z - y * w)},
		{2 * (x * y - z * w), 1 - 2 * (x * x + z * z),
			2 * (y * z + x * w)},
		{2 * (x * z + y * w), 2 * (y * z - x * w),
			1 - 2 * (x * x + y * y)}};

	memcpy(axis, columns, sizeof(columns));
}

static void random_rotation(uint32_t *seed, float q[4])
{
	double length = 0.0;

	for (int i = 0; i < 4; i++) {
		q[i] = (float)between(seed, -1.0, 1.0);
		length += (double)q[i] * (double)q[i];
	}
	for (int i = 0; i < 4; i++) {
		q[i] = (float)((double)q[i] / sqrt(length));
	}
}

static void compose(const struct transform *from, float matrix[4][4])
{
	double axis[3][3];

	axes_of(from->rotation, axis);
	memset(matrix, 0, sizeof(float[4][4]));
	for (int i = 0; i < 9; i++) {
		matrix[i / 3][i % 3] =
			(float)(axis[i / 3][i % 3] * (double)from->scale[i / 3]);
	}
	memcpy(matrix[3], from->translation, sizeof(from->translation));
	matrix[3][3] = 1.0f;
}

static void expect_product(const struct transform *found,
	const float matrix[4][4], double tolerance)
{
	float again[4][4];

	compose(found, again);
	assert_all_near(again, matrix, 16, tolerance);
}

/* Columns of very different lengths, each of them the longest in turn. */
static void test_products_are_found_again(void **state)
{
	uint32_t seed = 3;

	(void)state;
	for (int trial = 0; trial < TRIALS; trial++) {
		struct transform made = {.translation = {1, -2, 3}}, found;
		float matrix[4][4];

		random_rotation(&seed, made.rotation);
		for (int i = 0; i < 3; i++) {
			made.scale[i] = (float)between(
				&seed, 0.01, i == trial % 3 ? 10.0 : 1.0);
		}
		compose(&made, matrix);
		assert_true(
			transform_decompose((const float(*)[4])matrix, &found));
		expect_product(&found, (const float(*)[4])matrix, 1e-4);
		assert_all_near(found.scale, made.scale, 3, 1e-4);
		assert_all_near(found.translation, made.translation, 3, 0.0);
	}
}

static void test_a_mirror_has_a_negative_x_scale(void **state)
{
	uint32_t seed = 5;

	(void)state;
	for (int mirrored = 0; mirrored < 3; mirrored++) {
		struct transform made = {.scale = {2.0f, 3.0f, 4.0f}}, found;
		float matrix[4][4];

		random_rotation(&seed, made.rotation);
		made.scale[mirrored] *= -1.0f;
		compose(&made, matrix);
		assert_true(
			transform_decompose((const float(*)[4])matrix, &found));
		expect_product(&found, (const float(*)[4])matrix, 1e-4);
		assert_near(found.scale[0], -2.0, 1e-4);
		assert_near(found.scale[1], 3.0, 1e-4);
		assert_near(found.scale[2], 4.0, 1e-4);
	}
}

/* A shear bends the shorter columns; the longest keeps its direction. */
static void test_a_sheared_matrix_keeps_its_longest_column(void **state)
{
	(void)state;
	for (int longest = 0; longest < 3; longest++) {
		for (int bent = 0; bent < 3; bent++) {
			float matrix[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0},
				{0, 0, 1, 0}, {5, 6, 7, 1}};
			struct transform found;
			double axis[3][3];

			for (int i = 0; i < 3; i++) {
				matrix[longest][i] *= 3.0f;
			}
			/* Towards the next axis. */
			matrix[bent][(bent + 1) % 3] += 0.5f;
			assert_false(transform_decompose(
				(const float(*)[4])matrix, &found));
			axes_of(found.rotation, axis);
			for (int i = 0; i < 3; i++) {
				double length = sqrt((double)(matrix[longest][0] *
						matrix[longest][0] +
					matrix[longest][1] * matrix[longest][1] +
					matrix[longest][2] * matrix[longest][2]));

				assert_near(axis[longest][i],
					(double)matrix[longest][i] / length,
					1e-6);
			}
		}
	}
}

/* Two flat columns leave a rotation that has the third, and none has any. */
static void test_flat_matrices_have_a_rotation(void **state)
{
	(void)state;
	for (int flat = 0; flat < 8; flat++) {
		struct transform made = {.rotation = {0.5f, -0.5f, 0.5f, 0.5f},
			.scale = {2.0f, 3.0f, 4.0f}};
		struct transform found;
		float matrix[4][4];
		double length = 0.0;

		for (int i = 0; i < 3; i++) {
			made.scale[i] = flat >> i & 1 ? 0.0f : made.scale[i];
		}
		compose(&made, matrix);
		assert_true(
			transform_decompose((const float(*)[4])matrix, &found));
		for (int i = 0; i < 4; i++) {
			length += (double)found.rotation[i] *
				(double)found.rotation[i];
		}
		assert_near(length, 1.0, 1e-6);
		expect_product(&found, (const float(*)[4])matrix, 1e-4);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_products_are_found_again),
		cmocka_unit_test(test_a_mirror_has_a_negative_x_scale),
		cmocka_unit_test(test_a_sheared_matrix_keeps_its_longest_column),
		cmocka_unit_test(test_flat_matrices_have_a_rotation),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
