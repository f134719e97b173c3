/* Which other row the reason of an advice names, and with which figures. */
#include "app/compare/advice.h"
#include "tests/support/test.h"
#include "tests/unit/app/compare/advice_bench.h"

static void expect(struct bench *bench, int advised, const char *reason)
{
	advice_give(&bench->comparison);
	assert_int_equal(bench->comparison.advised, advised);
	assert_string_equal(bench->comparison.reason, reason);
}

static void test_a_faster_model_may_take_too_much_memory(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 400, 20, 0.0f);
	add(&bench, 500, 10, 0.0f);
	expect(&bench, 1,
		"it takes 500 us and 10 KiB; \"row 0\" would save 100 us, which "
		"is 1.0% of a frame of 10.0 ms, but take 10 KiB more, where 1% "
		"is worth 1 KiB");
}

static void test_a_smaller_model_may_take_too_long(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 500, 11, 0.0f);
	add(&bench, 2000, 12, 0.0f);
	expect(&bench, 1,
		"it takes 500 us and 11 KiB; \"row 0\" would save 1 KiB but "
		"take 500 us more, which is 5.0% of a frame of 10.0 ms, where "
		"1% is worth 1 KiB");
}

/* It is neither faster than the advised row nor smaller. */
static void test_a_row_as_fast_or_as_small_is_not_better(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 500, 12, 0.0f);
	add(&bench, 500, 10, 0.0f);
	expect(&bench, 1,
		"it takes 500 us and 10 KiB; nothing that keeps within 2 px is "
		"faster or smaller; \"row 0\" takes 500 us and 12 KiB");
	begin(&bench);
	add(&bench, 900, 10, 0.0f);
	add(&bench, 500, 10, 0.0f);
	expect(&bench, 1,
		"it takes 500 us and 10 KiB; nothing that keeps within 2 px is "
		"faster or smaller; \"row 0\" takes 900 us and 10 KiB");
}

static void test_of_equal_rows_the_first_is_named(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 500, 10, 0.0f);
	add(&bench, 700, 12, 0.0f);
	add(&bench, 700, 12, 0.0f);
	expect(&bench, 0,
		"it takes 500 us and 10 KiB; nothing that keeps within 2 px is "
		"faster or smaller; \"row 1\" takes 700 us and 12 KiB");
	begin(&bench);
	add(&bench, 500, 12, 0.0f);
	add(&bench, 900, 11, 0.0f);
	add(&bench, 900, 11, 0.0f);
	expect(&bench, 0,
		"it takes 500 us and 12 KiB; \"row 1\" would save 1 KiB but "
		"take 400 us more, which is 4.0% of a frame of 10.0 ms, where "
		"1% is worth 1 KiB");
}

/* 100 us are worth 1 KiB. */
static void test_the_same_price_is_no_reason_to_convert(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 900, 11, 0.0f);
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; \"row 1\" would save 100 us, which "
		"is 1.00% of a frame of 10.0 ms and too little to convert the "
		"model for");
}

static void test_shares_below_a_tenth_of_a_percent_have_two_digits(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.0f);
	add(&bench, 950, 12, 0.0f);
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; \"row 1\" would save 50 us, which "
		"is 0.5% of a frame of 10.0 ms, but take 2 KiB more, where 1% "
		"is worth 1 KiB");
	begin(&bench);
	add(&bench, 1000, 12, 0.0f);
	add(&bench, 1003, 11.9, 0.0f);
	expect(&bench, 0,
		"it takes 1000 us and 12 KiB; \"row 1\" would save 0 KiB but "
		"take 3 us more, which is 0.03% of a frame of 10.0 ms, where "
		"1% is worth 1 KiB");
}

static void test_what_keeps_the_bound_exactly_is_only_too_slow(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 12000, 10, 2.0f);
	expect(&bench, 0,
		"it takes 12000 us and 10 KiB; nothing that keeps within 2 px "
		"is as fast as 10 ms, and it has the least price of time and "
		"memory");
	bench.comparison.request.memory_bytes = 10 * 1024;
	expect(&bench, 0,
		"it takes 12000 us and 10 KiB; nothing that keeps within 2 px "
		"is as fast as 10 ms, and it has the least price of time and "
		"memory");
}

/* It would be the best of all. */
static void test_a_row_behind_the_last_one_does_not_count(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	add(&bench, 1000, 10, 0.5f);
	add(&bench, 1100, 11, 0.4f);
	add(&bench, 1, 1, 0.0f);
	bench.comparison.row_count = 2;
	expect(&bench, 0,
		"it takes 1000 us and 10 KiB; nothing that keeps within 2 px is "
		"faster or smaller; \"row 1\" takes 1100 us and 11 KiB");
	assert_true(bench.comparison.row[0].front);
	assert_true(bench.comparison.row[1].front);
	assert_false(bench.comparison.row[2].front);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_faster_model_may_take_too_much_memory),
		cmocka_unit_test(test_a_smaller_model_may_take_too_long),
		cmocka_unit_test(test_a_row_as_fast_or_as_small_is_not_better),
		cmocka_unit_test(test_of_equal_rows_the_first_is_named),
		cmocka_unit_test(test_the_same_price_is_no_reason_to_convert),
		cmocka_unit_test(
			test_shares_below_a_tenth_of_a_percent_have_two_digits),
		cmocka_unit_test(
			test_what_keeps_the_bound_exactly_is_only_too_slow),
		cmocka_unit_test(test_a_row_behind_the_last_one_does_not_count),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
