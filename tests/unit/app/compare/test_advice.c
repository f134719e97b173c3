/* The rule of the advice, on comparisons whose figures the tests make up. */
#include "app/anim/kernel/arm11_cost.h"
#include "app/compare/advice.h"
#include "app/compare/advice_price.h"
#include "platform/base/scalar.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/advice_bench.h"

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
	bench.comparison.row[1].total.draw.cycles = ARM11_MHZ * 10000.0;
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

static void test_a_frame_may_take_exactly_its_limit(void **state)
{
	struct comparison comparison = {.time_limit_us = 1000.0};
	const double most_us = 1000.0 * 1.02;

	(void)state;
	assert_true(advice_is_in_time(&comparison, most_us));
	assert_false(advice_is_in_time(&comparison, most_us * 1.0000001));
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

/* Row 0 is worse in what decides, and rows 1 and 2 are as good as each other. */
static void test_of_rows_that_are_as_good_the_first_is_advised(void **state)
{
	static const struct {
		size_t memory_bytes;
		double us[2], kib[2];
		float px[2];
	} cases[] = {
		{0, {1000, 900}, {10, 10}, {1, 1}},        /* the price */
		{20 * 1024, {10, 20}, {30, 25}, {0, 0}},   /* the memory */
		{0, {10, 20}, {10, 10}, {5, 4}},           /* the error */
		{0, {12000, 11000}, {10, 10}, {1, 1}},     /* the time */
		{20 * 1024, {1000, 10}, {19, 20}, {0, 0}}, /* fits the memory */
		{0, {10, 20}, {10, 10}, {2.5f, 2}},        /* fits the error */
		{0, {10300, 9900}, {10, 10}, {0.5f, 2}},   /* fits the time */
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct bench bench;

		begin(&bench);
		bench.comparison.request.memory_bytes = cases[i].memory_bytes;
		for (int row = 0; row < 3; row++) {
			add(&bench, cases[i].us[row > 0], cases[i].kib[row > 0],
				cases[i].px[row > 0]);
		}
		advice_give(&bench.comparison);
		assert_int_equal(bench.comparison.advised, 1);
	}
}

/* What shows one of its clips inside out for a while is as bad as a large error. */
static void test_a_morph_that_turns_inside_out_is_not_advised(void **state)
{
	(void)state;
	for (int clip = -1; clip <= CLIPS; clip++) {
		struct bench bench;

		begin(&bench);
		add(&bench, 1000, 10, 0.0f);
		add(&bench, 10, 10, 0.0f)->kind = COMPARISON_MORPH;
		if (clip >= 0) {
			bench.clip[clip].turns = true;
		}
		advice_give(&bench.comparison);
		assert_int_equal(bench.comparison.advised,
			clip < 0 || clip == CLIPS ? 1 : 0);
	}
}

/* A row is worse only if another one is at least as good in everything. */
static void test_a_row_that_is_best_in_anything_is_on_the_front(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 1.0f);
	add(&bench, 999, 11, 1.1f);
	add(&bench, 1001, 9, 1.1f);
	add(&bench, 1001, 11, 0.9f);
	add(&bench, 1000, 9, 1.1f); /* beats row 2, which comes before it */
	add(&bench, 1, 1, 0.0f)->listed = false;
	advice_give(&bench.comparison);
	for (int row = 0; row < 5; row++) {
		assert_int_equal(bench.comparison.row[row].front, row != 2);
	}
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
		cmocka_unit_test(test_a_frame_may_take_exactly_its_limit),
		cmocka_unit_test(test_the_default_board_is_the_pdk),
		cmocka_unit_test(test_rows_that_are_not_listed_are_not_advised),
		cmocka_unit_test(test_the_front_has_the_rows_that_no_other_beats),
		cmocka_unit_test(
			test_of_rows_that_are_as_good_the_first_is_advised),
		cmocka_unit_test(
			test_a_morph_that_turns_inside_out_is_not_advised),
		cmocka_unit_test(
			test_a_row_that_is_best_in_anything_is_on_the_front),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
