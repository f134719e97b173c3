#include "platform/base/memory_budget.h"

#include "platform/base/arena.h"
#include "platform/base/count.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <limits.h>
#include <stdint.h>

static void test_a_budget_gives_what_it_has(void **state)
{
	struct memory_budget budget = {.limit_bytes = 100};

	(void)state;
	assert_true(memory_budget_take(&budget, 60));
	assert_false(memory_budget_take(&budget, 41));
	assert_true(budget.exceeded);
	assert_true(memory_budget_take(&budget, 40));
	assert_false(memory_budget_take(&budget, SIZE_MAX));
	memory_budget_give_back(&budget, 60);
	assert_int_equal(budget.used_bytes, 40);
}

static void test_without_a_budget_nothing_is_refused(void **state)
{
	(void)state;
	assert_true(memory_budget_take(NULL, SIZE_MAX));
	memory_budget_give_back(NULL, 1);
}

static void test_the_error_tells_a_limit_from_a_full_machine(void **state)
{
	struct memory_budget budget = {.limit_bytes = 64 << 20};
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);

	(void)state;
	assert_int_equal(memory_budget_fail(&budget, "a.glb", &log), -ENOMEM);
	assert_contains(heard.sentence[0], "a.glb: there is not enough memory");
	(void)memory_budget_take(&budget, SIZE_MAX);
	assert_int_equal(memory_budget_fail(&budget, "a.glb", &log), -ENOMEM);
	assert_contains(heard.sentence[1], "64 MiB");
	assert_contains(heard.sentence[1], "--memory");
}

static void test_the_error_names_the_limit_in_its_unit(void **state)
{
	static const struct {
		size_t limit_bytes;
		const char *words;
	} cases[] = {
		{64 << 10, "more than 64 KiB of memory"},
		{(1 << 20) - 1, "more than 1023 KiB of memory"},
		{1 << 20, "more than 1 MiB of memory"},
		{256 << 20, "more than 256 MiB of memory"},
	};

	(void)state;
	for (int i = 0; i < 4; i++) {
		struct memory_budget budget = {
			.limit_bytes = cases[i].limit_bytes};
		struct log_capture heard;
		struct log log = log_capture_begin(&heard);

		(void)memory_budget_take(&budget, SIZE_MAX);
		(void)memory_budget_fail(&budget, "a.glb", &log);
		assert_contains(heard.sentence[0], cases[i].words);
	}
}

static void test_an_arena_takes_its_blocks_and_gives_them_back(void **state)
{
	struct memory_budget budget = {.limit_bytes = 1000000};
	struct arena arena = arena_within(&budget);

	(void)state;
	assert_non_null(arena_alloc(&arena, 500000, 1));
	assert_in_range(budget.used_bytes, 500000, 1000000);
	assert_null(arena_alloc(&arena, 600000, 1));
	assert_true(budget.exceeded);
	assert_non_null(arena_alloc(&arena, 100, 1));
	arena_release(&arena);
	assert_int_equal(budget.used_bytes, 0);
}

static void test_an_overflow_counts_as_more_than_the_budget(void **state)
{
	struct memory_budget budget = {.limit_bytes = 1000000};
	struct arena arena = arena_within(&budget);

	(void)state;
	assert_null(arena_alloc(&arena, SIZE_MAX / 2, 16));
	assert_true(budget.exceeded);
	arena_release(&arena);
}

static void test_a_budget_may_lie_in_its_own_arena(void **state)
{
	struct arena arena = arena_empty();
	struct memory_budget *budget = ARENA_NEW(&arena, struct memory_budget);

	(void)state;
	assert_false(arena_set_budget(&arena, budget));
	budget->limit_bytes = 1000000;
	assert_true(arena_set_budget(&arena, budget));
	assert_true(budget->used_bytes > 0);
	assert_non_null(arena_alloc(&arena, 200000, 1));
	arena_release(&arena);
}

static void test_sums_and_products_that_do_not_fit_are_refused(void **state)
{
	int count = 7;
	size_t size = 7;

	(void)state;
	assert_false(count_add(INT_MAX, 1, &count));
	assert_false(count_add(1, INT_MAX, &count));
	assert_false(count_multiply(65536, 32768, &count));
	assert_false(size_add(SIZE_MAX, 1, &size));
	assert_false(size_multiply(SIZE_MAX / 2 + 1, 2, &size));
	assert_int_equal(count, 7);
	assert_int_equal(size, 7);
	assert_true(count_add(INT_MAX, 0, &count));
	assert_int_equal(count, INT_MAX);
	assert_true(count_multiply(65536, 32767, &count));
	assert_int_equal(count, 65536 * 32767);
	assert_true(count_multiply(INT_MAX, 0, &count));
	assert_int_equal(count, 0);
	assert_true(size_multiply(SIZE_MAX, 1, &size));
	assert_true(size == SIZE_MAX);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_budget_gives_what_it_has),
		cmocka_unit_test(test_without_a_budget_nothing_is_refused),
		cmocka_unit_test(
			test_the_error_tells_a_limit_from_a_full_machine),
		cmocka_unit_test(test_the_error_names_the_limit_in_its_unit),
		cmocka_unit_test(
			test_an_arena_takes_its_blocks_and_gives_them_back),
		cmocka_unit_test(test_an_overflow_counts_as_more_than_the_budget),
		cmocka_unit_test(test_a_budget_may_lie_in_its_own_arena),
		cmocka_unit_test(
			test_sums_and_products_that_do_not_fit_are_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
