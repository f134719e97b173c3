/* The moments at which errors are measured, for clips that the tests make up. */
#include "app/compare/measure/time_grid.h"
#include "tests/support/test.h"

#include <errno.h>
#include <math.h>

static const float gap_s = 1.0f / 60.0f;

/* A clip of one channel with these key times. */
struct bench {
	struct model_channel channel[2];
	struct model_clip clip;
	struct time_grid grid;
};

static void set(struct model_channel *channel,
	enum model_interpolation interpolation, int count, const float *time_s)
{
	*channel = (struct model_channel){.path = MODEL_TRANSLATION,
		.interpolation = interpolation,
		.width = 3,
		.key_count = count,
		.time_s = time_s};
}

static void begin(struct bench *bench, enum model_interpolation interpolation,
	float duration_s, int count, const float *time_s)
{
	*bench = (struct bench){.clip = {.duration_s = duration_s,
					.channel_count = 1,
					.channel = bench->channel}};
	set(&bench->channel[0], interpolation, count, time_s);
}

static void make(struct bench *bench)
{
	struct time_grid *grid = &bench->grid;

	assert_int_equal(time_grid_make(&bench->clip, grid), 0);
	assert_true(grid->count >= 2);
	assert_near(grid->time_s[0], 0.0, 0.0);
	assert_near(grid->time_s[grid->count - 1], bench->clip.duration_s, 0.0);
	for (int i = 1; i < grid->count; i++) {
		assert_true(grid->time_s[i] > grid->time_s[i - 1]);
		assert_true(grid->time_s[i] - grid->time_s[i - 1] <=
			gap_s * 1.002f);
	}
}

static bool has(const struct bench *bench, float time_s)
{
	for (int i = 0; i < bench->grid.count; i++) {
		if (bench->grid.time_s[i] == time_s) {
			return true;
		}
	}
	return false;
}

static void expect(
	struct bench *bench, const float *time_s, int count, float tolerance)
{
	make(bench);
	assert_int_equal(bench->grid.count, count);
	assert_all_near(bench->grid.time_s, time_s, count, tolerance);
	time_grid_release(&bench->grid);
	assert_int_equal(bench->grid.count, 0);
	assert_null(bench->grid.time_s);
}

static void test_keys_60_hz_apart_are_the_moments(void **state)
{
	static const float keys[] = {0, 1 / 60.0f, 2 / 60.0f, 3 / 60.0f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 3 / 60.0f, 4, keys);
	expect(&bench, keys, 4, 0);
}

static void test_keys_far_apart_get_moments_between(void **state)
{
	static const float keys[] = {0, 0.05f, 0.07f};
	static const float wanted[] = {
		0, 0.05f / 3, 0.1f / 3, 0.05f, 0.06f, 0.07f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 0.07f, 3, keys);
	expect(&bench, wanted, 6, 1e-7f);
}

static void test_of_keys_close_together_one_counts(void **state)
{
	static const float keys[] = {
		0, 1 / 80.0f, 0.0201f, 0.0249f, 0.0251f, 0.0375f};
	static const float wanted[] = {0, 1 / 80.0f, 0.0251f, 0.0375f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_CUBICSPLINE, 0.0375f, 6, keys);
	expect(&bench, wanted, 4, 0);
}

static void test_a_jump_has_a_moment_before_it(void **state)
{
	static const float keys[] = {0, 0.005f, 0.006f, 0.015f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_STEP, 0.015f, 4, keys);
	make(&bench);
	assert_int_equal(bench.grid.count, 7);
	for (int i = 1; i < 4; i++) {
		assert_true(has(&bench, keys[i]));
		assert_true(has(&bench, nextafterf(keys[i], 0.0f)));
	}
	time_grid_release(&bench.grid);
}

/* Of two channels with a key at one time, one jumps. */
static void test_all_channels_that_change_have_moments(void **state)
{
	static const float smooth[] = {0, 0.004f, 0.008f, 0.013f};
	static const float jumps[] = {0.008f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 0.02f, 4, smooth);
	set(&bench.channel[1], MODEL_STEP, 1, jumps);
	bench.clip.channel_count = 2;
	make(&bench);
	assert_true(has(&bench, 0.008f));
	assert_true(has(&bench, nextafterf(0.008f, 0.0f)));
	assert_false(has(&bench, 0.004f));
	time_grid_release(&bench.grid);
	bench.channel[1].constant = true;
	make(&bench);
	assert_false(has(&bench, 0.008f));
	assert_true(has(&bench, 0.013f));
	time_grid_release(&bench.grid);
}

/* Channels may have keys before and behind the clip. */
static void test_keys_outside_the_clip_do_not_count(void **state)
{
	static const float keys[] = {-1, 0.01f, 0.5f};
	static const float wanted[] = {0, 0.0125f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_STEP, 0.0125f, 3, keys);
	make(&bench);
	assert_int_equal(bench.grid.count, 4);
	assert_true(has(&bench, 0.01f));
	assert_true(has(&bench, nextafterf(0.01f, 0.0f)));
	time_grid_release(&bench.grid);
	bench.channel[0].interpolation = MODEL_LINEAR;
	expect(&bench, wanted, 2, 0);
}

static void test_a_clip_of_more_than_five_hours_is_refused(void **state)
{
	static const float keys[] = {0};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 18000.0f, 1, keys);
	assert_int_equal(time_grid_make(&bench.clip, &bench.grid), 0);
	assert_in_range(bench.grid.count, 18000 * 60 + 1, 18000 * 60 + 50000);
	time_grid_release(&bench.grid);
	bench.clip.duration_s = 18001.0f;
	assert_int_equal(time_grid_make(&bench.clip, &bench.grid), -E2BIG);
	assert_null(bench.grid.time_s);
	assert_int_equal(bench.grid.count, 0);
}

