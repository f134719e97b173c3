/* What a picture costs, from what it consists of. */
#include "app/compare/cost/board_cost.h"
#include "tests/support/test.h"

#include <stddef.h>

static const double pixels = 1000.0;

/* Beyond an empty picture. */
static void expect_cost(
	const struct gl_counts *counts, double cycles, double instructions)
{
	const struct gl_counts none = {0};
	struct board_cost empty = board_cost_draw(&none, 0.0);
	struct board_cost cost = board_cost_draw(counts, 0.0);

	assert_near(cost.cycles - empty.cycles, cycles, 1e-4);
	assert_near(cost.instructions - empty.instructions, instructions, 1e-4);
}

static void test_an_empty_picture_costs_its_frame_and_pixels(void **state)
{
	const struct gl_counts none = {0};
	struct board_cost cost = board_cost_draw(&none, pixels);

	(void)state;
	assert_near(cost.cycles, 31760.0 + 793.4, 1e-6);
	assert_near(cost.instructions, 21830.0 + 369.5, 1e-6);
}

/* As `make bench-draw-fit` has written the table last. */
static void test_each_piece_of_work_has_the_fitted_cost(void **state)
{
	static const struct {
		size_t place;
		double cycles, instructions;
	} pieces[] = {
		{offsetof(struct gl_counts, calls), 16000.0, 5574.0},
		{offsetof(struct gl_counts, listed), 162.9, 80.17},
		{offsetof(struct gl_counts, vertices), 346.8, 66.72},
		{offsetof(struct gl_counts, single), 310.3, 132.3},
		{offsetof(struct gl_counts, shaded), 237.7, 235.0},
		{offsetof(struct gl_counts, hidden), 15.56, 14.56},
		{offsetof(struct gl_counts, skipped), 1181.0, 435.2},
		{offsetof(struct gl_counts, fine), 4.797, 3.191},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(pieces) / sizeof(pieces[0]); i++) {
		struct gl_counts counts = {0};

		*(double *)(void *)((char *)&counts + pieces[i].place) = 100.0;
		expect_cost(&counts, 100.0 * pieces[i].cycles,
			100.0 * pieces[i].instructions);
	}
}

/*
 * The same of triangles, their rows and pixels: the table's 51 other rows, each
 * times its number.
 */
static void test_each_kind_of_triangle_has_the_fitted_cost(void **state)
{
	struct gl_counts counts = {0};

	(void)state;
	for (int i = 0; i < GL_WORK_KINDS; i++) {
		counts.work[i] = (struct gl_work){
			3.0 * i + 1.0, 3.0 * i + 2.0, 3.0 * i + 3.0};
	}
	expect_cost(&counts, 1973427.176, 1008403.1346);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_an_empty_picture_costs_its_frame_and_pixels),
		cmocka_unit_test(test_each_piece_of_work_has_the_fitted_cost),
		cmocka_unit_test(test_each_kind_of_triangle_has_the_fitted_cost),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
