/* When the advice is to play each clip by a technique of its own. */
#include "app/compare/advice.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/advice_bench.h"

/* Each of two rows is cheap for one clip and dear for the other one. */
static void cross(struct bench *bench, double cheap_us, double dear_us)
{
	double mean_us = 0.5 * (cheap_us + dear_us);

	begin(bench);
	for (int r = 0; r < 2; r++) {
		struct comparison_row *row = add(bench, mean_us, 10, 0.0f);

		for (int c = 0; c < CLIPS; c++) {
			set_cell(&row->cell[c], r == c ? cheap_us : dear_us);
			row->cell[c].bytes.own = 1024;
			row->cell[c].bytes.shared = 8 * 1024;
		}
	}
}

static void test_a_mixed_plan_must_save_a_hundredth_of_the_frame(void **state)
{
	struct bench bench;

	(void)state;
	/* It takes 8 KiB more, so it must save 900 us in the mean. */
	cross(&bench, 1000, 2790);
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	assert_int_equal(bench.comparison.mixed_bytes, 10 * 1024);
	assert_near(bench.comparison.mixed_us, 1895.0, 1e-6);
	/* Then all clips have the row that is advised, whatever was tried. */
	bench.comparison.row[1].total.board.cycles = ARM11_MHZ * 1800.0;
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	assert_int_equal(bench.comparison.advised, 1);
	assert_int_equal(bench.comparison.clip[0].row, 1);
	assert_int_equal(bench.comparison.clip[1].row, 1);
	cross(&bench, 1000, 2800);
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	cross(&bench, 1000, 2810);
	advice_give(&bench.comparison);
	assert_true(bench.comparison.mixed);
	assert_int_equal(bench.comparison.clip[0].row, 0);
	assert_int_equal(bench.comparison.clip[1].row, 1);
	assert_int_equal(bench.comparison.mixed_bytes, 18 * 1024);
	assert_near(bench.comparison.mixed_us, 1000.0, 1e-6);
}

/* Alone, each row is too inexact, too slow or not listed for one clip. */
static void test_a_mixed_plan_keeps_the_limits_in_each_clip(void **state)
{
	struct bench bench;

	(void)state;
	cross(&bench, 1000, 1000);
	for (int r = 0; r < 2; r++) {
		bench.comparison.row[r].total.peak_px = 3.0f;
		bench.comparison.row[r].cell[1 - r].error.peak_px = 3.0f;
		bench.comparison.row[r].cell[r].error.peak_px = 2.0f;
	}
	bench.comparison.request.memory_bytes = 18 * 1024;
	advice_give(&bench.comparison);
	assert_true(bench.comparison.mixed);
	assert_int_equal(bench.comparison.clip[0].row, 0);
	assert_int_equal(bench.comparison.clip[1].row, 1);
	bench.comparison.mixed = false;
	bench.comparison.request.memory_bytes = 18 * 1024 - 1;
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	bench.comparison.request.memory_bytes = 0;
	bench.comparison.row[0].cell[0].error.peak_px = 3.0f;
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	bench.comparison.row[0].cell[0].error.peak_px = 0.0f;
	bench.comparison.row[1].listed = false;
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
	/* A prediction may be 2% above the limit of time. */
	cross(&bench, 1019, 10100);
	bench.comparison.request.frame_ms = 1.0;
	advice_give(&bench.comparison);
	assert_true(bench.comparison.mixed);
	cross(&bench, 1021, 10100);
	bench.comparison.request.frame_ms = 1.0;
	advice_give(&bench.comparison);
	assert_false(bench.comparison.mixed);
}

/* Begins with these times of each row's clips, and 8 KiB that a row's clips share. */
static void begin_plans(
	struct bench *bench, int rows, int clips, const double us[][CLIPS_MOST])
{
	begin(bench);
	bench->comparison.clip_count = clips;
	for (int r = 0; r < rows; r++) {
		struct comparison_row *row = add(bench, 1.0, 8 + clips, 0.0f);
		double sum_us = 0.0;

		for (int c = 0; c < clips; c++) {
			sum_us += us[r][c];
			set_cell(&row->cell[c], us[r][c]);
			row->cell[c].bytes.own = 1024;
			row->cell[c].bytes.shared = 8 * 1024;
		}
		row->total.board.cycles = (double)ARM11_MHZ * sum_us / clips;
	}
}

