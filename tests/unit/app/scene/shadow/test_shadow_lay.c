/* Points laid along the light upon a plane, where each place is known exactly. */
#include "app/anim/math/vec.h"
#include "app/scene/shadow/shadow_lay.h"
#include "tests/support/test.h"

#include <math.h>

enum {
	NODES = SHADOW_RELIEF_NODES,
	POINTS_MAX = 2 * SHADOW_NODES_MAX
};

/* y = HEIGHT + rise[0] * x + rise[1] * z, whose mean height is MEAN */
struct plane {
	float rise[2];
	float height[NODES][NODES];
	struct shadow_relief relief;
};

static const float towards[3] = {0.48f, 0.8f, 0.36f};

/* The nodes begin at (-20, -30). */
static void make_plane(
	struct plane *plane, float cell_x, float cell_z, float x, float z)
{
	plane->rise[0] = x;
	plane->rise[1] = z;
	plane->relief = (struct shadow_relief){.low = {-20, -30},
		.cell = {cell_x, cell_z},
		.y = 1,
		.height = plane->height};
	for (int row = 0; row < NODES; row++) {
		for (int column = 0; column < NODES; column++) {
			plane->height[row][column] = 1 +
				x * (cell_x * (float)column - 20) +
				z * (cell_z * (float)row - 30);
		}
	}
}

/* Rows of per_row points at the height 3. */
static void make_points(
	float (*point)[3], int count, int per_row, float step_x, float step_z)
{
	for (int i = 0; i < count; i++) {
		point[i][0] = step_x * (float)(i % per_row);
		point[i][1] = 3;
		point[i][2] = step_z * (float)(i / per_row);
	}
}

/* Where the light through a point meets the plane. */
static void meet(const struct plane *plane, const float from[3], float out[3])
{
	float above = from[1] - 1 - plane->rise[0] * from[0] -
		plane->rise[1] * from[2];
	float fall = towards[1] - plane->rise[0] * towards[0] -
		plane->rise[1] * towards[2];

	vec_add_scaled(from, towards, -above / fall, out);
}

static float distance_to_line(
	const float at[3], const float a[3], const float b[3])
{
	float along[3], to[3], across[3];

	vec_subtract(b, a, along);
	vec_subtract(at, a, to);
	vec_cross(along, to, across);
	return vec_length(across) / vec_length(along);
}

/* Lays the points, and returns the number of the grid's nodes. */
static int lay(const struct plane *plane, const float (*from)[3], int count,
	float (*to)[3])
{
	static float node[SHADOW_NODES_MAX][3];
	const struct shadow_light light = {
		.towards = {towards[0], towards[1], towards[2]},
		.eye = {2, 8, 9},
		.relief = &plane->relief};
	struct shadow_grid grid = {.node = node, .node_count = -1};
	struct bounds box = bounds_empty();

	shadow_lay(&grid, &light, from, count, to, &box);
	return grid.node_count;
}

static void check_places(const struct plane *plane, const float (*from)[3],
	int count, const float (*to)[3], float tolerance)
{
	static const float eye[3] = {2, 8, 9};

	for (int i = 0; i < count; i++) {
		float at[3], away[3];

		meet(plane, from[i], at);
		vec_subtract(at, eye, away);
		assert_near(distance_to_line(to[i], eye, at), 0, tolerance);
		vec_subtract(to[i], at, away);
		assert_true(vec_length(away) < 0.15f);
	}
}

/* Along the light a plane rises evenly: one step of the secant method is exact. */
static void test_a_point_meets_a_plane_exactly(void **state)
{
	static const float rise[5][2] = {{0, 0}, {0.5f, 0.25f}, {-0.5f, 0.25f},
		{0.25f, -1}, {-1, -0.5f}};
	const float from[2][3] = {{1, 3, 2}, {-2, 2.5f, 0.5f}};

	(void)state;
	for (int i = 0; i < 5; i++) {
		static struct plane plane;
		float to[2][3];

		make_plane(&plane, 1, 1, rise[i][0], rise[i][1]);
		assert_int_equal(lay(&plane, from, 2, to), 0);
		check_places(&plane, from, 2, (const float(*)[3])to, 1e-4f);
	}
}

/*
 * Where the ground is nearly as steep as the light, or falls away steeply, the
 * step is that of ground which the light nears by half of its own fall, or by
 * 2, per unit of its way.
 */