static void test_added_moments_are_sorted_and_not_repeated(void **state)
{
	static const float keys[] = {0, 1 / 60.0f};
	static const float more[] = {0.003f, 0.0f, 0.002f, 0.003f};
	static const float wanted[] = {0, 0.002f, 0.003f, 1 / 60.0f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 1 / 60.0f, 2, keys);
	make(&bench);
	assert_int_equal(time_grid_add(&bench.grid, more, 4), 0);
	assert_int_equal(bench.grid.count, 4);
	assert_all_near(bench.grid.time_s, wanted, 4, 0);
	time_grid_release(&bench.grid);
}

/* The clip's phases, in tenths of a motion that repeats each second. */
static unsigned phases_of(const struct time_grid *grid)
{
	unsigned met = 0;

	for (int i = 0; i < grid->count - 1; i++) {
		if (!time_grid_is_gap(grid, i)) {
			met |= 1u << (int)(fmodf(grid->time_s[i], 1.0f) * 10.0f);
		}
	}
	return met;
}

static void test_a_thinned_grid_meets_all_phases_of_its_clip(void **state)
{
	static const float keys_s[] = {0.0f, 200.0f};
	struct bench bench;
	const struct time_grid *grid = &bench.grid;
	int whole, gaps = 0;

	(void)state;
	begin(&bench, MODEL_LINEAR, 200.0f, 2, keys_s);
	make(&bench);
	whole = grid->count;
	for (int i = 0; i < whole - 1; i++) {
		assert_false(time_grid_is_gap(grid, i));
	}
	/* One interval of each second. */
	time_grid_thin(&bench.grid, 2.0 / 60.0);
	assert_in_range(grid->count, whole / 32, whole / 28);
	assert_near(grid->time_s[0], 0.0, 0.0);
	assert_near(grid->time_s[grid->count - 1], 200.0, 0.0);
	for (int i = 0; i < grid->count - 1; i++) {
		assert_true(grid->time_s[i] < grid->time_s[i + 1]);
		gaps += time_grid_is_gap(grid, i);
	}
	assert_in_range(gaps, 195, 201);
	assert_int_equal(phases_of(grid), (1 << 10) - 1);
	time_grid_release(&bench.grid);
}

/*
 * Of ten intervals, five in turn: from a half of their pairs on, 0.118, 0.736,
 * 0.354 and 0.972 of them, by the golden ratio. Two of them begin where the one
 * before ends.
 */
static void test_a_thinned_grid_keeps_places_by_the_golden_ratio(void **state)
{
	static const float keys_s[] = {0.0f, 10 / 60.0f};
	static const int kept[] = {0, 1, 2, 3, 5, 6, 7, 9, 10};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 10 / 60.0f, 2, keys_s);
	make(&bench);
	assert_int_equal(bench.grid.count, 11);
	time_grid_thin(&bench.grid, 1.0);
	assert_int_equal(bench.grid.count, ARRAY_COUNT(kept));
	for (int i = 0; i < bench.grid.count; i++) {
		assert_near(bench.grid.time_s[i], kept[i] / 60.0, 1e-6);
		assert_true(i + 1 == bench.grid.count ||
			time_grid_is_gap(&bench.grid, i) ==
				(kept[i + 1] > kept[i] + 1));
	}
	time_grid_release(&bench.grid);
}

static void test_a_thinned_grid_has_an_interval_in_the_middle(void **state)
{
	static const float keys_s[] = {0.0f, 10 / 60.0f};
	static const int kept[] = {0, 5, 6, 10};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 10 / 60.0f, 2, keys_s);
	make(&bench);
	time_grid_thin(&bench.grid, 1e-6);
	assert_int_equal(bench.grid.count, ARRAY_COUNT(kept));
	for (int i = 0; i < bench.grid.count; i++) {
		assert_near(bench.grid.time_s[i], kept[i] / 60.0, 1e-6);
	}
	time_grid_release(&bench.grid);
}

static void test_a_grid_of_one_interval_stays(void **state)
{
	static const float keys_s[] = {0.0f, 0.01f};
	struct bench bench;

	(void)state;
	begin(&bench, MODEL_LINEAR, 0.01f, 2, keys_s);
	make(&bench);
	time_grid_thin(&bench.grid, 1e-3);
	assert_int_equal(bench.grid.count, 2);
	assert_near(bench.grid.time_s[1], 0.01, 1e-9);
	time_grid_release(&bench.grid);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_keys_60_hz_apart_are_the_moments),
		cmocka_unit_test(test_keys_far_apart_get_moments_between),
		cmocka_unit_test(test_of_keys_close_together_one_counts),
		cmocka_unit_test(test_a_jump_has_a_moment_before_it),
		cmocka_unit_test(test_all_channels_that_change_have_moments),
		cmocka_unit_test(test_keys_outside_the_clip_do_not_count),
		cmocka_unit_test(test_a_clip_of_more_than_five_hours_is_refused),
		cmocka_unit_test(test_added_moments_are_sorted_and_not_repeated),
		cmocka_unit_test(
			test_a_thinned_grid_meets_all_phases_of_its_clip),
		cmocka_unit_test(
			test_a_thinned_grid_keeps_places_by_the_golden_ratio),
		cmocka_unit_test(
			test_a_thinned_grid_has_an_interval_in_the_middle),
		cmocka_unit_test(test_a_grid_of_one_interval_stays),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
