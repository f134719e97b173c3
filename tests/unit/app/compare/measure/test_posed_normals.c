/* The matrix of normals against cofactors that determinants define. */
#include "app/compare/measure/posed_vertices.h"
#include "tests/support/test.h"

#include <cglm/cglm.h>

/* The determinant of three columns, row by row. */
static double determinant(double m[3][3])
{
	return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
		m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
		m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

/*
 * What posed_vertices.h promises: the determinant with one entry's row and
 * column replaced by unit vectors, times the sign of the whole determinant.
 */
static double cofactor(double m[3][3], int column, int row)
{
	double changed[3][3], sign = determinant(m) < 0 ? -1 : 1;

	for (int c = 0; c < 3; c++) {
		for (int r = 0; r < 3; r++) {
			bool crossed = c == column || r == row;

			changed[c][r] =
				!crossed ? m[c][r] : c == column && r == row;
		}
	}
	return sign * determinant(changed);
}

/* Entries are -1, 0 and 1, so that all sums are exact: all 19683 matrices. */
static void test_normals_follow_any_matrix(void **state)
{
	int flat = 0, mirrored = 0;

	(void)state;
	for (int number = 0; number < 19683; number++) {
		mat4 world = GLM_MAT4_IDENTITY_INIT;
		double m[3][3];
		mat3 found;
		int rest = number;

		for (int i = 0; i < 9; i++) {
			m[i / 3][i % 3] = rest % 3 - 1;
			world[i / 3][i % 3] = (float)(rest % 3 - 1);
			rest /= 3;
		}
		flat += determinant(m) == 0;
		mirrored += determinant(m) < 0;
		posed_vertices_normal_matrix((const vec4 *)world, found);
		for (int i = 0; i < 9; i++) {
			assert_near(found[i / 3][i % 3],
				cofactor(m, i / 3, i % 3), 0.0);
		}
	}
	assert_true(flat > 0 && mirrored > 0);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_normals_follow_any_matrix),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