static void test_steep_ground_does_not_send_a_point_far_away(void **state)
{
	/* The light would near the ground by 0.8 - 0.48 * rise: 0.22 and 2.24. */
	static const struct {
		float rise, nears;
	} kinds[2] = {{1.2f, 0.4f}, {-3.0f, 2.0f}};

	(void)state;
	for (int i = 0; i < 2; i++) {
		static struct plane plane;
		const float from[1][3] = {{1, 3, 2}};
		float level = 2 / 0.8f, guess, height[2], at[3], to[1][3];

		make_plane(&plane, 1, 1, kinds[i].rise, 0);
		height[0] = 1 + kinds[i].rise * (1 - 0.48f * level);
		guess = (3 - height[0]) / 0.8f;
		height[1] = 1 + kinds[i].rise * (1 - 0.48f * guess);
		vec_add_scaled(from[0], towards,
			(height[1] - height[0]) / kinds[i].nears - guess, at);
		lay(&plane, from, 1, to);
		assert_near(distance_to_line(to[0], (float[3]){2, 8, 9}, at), 0,
			1e-4);
	}
}

/* Nodes are as near each other as those of the ground are on its finer side. */
static void test_a_grid_has_the_nodes_that_the_area_needs(void **state)
{
	static const float cell[3][2] = {{0.5f, 0.5f}, {0.5f, 2}, {2, 0.5f}};
	static float from[POINTS_MAX][3], to[POINTS_MAX][3];

	(void)state;
	for (int i = 0; i < 3; i++) {
		static struct plane plane;

		make_plane(&plane, cell[i][0], cell[i][1], 0.25f, -0.125f);
		/* 2.85 x 1.35 units are 5 and 2 whole steps and a part. */
		make_points(from, 200, 20, 0.15f, 0.15f);
		assert_int_equal(lay(&plane, from, 200, to), 7 * 4);
		check_places(&plane, from, 200, (const float(*)[3])to, 2e-3f);
	}
}

/* A node takes as long as two points: so few points need no grid. */
static void test_a_grid_is_made_for_two_points_a_node(void **state)
{
	static struct plane plane;
	static float from[POINTS_MAX][3], to[POINTS_MAX][3];

	(void)state;
	make_plane(&plane, 0.5f, 0.5f, 0.25f, -0.125f);
	/* 1.4 x 0.7 units: 4 x 3 nodes */
	make_points(from, 24, 8, 0.2f, 0.35f);
	assert_int_equal(lay(&plane, from, 24, to), 4 * 3);
	check_places(&plane, from, 24, (const float(*)[3])to, 2e-3f);
	assert_int_equal(lay(&plane, from, 23, to), 0);
	check_places(&plane, from, 23, (const float(*)[3])to, 1e-4f);
}

static void test_a_grid_has_as_many_nodes_as_there_is_memory_for(void **state)
{
	static struct plane plane;
	static float from[POINTS_MAX][3], to[POINTS_MAX][3];

	(void)state;
	make_plane(&plane, 0.5f, 0.5f, 0, 0);
	/* 15.25 x 15.25 units: 32 x 32 nodes */
	make_points(from, POINTS_MAX, 2, 15.25f, 15.25f / 1023);
	assert_int_equal(lay(&plane, from, POINTS_MAX, to), SHADOW_NODES_MAX);
	check_places(&plane, from, POINTS_MAX, (const float(*)[3])to, 2e-3f);
	make_points(from, POINTS_MAX, 2, 15.75f, 15.25f / 1023);
	assert_int_equal(lay(&plane, from, POINTS_MAX, to), 0);
	/* 2 x 1000 nodes would be too many, and 2 x 1e8 are. */
	make_points(from, POINTS_MAX, 2, 0.25f, 0.5f);
	assert_int_equal(lay(&plane, from, POINTS_MAX, to), 0);
	make_points(from, POINTS_MAX, 2, 0.25f, 5e4f);
	assert_int_equal(lay(&plane, from, POINTS_MAX, to), 0);
}

static void test_a_point_that_is_no_number_leaves_the_others(void **state)
{
	static struct plane plane;
	static float from[POINTS_MAX][3], to[POINTS_MAX][3];

	(void)state;
	make_plane(&plane, 0.5f, 0.5f, 0.25f, -0.125f);
	make_points(from, 200, 20, 0.15f, 0.15f);
	for (int axis = 0; axis < 3; axis += 2) {
		from[7][axis] = NAN;
		assert_int_equal(lay(&plane, from, 200, to), 0);
		check_places(&plane, from, 7, (const float(*)[3])to, 1e-4f);
		check_places(&plane, from + 8, 192, (const float(*)[3])(to + 8),
			1e-4f);
		from[7][axis] = 0;
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_point_meets_a_plane_exactly),
		cmocka_unit_test(
			test_steep_ground_does_not_send_a_point_far_away),
		cmocka_unit_test(test_a_grid_has_the_nodes_that_the_area_needs),
		cmocka_unit_test(test_a_grid_is_made_for_two_points_a_node),
		cmocka_unit_test(
			test_a_grid_has_as_many_nodes_as_there_is_memory_for),
		cmocka_unit_test(
			test_a_point_that_is_no_number_leaves_the_others),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
