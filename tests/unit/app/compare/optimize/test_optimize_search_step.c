/* Which number of pixels a search for the fewest keys tries next. */
#include "app/compare/optimize/optimize_search.h"
#include "tests/support/test.h"

#include <math.h>

/* Errors aim at nine tenths of the bound. */
static void test_a_step_is_as_long_as_the_error_leaves_room(void **state)
{
	static const float sizes[] = {0.1f, 1.0f, 20.0f};
	static const struct {
		float peak_share, factor; /* of the bound, and of key_px */
	} cases[] = {
		{0.0f, 4.0f},  /* no error at all */
		{0.09f, 4.0f}, /* at most 4 times */
		{0.25f, 3.6f}, /* 0.9 / 0.25 */
		{0.45f, 2.0f}, /* 0.9 / 0.45 */
		{0.75f, 1.2f}, /* 0.9 / 0.75 */
		{1.8f, 0.5f},  /* 0.9 / 1.8 */
		{9.0f, 0.1f},  /* no least step */
	};

	(void)state;
	for (size_t i = 0; i < 3 * sizeof(cases) / sizeof(*cases); i++) {
		struct optimize_search search = {0};
		float bound_px = sizes[i % 3], key_px = 0.5f * bound_px;
		bool fits = cases[i / 3].peak_share <= 1.0f;
		float next_px = optimize_search_next(&search, key_px,
			cases[i / 3].peak_share * bound_px, bound_px);

		assert_near(next_px, cases[i / 3].factor * key_px,
			1e-5 * (double)key_px);
		assert_near(search.good_px, fits ? key_px : 0.0f, 0);
		assert_near(search.bad_px, fits ? 0.0f : key_px, 0);
		assert_false(search.done);
	}
}

/* An error of exactly the bound fits, and leaves no room for another step. */
static void test_the_bound_itself_is_kept(void **state)
{
	struct optimize_search search = {0};

	(void)state;
	assert_near(optimize_search_next(&search, 2.0f, 0.5f, 0.5f), 1.8, 1e-6);
	assert_near(search.good_px, 2.0, 0);
	assert_near(search.bad_px, 0.0, 0);
	assert_true(search.done);
	search = (struct optimize_search){0};
	assert_near(optimize_search_next(
			    &search, 2.0f, nextafterf(0.5f, 1.0f), 0.5f),
		1.8, 1e-6);
	assert_near(search.good_px, 0.0, 0);
	assert_near(search.bad_px, 2.0, 0);
	assert_false(search.done);
}

/* The geometric mean of 1 and 4 is 2, and errors are those of a bound of 1. */
static void test_a_step_stays_between_what_fits_and_what_does_not(void **state)
{
	static const struct {
		float key, peak, next;
		bool done;
	} cases[] = {
		/* From what fits: no farther than the mean. */
		{1.0f, 0.1f, 2.0f, false},
		{1.0f, 0.45f, 2.0f, false},
		{1.0f, 0.6f, 1.5f, false},
		{1.0f, 0.9f, 2.0f, false}, /* no room: the mean all the same */
		{1.0f, 0.85f, 0.9f / 0.85f, true},
		/* From what does not: not back to what is known to fit. */
		{4.0f, 2.4f, 1.5f, false},
		{4.0f, 3.5f, 3.6f / 3.5f, true},
		{4.0f, 3.6f, 2.0f, false},
		{4.0f, 8.0f, 2.0f, false},
		{4.0f, 1.2f, 2.0f, false},
	};
	static const float sizes[] = {0.125f, 1.0f, 16.0f};

	(void)state;
	for (size_t i = 0; i < 3 * sizeof(cases) / sizeof(*cases); i++) {
		float size = sizes[i % 3];
		struct optimize_search search = {size, 4.0f * size, false};
		float next = optimize_search_next(&search,
			size * cases[i / 3].key, cases[i / 3].peak, 1.0f);

		assert_near(next, size * cases[i / 3].next, 1e-6 * (double)size);
		assert_near(search.good_px, size, 0);
		assert_near(search.bad_px, 4.0f * size, 0);
		assert_int_equal(search.done, cases[i / 3].done);
	}
}

/* The next value would be less than a tenth larger. */
static void test_a_search_ends_close_to_what_does_not_fit(void **state)
{
	static const float bad[] = {1.05f, 1.2f, 1.2099f, 1.2101f, 1.3f, 9.0f};

	(void)state;
	for (int i = 0; i < 6; i++) {
		struct optimize_search search = {0.0f, bad[i], false};

		assert_near(optimize_search_next(&search, 1.0f, 0.1f, 1.0f),
			sqrt((double)bad[i]), 1e-6);
		assert_int_equal(search.done, i < 3);
	}
}

/* The error that key_px leads to: in proportion to it, or in other ways. */
static float error_of(int kind, float key_px)
{
	switch (kind) {
	case 0:
		return 10.0f * key_px;
	case 1:
		return key_px < 3.7f ? 0.0f : 100.0f;
	default:
		return key_px * key_px;
	}
}

static void test_a_search_finds_the_largest_value_that_fits(void **state)
{
	static const float bounds[] = {0.3f, 1.0f, 5.0f};

	(void)state;
	for (int i = 0; i < 9; i++) {
		struct optimize_search search = {0};
		float bound_px = bounds[i % 3], key_px = bound_px;
		int steps = 0;

		while (!search.done && steps < 30) {
			key_px = optimize_search_next(&search, key_px,
				error_of(i / 3, key_px), bound_px);
			steps++;
		}
		assert_true(search.done);
		assert_true(error_of(i / 3, search.good_px) <= bound_px);
		assert_true(error_of(i / 3, 1.25f * search.good_px) > bound_px);
		assert_true(steps <= 9);
	}
}

/* In proportion where good_px is less than its error, else to the bound. */
static void test_a_clip_beyond_the_bound_keeps_more_keys(void **state)
{
	static const struct {
		float good, peak, bound, wanted;
	} cases[] = {
		{0.5f, 0.0f, 1.0f, 0.5f},
		{0.5f, 1.0f, 1.0f, 0.5f}, /* the bound is kept */
		{3.0f, 1.0f, 1.0f, 3.0f},
		{0.5f, 2.0f, 1.0f, 0.225f}, /* 0.5 * 0.9 / 2 */
		{0.5f, 3.0f, 0.2f, 0.03f},  /* 0.5 * 0.18 / 3 */
		{2.0f, 2.0f, 1.0f, 0.9f},
		{2.5f, 2.0f, 1.0f, 0.9f},
		{90.0f, 0.3f, 0.2f, 0.18f},
		{0.0f, 2.0f, 1.0f, 0.0f},
	};

	(void)state;
	for (size_t i = 0; i < sizeof(cases) / sizeof(*cases); i++) {
		struct optimize_search search = {cases[i].good, 7.0f, true};

		optimize_search_keep_more(
			&search, cases[i].peak, cases[i].bound);
		assert_near(search.good_px, cases[i].wanted, 1e-6);
		assert_near(search.bad_px, 7.0f, 0);
		assert_true(search.done);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_step_is_as_long_as_the_error_leaves_room),
		cmocka_unit_test(test_the_bound_itself_is_kept),
		cmocka_unit_test(
			test_a_step_stays_between_what_fits_and_what_does_not),
		cmocka_unit_test(test_a_search_ends_close_to_what_does_not_fit),
		cmocka_unit_test(test_a_search_finds_the_largest_value_that_fits),
		cmocka_unit_test(test_a_clip_beyond_the_bound_keeps_more_keys),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
