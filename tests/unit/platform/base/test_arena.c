#include "platform/base/arena.h"
#include "platform/base/memory_budget.h"
#include "tests/support/test.h"

#include <malloc.h>
#include <string.h>
#if defined(__has_include) && __has_include(<sanitizer/asan_interface.h>)
#include <sanitizer/asan_interface.h>
#endif

static void test_memory_is_zeroed_and_aligned(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	for (size_t bytes = 0; bytes < 200; bytes += 7) {
		unsigned char *memory = arena_alloc(&arena, bytes, 1);

		assert_non_null(memory);
		assert_int_equal((uintptr_t)memory % 16, 0);
		for (size_t i = 0; i < bytes; i++) {
			assert_int_equal(memory[i], 0);
		}
		memset(memory, 0xa5, bytes);
	}
	arena_release(&arena);
}

static void test_allocations_do_not_overlap(void **state)
{
	enum {
		COUNT = 500
	};
	struct arena arena = arena_empty();
	int *memory[COUNT];

	(void)state;
	for (int i = 0; i < COUNT; i++) {
		memory[i] = ARENA_ARRAY(&arena, int, (size_t)(i % 90 + 1));
		for (int k = 0; k <= i % 90; k++) {
			memory[i][k] = i;
		}
	}
	for (int i = 0; i < COUNT; i++) {
		for (int k = 0; k <= i % 90; k++) {
			assert_int_equal(memory[i][k], i);
		}
	}
	arena_release(&arena);
}

static void test_blocks_have_the_size_that_is_asked_for(void **state)
{
	struct memory_budget budget = {.limit_bytes = 16 * 1024};
	struct arena arena = arena_within(&budget);

	(void)state;
	arena.block_bytes = 4096;
	assert_non_null(arena_alloc(&arena, 4096 / 8, 1));
	assert_in_range(budget.used_bytes, 512, 600);
	assert_non_null(arena_alloc(&arena, 100, 1));
	assert_non_null(arena_alloc(&arena, 100, 1));
	assert_in_range(budget.used_bytes, 4096 + 512, 4200 + 600);
	assert_non_null(arena_alloc(&arena, 10000, 1));
	assert_in_range(budget.used_bytes, 14608, 15000);
	arena_release(&arena);
	assert_int_equal(budget.used_bytes, 0);
}

/* An eighth of a block gets one of its own, less shares one. */
static void test_blocks_have_64_kib_unless_another_size_is_asked_for(
	void **state)
{
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	struct arena arena = arena_within(&budget);
	size_t head, first;

	(void)state;
	assert_non_null(arena_alloc(&arena, 1, 1 << 20));
	head = budget.used_bytes - (1 << 20);
	assert_in_range(head, 1, 256);
	first = budget.used_bytes;
	assert_non_null(arena_alloc(&arena, 1, 100));
	assert_in_range(budget.used_bytes - first, 65536, 65536 + head);
	first = budget.used_bytes;
	assert_non_null(arena_alloc(&arena, 1, 7000));
	assert_int_equal(budget.used_bytes, first);
	assert_non_null(arena_alloc(&arena, 1, 65536 - 5000));
	assert_in_range(budget.used_bytes - first, 65536 - 5000,
		65536 - 5000 + head + 16);
	arena_release(&arena);
	assert_int_equal(budget.used_bytes, 0);
}

/* Of which the sanitizer sees nothing, as it may use what the arena gives out. */
static void test_a_block_has_room_for_its_bytes_and_its_head(void **state)
{
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	size_t head = 0;

	(void)state;
	for (size_t bytes = 8192; bytes < 8192 + 300; bytes++) {
		struct arena arena = arena_within(&budget);
		size_t even = (bytes + 15) / 16 * 16;

		assert_non_null(arena_alloc(&arena, bytes, 1));
		assert_int_equal(budget.used_bytes % 16, 0);
		head = head ? head : budget.used_bytes - even;
		assert_in_range(head, 3 * sizeof(size_t), 256);
		assert_int_equal(budget.used_bytes, even + head);
		arena_release(&arena);
		assert_int_equal(budget.used_bytes, 0);
	}
}

