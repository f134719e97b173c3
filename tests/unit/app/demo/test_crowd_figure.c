/* Where a model of any size stands in the crowd. */
#include "app/demo/crowd/crowd_figure.h"
#include "tests/support/test.h"

#include <math.h>

static void transform(mat4 matrix, const float at[3], float out[3])
{
	for (int row = 0; row < 3; row++) {
		out[row] = matrix[3][row];
		for (int k = 0; k < 3; k++) {
			out[row] += matrix[k][row] * at[k];
		}
	}
}

static const struct crowd_figure figure = {
	.scale = 0.5f, .center = {3, 1, -2}, .front_rad = 0.25f};
static const struct crowd_route route = {.size = 1.5f};
static const struct crowd_position position = {
	.x = 4, .z = 5, .yaw_rad = 1.0f, .lean_rad = 0.125f};
static const float drift[2] = {0.75f, -0.5f};

static void test_the_figures_middle_stands_on_its_route(void **state)
{
	const float middle[3] = {3.75f, 1, -2.5f};
	float at[3];
	mat4 matrix;

	(void)state;
	crowd_figure_matrix(&figure, &route, &position, drift, matrix);
	transform(matrix, middle, at);
	assert_all_near(at, ((float[]){4, 0, 5}), 3, 1e-5);
}

static void test_the_figure_looks_along_its_route_in_its_size(void **state)
{
	/* A unit before its middle, where it looks. */
	const float before[3] = {3.75f + sinf(0.25f), 1, -2.5f + cosf(0.25f)};
	struct crowd_position upright = position;
	float at[3];
	mat4 matrix;

	(void)state;
	upright.lean_rad = 0;
	crowd_figure_matrix(&figure, &route, &upright, drift, matrix);
	transform(matrix, before, at);
	assert_all_near(at,
		((float[]){4 + 0.75f * sinf(1.0f), 0, 5 + 0.75f * cosf(1.0f)}),
		3, 1e-5);
}

/* Its head leans to its own left; nothing but the place has a fourth row. */
static void test_a_figure_leans_before_it_turns(void **state)
{
	const float s = 1.5f, cy = cosf(1.0f), sy = sinf(1.0f);
	const float cl = cosf(0.125f), sl = sinf(0.125f);
	const float expected[4][4] = {{s * cl * cy, s * -sl, s * -cl * sy, 0},
		{s * sl * cy, s * cl, s * -sl * sy, 0}, {s * sy, 0, s * cy, 0},
		{4, 0, 5, 1}};
	mat4 matrix;

	(void)state;
	crowd_matrix(&route, &position, matrix);
	assert_all_near(matrix, expected, 16, 1e-6);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_the_figures_middle_stands_on_its_route),
		cmocka_unit_test(test_a_figure_leans_before_it_turns),
		cmocka_unit_test(
			test_the_figure_looks_along_its_route_in_its_size),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