static void expect_plan(struct bench *bench, const int *row)
{
	advice_give(&bench->comparison);
	assert_true(bench->comparison.mixed);
	for (int c = 0; c < bench->comparison.clip_count; c++) {
		assert_int_equal(bench->comparison.clip[c].row, row[c]);
	}
}

/*
 * The last two clips are faster in row 1 only together, as its shared bytes are then
 * paid once. So the way to this plan is from row 1, and changes the first clip.
 */
static void test_a_mixed_plan_may_begin_with_a_row_that_is_dear_alone(
	void **state)
{
	static const double us[2][CLIPS_MOST] = {
		{1000, 4000, 4000}, {9000, 2500, 2500}};
	struct bench bench;

	(void)state;
	begin_plans(&bench, 2, 3, us);
	expect_plan(&bench, (const int[]){0, 1, 1});
	assert_int_equal(bench.comparison.advised, 0);
	assert_int_equal(bench.comparison.mixed_bytes, 19 * 1024);
	assert_near(bench.comparison.mixed_us, 2000.0, 1e-6);
}

/*
 * In row 0 the last two clips are faster only together. From there, the second
 * clip gets row 1, after which the first one gains by it, too.
 */
static void test_a_mixed_plan_is_improved_until_nothing_changes(void **state)
{
	static const double us[2][CLIPS_MOST] = {
		{4000, 8000, 1000, 1000}, {2000, 1000, 3500, 3500}};
	struct bench bench;

	(void)state;
	begin_plans(&bench, 2, 4, us);
	expect_plan(&bench, (const int[]){1, 1, 0, 0});
	assert_near(bench.comparison.mixed_us, 1250.0, 1e-6);
}

/* Rows and clips beyond the last one count for nothing. */
static void test_a_mixed_plan_has_the_first_of_equal_rows(void **state)
{
	static const double us[4][CLIPS_MOST] = {
		{1000, 9000}, {9000, 1000}, {9000, 1000}, {1, 1}};
	struct bench bench;

	(void)state;
	begin_plans(&bench, 4, 2, us);
	bench.comparison.row_count = 3;
	bench.clip[2].row = -1;
	expect_plan(&bench, (const int[]){0, 1});
	assert_int_equal(bench.clip[2].row, -1);
}

/* A morph with 3 keys in one clip and 5 in the other one, which is dearer. */
static void test_a_plan_has_the_weights_of_the_keys_that_it_plays(void **state)
{
	static const double us[2][CLIPS_MOST] = {{1000, 9000}, {9000, 1000}};
	struct bench bench;

	(void)state;
	begin_plans(&bench, 2, 2, us);
	bench.cell[0][0].keys.count = 3;
	bench.cell[0][1].keys.count = 5;
	expect_plan(&bench, (const int[]){0, 1});
	assert_int_equal(bench.comparison.mixed_bytes,
		18 * 1024 + 3 * 3 * (int)sizeof(float));
	/* With a weight for 8 keys at each of 8, the whole row has its total. */
	bench.comparison.row[1].listed = false;
	bench.comparison.row[0].total.memory_bytes = 10 * 1024 + 8 * 8 * 4;
	advice_give(&bench.comparison);
	assert_int_equal(bench.comparison.mixed_bytes,
		bench.comparison.row[0].total.memory_bytes);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_mixed_plan_must_save_a_hundredth_of_the_frame),
		cmocka_unit_test(test_a_mixed_plan_keeps_the_limits_in_each_clip),
		cmocka_unit_test(
			test_a_mixed_plan_may_begin_with_a_row_that_is_dear_alone),
		cmocka_unit_test(
			test_a_mixed_plan_is_improved_until_nothing_changes),
		cmocka_unit_test(test_a_mixed_plan_has_the_first_of_equal_rows),
		cmocka_unit_test(
			test_a_plan_has_the_weights_of_the_keys_that_it_plays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