static void test_large_allocations_can_be_freed_on_their_own(void **state)
{
	struct memory_budget budget = {.limit_bytes = 1024 * 1024};
	struct arena arena = arena_within(&budget);
	char *first, *small, *last;
	size_t used;

	(void)state;
	first = arena_alloc(&arena, 100001, 1);
	small = arena_alloc(&arena, 10, 1);
	used = budget.used_bytes;
	last = arena_alloc(&arena, 200000, 1);
	assert_non_null(last);
	arena_free(&arena, last, 200000);
	assert_int_equal(budget.used_bytes, used);
	arena_free(&arena, small, 10);
	assert_int_equal(budget.used_bytes, used);
	arena_free(&arena, first, 100001);
	assert_in_range(budget.used_bytes, 1, used - 100000);
	small[9] = 1;
	assert_non_null(arena_alloc(&arena, 100001, 1));
	arena_release(&arena);
	assert_int_equal(budget.used_bytes, 0);
}

static void test_allocations_larger_than_a_block_work(void **state)
{
	enum {
		BYTES = 1000000
	};
	struct arena arena = arena_empty();
	char *small = arena_alloc(&arena, 10, 1);
	char *large = arena_alloc(&arena, BYTES, 1);

	(void)state;
	assert_non_null(small);
	assert_non_null(large);
	large[0] = 1;
	large[BYTES - 1] = 1;
	assert_true(arena.used_bytes >= BYTES + 10);
	arena_release(&arena);
}

/* 100 small allocations and 20 large ones in between need hardly more. */
static void test_large_allocations_waste_no_room(void **state)
{
	enum {
		LARGE = 50000
	};
	struct memory_budget budget = {.limit_bytes = SIZE_MAX};
	struct arena arena = arena_within(&budget);
	char *memory[120];

	(void)state;
	for (int i = 0; i < 120; i++) {
		size_t bytes = i % 6 == 3 ? LARGE : 500;

		memory[i] = arena_alloc(&arena, bytes, 1);
		memory[i][0] = (char)i;
		memory[i][bytes - 1] = (char)i;
	}
	for (int i = 0; i < 120; i++) {
		assert_int_equal(memory[i][0], i);
		assert_int_equal(memory[i][i % 6 == 3 ? LARGE - 1 : 499], i);
	}
	assert_true(budget.used_bytes < 20 * LARGE + 2 * 70000);
	arena_release(&arena);
	assert_int_equal(budget.used_bytes, 0);
}

/* The first large block lies behind the block with the budget. */
static void test_releases_a_budget_in_its_own_memory(void **state)
{
	struct arena arena = arena_empty();
	struct memory_budget *budget = ARENA_NEW(&arena, struct memory_budget);

	(void)state;
	budget->limit_bytes = 1000000;
	assert_true(arena_set_budget(&arena, budget));
	assert_non_null(arena_alloc(&arena, 100000, 1));
	assert_non_null(arena_alloc(&arena, 10, 1));
	assert_null(arena_alloc(&arena, 1000000, 1));
	arena_release(&arena);
	assert_null(arena.newest);
	/* Nothing is left to give back to a budget that is gone. */
	arena_release(&arena);
}

#ifndef __has_feature /* of clang */
#define __has_feature(feature) 0
#endif

/* What a parser or a loop writes behind its array is then found. */
static void test_the_sanitizer_guards_what_lies_behind_an_array(void **state)
{
#if defined(__SANITIZE_ADDRESS__) || __has_feature(address_sanitizer)
	struct arena arena = arena_empty();

	(void)state;
	for (size_t bytes = 0; bytes < 40000; bytes = bytes * 3 + 1) {
		char *memory = arena_alloc(&arena, bytes, 1);
		char *next = arena_alloc(&arena, 1, 1);

		assert_non_null(memory);
		assert_non_null(next);
		assert_null(__asan_region_is_poisoned(memory, bytes));
		assert_ptr_equal(__asan_region_is_poisoned(memory, bytes + 1),
			memory + bytes);
		assert_true(__asan_address_is_poisoned(next + 1));
	}
	arena_release(&arena);
#else
	(void)state;
	skip_because("the sanitizer is not in this build");
#endif
}

