/* The rule of the advice, on comparisons whose figures the tests make up. */
#include "app/anim/kernel/arm11_cost.h"
#include "app/compare/advice.h"
#include "tests/support/test.h"

#include <stdio.h>
#include <string.h>

enum {
	CLIPS = 2,
	CLIPS_MOST = 4,
	ROWS = 4
};

/* 100 us are a hundredth of the frame, and so are 1024 bytes. */
static const struct board_profile board = {
	.name = "test",
	.ram_bytes = 900000,
	.taken_bytes = 500000,
	.frame_ms = 10.0,
	.bytes_per_percent = 1024,
};

struct bench {
	struct comparison comparison;
	struct comparison_clip clip[CLIPS_MOST];
	struct comparison_cell cell[ROWS][CLIPS_MOST];
};

static void begin(struct bench *bench)
{
	*bench = (struct bench){
		.comparison = {.request = {.clip = -1,
				       .bound_px = 2.0f,
				       .board = &board},
			.clip_count = CLIPS,
			.clip = bench->clip},
	};
}

/* Measured costs contradict the predicted ones, which have to count. */
static void set_cell(struct comparison_cell *cell, double us)
{
	cell->time.frame_us = 1e6 / us;
	cell->time.instructions = 1e9 / us;
	cell->board.vertices.cycles = (double)ARM11_MHZ * us;
}

/* Adds a row that is listed, whose clips all cost the same. */
static struct comparison_row *add(
	struct bench *bench, double us, double kib, float peak_px)
{
	struct comparison *comparison = &bench->comparison;
	int number = comparison->row_count++;
	struct comparison_row *row = &comparison->row[number];

	snprintf(row->name, sizeof(row->name), "row %d", number);
	row->listed = true;
	row->cell = bench->cell[number];
	row->total = (struct comparison_total){
		.peak_px = peak_px,
		.frame_us = 1e6 / us,
		.instructions = 1e9 / us,
		.board = {.cycles = (double)ARM11_MHZ * us},
		.memory_bytes = (size_t)(1024.0 * kib + 0.5),
	};
	for (int c = 0; c < CLIPS; c++) {
		set_cell(&row->cell[c], us);
		row->cell[c].error.peak_px = peak_px;
		row->cell[c].bytes.own = row->total.memory_bytes / CLIPS;
	}
	return row;
}

static void expect(struct bench *bench, int advised, const char *reason)
{
	advice_give(&bench->comparison);
	assert_int_equal(bench->comparison.advised, advised);
	assert_string_equal(bench->comparison.reason, reason);
}

static void test_a_third_of_a_percent_is_worth_converting_the_model(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 971, 10, 1.0f);
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; \"row 1\" would save 29 us, which "
		"is 0.29% of a frame of 10.0 ms and too little to convert the "
		"model for");
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 969, 10, 1.0f);
	/* Among conversions, the slightest difference decides. */
	add(&bench, 968, 10, 1.0f);
	add(&bench, 968.5, 10, 1.0f);
	expect(&bench, 2,
		"it takes 968 us and 10 KiB; nothing that keeps within 2 px is "
		"faster or smaller; \"row 3\" takes 968 us and 10 KiB");
}

static void test_memory_has_the_price_that_the_board_gives_it(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 500, 14, 1.0f);
	expect(&bench, 1,
		"it takes 500 us and 14 KiB; \"row 0\" would save 4 KiB but "
		"take 500 us more, which is 5.0% of a frame of 10.0 ms, where "
		"1% is worth 1 KiB");
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 500, 16, 1.0f);
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; \"row 1\" would save 500 us, "
		"which is 5.0% of a frame of 10.0 ms, but take 6 KiB more, "
		"where 1% is worth 1 KiB");
}

static void test_small_figures_have_digits_behind_the_point(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 9.5, 0.0f);
	add(&bench, 994, 11.5, 0.0f);
	expect(&bench, 0,
		"it takes 1000 us and 9.5 KiB; \"row 1\" would save 6 us, which "
		"is 0.06% of a frame of 10.0 ms, but take 2 KiB more, where 1% "
		"is worth 1 KiB");
	begin(&bench);
	add(&bench, 1000, 9.5, 0.0f);
	add(&bench, 994, 9.5, 0.0f);
	expect(&bench, 0,
		"it takes 1000 us and 9.5 KiB; \"row 1\" would save 6.0 us, "
		"which is 0.06% of a frame of 10.0 ms and too little to convert "
		"the model for");
}

static void test_a_row_must_keep_within_the_error_if_any_does(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 9000, 100, 2.0f);
	add(&bench, 100, 1, 2.001f);
	expect(&bench, 0,
		"it takes 9000 us and 100 KiB; nothing else keeps within 2 px, "
		"391 KiB and 10 ms");
	begin(&bench);
	add(&bench, 100, 1, 5.0f);
	add(&bench, 9000, 100, 3.25f);
	add(&bench, 90, 1, 4.0f);
	expect(&bench, 1,
		"it takes 9000 us and 100 KiB; nothing that fits the memory of "
		"391 KiB keeps within 2 px, and with 3.25 px it comes closest");
}