static void test_overflowing_sizes_give_null(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	assert_null(arena_alloc(&arena, SIZE_MAX / 8, 16));
	assert_null(arena_alloc(&arena, SIZE_MAX, 1));
	assert_null(arena_alloc(&arena, 1, SIZE_MAX));
	assert_int_equal(arena.used_bytes, 0);
	arena_release(&arena);
}

static void test_a_count_of_zero_gives_a_pointer(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	assert_non_null(arena_alloc(&arena, 0, 16));
	assert_non_null(arena_alloc(&arena, 16, 0));
	arena_release(&arena);
}

static void test_strings_are_copied(void **state)
{
	struct arena arena = arena_empty();
	char text[] = "elbow";
	char *copy = arena_strdup(&arena, text);
	char *empty = arena_strdup(&arena, "");

	(void)state;
	text[0] = 'E';
	assert_string_equal(copy, "elbow");
	assert_string_equal(empty, "");
	arena_release(&arena);
}

/* Whatever comes next, also where they fill what is kept for them. */
static void test_strings_of_any_length_keep_their_end(void **state)
{
	enum {
		LONGEST = 70
	};
	struct arena arena = arena_empty();
	char text[LONGEST + 1], *copy[LONGEST + 1];

	(void)state;
	memset(text, 'x', LONGEST);
	for (int length = LONGEST; length >= 0; length--) {
		size_t used = arena.used_bytes;

		text[length] = '\0';
		copy[length] = arena_strdup(&arena, text);
		assert_non_null(copy[length]);
		assert_int_equal(
			arena.used_bytes - used, (length + 16) / 16 * 16);
		memset(arena_alloc(&arena, 1, 16), 'y', 16);
	}
	for (size_t length = 0; length <= LONGEST; length++) {
		assert_int_equal(strspn(copy[length], "x"), length);
		assert_int_equal(copy[length][length], '\0');
	}
	arena_release(&arena);
}

static void test_release_leaves_an_empty_arena(void **state)
{
	struct arena arena = arena_empty();

	(void)state;
	arena_release(&arena);
	assert_non_null(arena_alloc(&arena, 100, 1));
	arena_release(&arena);
	assert_null(arena.newest);
	assert_int_equal(arena.used_bytes, 0);
	assert_non_null(arena_alloc(&arena, 100, 1));
	arena_release(&arena);
}

/* What malloc() has handed out; the sanitizer's looks for leaks by itself. */
static size_t bytes_in_use(void)
{
	struct mallinfo2 info = mallinfo2();

	return info.uordblks + info.hblkhd;
}

static void test_blocks_are_given_back(void **state)
{
	size_t before = bytes_in_use();

	(void)state;
	for (int i = 0; i < 100; i++) {
		struct arena arena = arena_empty();
		void *large = arena_alloc(&arena, 300000, 1);

		assert_non_null(large);
		assert_non_null(arena_alloc(&arena, 20000, 1));
		assert_non_null(arena_alloc(&arena, 10, 1));
		if (i % 2) {
			arena_free(&arena, large, 300000);
		}
		arena_release(&arena);
	}
	assert_in_range(bytes_in_use(), 0, before + 5000);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_memory_is_zeroed_and_aligned),
		cmocka_unit_test(test_allocations_do_not_overlap),
		cmocka_unit_test(test_blocks_have_the_size_that_is_asked_for),
		cmocka_unit_test(
			test_blocks_have_64_kib_unless_another_size_is_asked_for),
		cmocka_unit_test(
			test_a_block_has_room_for_its_bytes_and_its_head),
		cmocka_unit_test(
			test_large_allocations_can_be_freed_on_their_own),
		cmocka_unit_test(test_allocations_larger_than_a_block_work),
		cmocka_unit_test(test_large_allocations_waste_no_room),
		cmocka_unit_test(test_releases_a_budget_in_its_own_memory),
		cmocka_unit_test(
			test_the_sanitizer_guards_what_lies_behind_an_array),
		cmocka_unit_test(test_overflowing_sizes_give_null),
		cmocka_unit_test(test_a_count_of_zero_gives_a_pointer),
		cmocka_unit_test(test_strings_are_copied),
		cmocka_unit_test(test_strings_of_any_length_keep_their_end),
		cmocka_unit_test(test_blocks_are_given_back),
		cmocka_unit_test(test_release_leaves_an_empty_arena),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