static void test_memory_counts_more_than_the_error(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.request.memory_bytes = 20 * 1024;
	add(&bench, 100, 21, 0.0f);
	add(&bench, 9000, 20, 9.0f);
	expect(&bench, 1,
		"it takes 9000 us and 20 KiB; nothing that fits the memory of "
		"20 KiB keeps within 2 px, and with 9.00 px it comes closest");
	begin(&bench);
	bench.comparison.request.memory_bytes = 20 * 1024;
	add(&bench, 100, 30, 0.0f);
	add(&bench, 9000, 25, 9.0f);
	add(&bench, 9000, 26, 1.0f);
	expect(&bench, 1,
		"it takes 9000 us and 25 KiB; nothing fits the memory of 20 "
		"KiB, and it needs the least");
}

static void test_time_counts_less_than_the_error(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.comparison.request.frame_ms = 5.0;
	add(&bench, 6000, 10, 0.0f);
	add(&bench, 5000, 40, 2.0f);
	add(&bench, 100, 10, 2.5f);
	expect(&bench, 1,
		"it takes 5000 us and 40 KiB; nothing else keeps within 2 px, "
		"391 KiB and 5 ms");
	begin(&bench);
	add(&bench, 12000, 10, 0.0f);
	add(&bench, 11000, 15, 0.0f);
	expect(&bench, 1,
		"it takes 11000 us and 15 KiB; nothing that keeps within 2 px "
		"is as fast as 10 ms, and it has the least price of time and "
		"memory");
	bench.comparison.row[1].total.draw.cycles = ARM11_MHZ * 10001.0;
	expect(&bench, 1,
		"it takes 11000 us and 15 KiB; drawing alone takes 10.0 ms, "
		"where a frame may take 10 ms; of what keeps within 2 px, it "
		"has the least price of time and memory");
}

static void test_the_limits_are_the_boards_unless_given(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 100, 10, 0.0f);
	advice_give(&bench.comparison);
	assert_int_equal(bench.comparison.memory_limit_bytes, 400000);
	assert_near(bench.comparison.time_limit_us, 10000.0, 0.0);
	bench.comparison.request.memory_bytes = 1;
	bench.comparison.request.frame_ms = 0.5;
	advice_give(&bench.comparison);
	assert_int_equal(bench.comparison.memory_limit_bytes, 1);
	assert_near(bench.comparison.time_limit_us, 500.0, 1e-9);
}

/* Predictions are off by as much, so that the slower row may keep the limit. */
static void test_a_frame_may_take_two_percent_longer(void **state)
{
	(void)state;
	for (int over = 0; over <= 1; over++) {
		struct bench bench;

		begin(&bench);
		add(&bench, 9000, 40, 0.0f);
		add(&bench, over ? 10201 : 10199, 10, 0.0f);
		advice_give(&bench.comparison);
		assert_int_equal(bench.comparison.advised, over ? 0 : 1);
	}
}

static void test_the_default_board_is_the_pdk(void **state)
{
	const struct board_profile *pdk = board_profile_find(NULL);

	(void)state;
	assert_string_equal(pdk->name, "imx31-pdk");
	assert_ptr_equal(board_profile_find("imx31-pdk"), pdk);
	assert_null(board_profile_find("imx31"));
	assert_int_equal(pdk->ram_bytes, 134217728);
	assert_int_equal(pdk->taken_bytes, 50331648);
	assert_int_equal(pdk->bytes_per_percent, 262144);
	assert_near(pdk->frame_ms, 33.3333, 1e-4);
}

/* The plot has rows that the table does not list. */
static void test_rows_that_are_not_listed_are_not_advised(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 10, 1, 0.0f)->listed = false;
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; nothing else keeps within 2 px, "
		"391 KiB and 10 ms");
	assert_true(bench.comparison.row[0].front);
	assert_false(bench.comparison.row[1].front);
}

static void test_the_front_has_the_rows_that_no_other_beats(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 1.0f);
	add(&bench, 1000, 11, 1.0f); /* row 0 beats it */
	add(&bench, 1000, 10, 1.0f); /* of equal rows, the first counts */
	add(&bench, 1001, 12, 0.9f); /* nothing is as exact */
	advice_give(&bench.comparison);
	assert_true(bench.comparison.row[0].front);
	assert_false(bench.comparison.row[1].front);
	assert_false(bench.comparison.row[2].front);
	assert_true(bench.comparison.row[3].front);
}

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
			test_a_third_of_a_percent_is_worth_converting_the_model),
		cmocka_unit_test(
			test_memory_has_the_price_that_the_board_gives_it),
		cmocka_unit_test(test_small_figures_have_digits_behind_the_point),
		cmocka_unit_test(
			test_a_row_must_keep_within_the_error_if_any_does),
		cmocka_unit_test(test_memory_counts_more_than_the_error),
		cmocka_unit_test(test_time_counts_less_than_the_error),
		cmocka_unit_test(test_the_limits_are_the_boards_unless_given),
		cmocka_unit_test(test_a_frame_may_take_two_percent_longer),
		cmocka_unit_test(test_the_default_board_is_the_pdk),
		cmocka_unit_test(test_rows_that_are_not_listed_are_not_advised),
		cmocka_unit_test(test_the_front_has_the_rows_that_no_other_beats),
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
