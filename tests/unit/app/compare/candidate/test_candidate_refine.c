/* Which moments are added between those of the grid to find the peak. */
#include "tests/support/test.h"
#include "tests/unit/app/compare/candidate/measure_bench.h"

#include <float.h>
#include <math.h>

static float rises_late(float time_s)
{
	return time_s * time_s * time_s;
}

static float falls_early(float time_s)
{
	return rises_late(1.0f - time_s);
}

static float bends_little(float time_s)
{
	return 1.0f + 0.04f * time_s * (1.0f - time_s);
}

static float bends_much(float time_s)
{
	return 1.0f + 0.16f * time_s * (1.0f - time_s);
}

/* The least that may be missed is a fortieth of the peak or of a pixel. */
static void test_moments_are_added_where_the_error_bends(void **state)
{
	static const struct {
		float (*scale_at)(float);
		float peak_px;
		bool divided;
	} cases[] = {
		{scale_of_1, 10, false},
		{rises_late, 10, true},
		{falls_early, 10, true},
		{bends_little, 10, false},
		{bends_much, 10, true},
		{bends_much, 0.6f, false},
		{bends_much, 0.7f, true},
		{rises_late, 0.06f, false},
		{falls_early, 0.06f, false},
		{rises_late, 0.08f, true},
		{falls_early, 0.08f, true},
	};
	struct bench bench;

	(void)state;
	begin(&bench);
	for (size_t i = 0; i < sizeof(cases) / sizeof(cases[0]); i++) {
		struct candidate_error error;

		bench.scale_at = cases[i].scale_at;
		bench.moved[0][0] = cases[i].peak_px / 10.0f;
		error = measure(&bench, 2, 2);
		assert_int_equal(error.samples > 3, cases[i].divided);
	}
	end(&bench);
}

static float peaks_at_third(float time_s)
{
	return 1.0f - sqrtf(fabsf(time_s - 1.0f / 3.0f));
}

static float peaks_at_two_thirds(float time_s)
{
	return 1.0f - sqrtf(fabsf(time_s - 2.0f / 3.0f));
}

/* Intervals are halved until they are short. */
static void test_a_sharp_peak_is_found_in_any_interval(void **state)
{
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.moved[0][0] = 1.0f;
	for (int moments = 2; moments < 7; moments++) {
		struct candidate_error error;

		bench.scale_at = peaks_at_third;
		error = measure(&bench, moments, 2);
		assert_in_range((int)(100.0f * error.peak_px), 965, 1000);
		assert_near(error.peak_s, 1.0 / 3.0, 2e-3);
		bench.scale_at = peaks_at_two_thirds;
		error = measure(&bench, moments, 2);
		assert_in_range((int)(100.0f * error.peak_px), 965, 1000);
		assert_near(error.peak_s, 2.0 / 3.0, 2e-3);
	}
	end(&bench);
}

static float waves(float time_s)
{
	return 1.0f + 0.5f * sinf(29.0f * time_s);
}

static float falls_and_rises(float time_s)
{
	return fabsf(1.0f - 2.3f * time_s);
}

static float jumps(float time_s)
{
	return time_s < 0.61803f ? 0.25f : 1.0f;
}

/* What the moments have to be, and the largest error at them. */
struct plan {
	float (*scale_at)(float time_s);
	float most_px, peak_px;
	int count;
	float time_s[POSED_MAX];
};

static float sample(struct plan *plan, float time_s)
{
	float px = plan->most_px * fabsf(plan->scale_at(time_s));

	assert_in_range(plan->count, 0, POSED_MAX - 1);
	plan->time_s[plan->count++] = time_s;
	plan->peak_px = fmaxf(plan->peak_px, px);
	return px;
}

/*
 * Halves the halves of an interval, up to ten times, while they may exceed the
 * peak by a fortieth of it, or of a pixel. They may exceed the largest of their
 * three samples by half of the second difference, which is four times what a
 * parabola through them would.
 */
static void plan_halves(struct plan *plan, float from_s, float from_px,
	float middle_s, float middle_px, float to_s, float to_px, int depth)
{
	float most = fmaxf(fmaxf(from_px, middle_px), to_px) +
		0.5f * fabsf(from_px - 2.0f * middle_px + to_px);
	float half_s, px;

	if (depth == 10 || middle_s <= from_s || to_s <= middle_s ||
		most <= plan->peak_px + 0.025f * fmaxf(1.0f, plan->peak_px)) {
		return;
	}
	half_s = 0.5f * (from_s + middle_s);
	px = sample(plan, half_s);
	plan_halves(plan, from_s, from_px, half_s, px, middle_s, middle_px,
		depth + 1);
	half_s = 0.5f * (middle_s + to_s);
	px = sample(plan, half_s);
	plan_halves(
		plan, middle_s, middle_px, half_s, px, to_s, to_px, depth + 1);
}

static void plan_grid(struct plan *plan, const struct time_grid *grid)
{
	float px[2 * MOMENTS_MAX];

	plan->count = 0;
	plan->peak_px = 0.0f;
	for (int i = 0; i < 2 * grid->count - 1; i++) {
		const float *at = grid->time_s + i / 2;

		if (i % 2 && time_grid_is_gap(grid, i / 2)) {
			continue;
		}
		px[i] = sample(plan, i % 2 ? 0.5f * (at[0] + at[1]) : at[0]);
	}
	for (int i = 0; i + 1 < grid->count; i++) {
		const float *at = grid->time_s + i;

		if (time_grid_is_gap(grid, i)) {
			continue;
		}
		plan_halves(plan, at[0], px[2 * i], 0.5f * (at[0] + at[1]),
			px[2 * i + 1], at[1], px[2 * i + 2], 0);
	}
}

static void expect_moments(
	struct bench *bench, const struct time_grid *grid, float most_px)
{
	static struct plan plan;
	struct candidate_error error;

	bench->moved[0][0] = most_px / 10.0f;
	plan.scale_at = bench->scale_at;
	plan.most_px = most_px;
	plan_grid(&plan, grid);
	error = measure_grid(bench, grid, 1);
	assert_int_equal(bench->posed_count, plan.count);
	for (int i = 0; i < plan.count; i++) {
		assert_near(bench->posed_s[i], plan.time_s[i], 0);
	}
	assert_int_equal(error.samples, plan.count);
	assert_near(error.peak_px, plan.peak_px, 1e-3 * (double)most_px);
}

static void test_the_moments_are_those_that_the_errors_demand(void **state)
{
	static float (*const shapes[])(float) = {scale_of_1, rises_late,
		falls_early, bends_little, bends_much, peaks_at_third,
		peaks_at_two_thirds, waves, falls_and_rises, jumps};
	static float even_s[] = {0.0f, 0.25f, 0.5f, 0.75f, 1.0f};
	static float uneven_s[] = {0.0f, 0.1f, 0.7f, 0.71f, 1.0f};
	static const float most_px[] = {0.07f, 0.9f, 1.1f, 30.0f};
	static float thin_s[] = {0.0f, 0.01f, 0.02f, 0.5f, 0.51f, 1.0f};
	static const struct time_grid grids[] = {{.time_s = even_s, .count = 5},
		{.time_s = thin_s, .count = 6, .thinned = true},
		{.time_s = thin_s, .count = 6}, {.time_s = uneven_s, .count = 5},
		{.time_s = even_s + 3, .count = 2}};
	struct bench bench;

	(void)state;
	begin(&bench);
	/* Points within 0.5 of each other need no projection. */
	bench.screen.px_per_unit = 10.5f;
	bench.screen.near_square = 0.25f;
	for (size_t i = 0; i < ARRAY_COUNT(shapes); i++) {
		bench.scale_at = shapes[i];
		for (size_t g = 0; g < ARRAY_COUNT(grids); g++) {
			for (size_t m = 0; m < ARRAY_COUNT(most_px); m++) {
				expect_moments(&bench, &grids[g], most_px[m]);
			}
		}
	}
	end(&bench);
}

static float rises_by_one_bit(float time_s)
{
	return time_s > 1.0f ? 1.0f : 0.0f;
}

static float falls_by_one_bit(float time_s)
{
	return time_s > 1.0f + FLT_EPSILON ? 0.0f : 1.0f;
}

/* Half of an interval of one bit is the one end of it or the other. */
static void test_moments_that_floats_cannot_part_are_not_halved(void **state)
{
	static float time_s[] = {
		1.0f, 1.0f + FLT_EPSILON, 1.0f + 2.0f * FLT_EPSILON};
	struct bench bench;

	(void)state;
	begin(&bench);
	bench.moved[0][0] = 1.0f;
	for (int falls = 0; falls < 2; falls++) {
		const struct time_grid grid = {
			.time_s = time_s + falls, .count = 2};
		struct candidate_error error;

		bench.scale_at = falls ? falls_by_one_bit : rises_by_one_bit;
		error = measure_grid(&bench, &grid, 1);
		assert_int_equal(error.samples, 3);
		assert_near(bench.posed_s[1], time_s[2 * falls], 0);
		assert_near(error.peak_px, 10, 1e-3);
	}
	end(&bench);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_moments_are_added_where_the_error_bends),
		cmocka_unit_test(test_a_sharp_peak_is_found_in_any_interval),
		cmocka_unit_test(
			test_the_moments_are_those_that_the_errors_demand),
		cmocka_unit_test(
			test_moments_that_floats_cannot_part_are_not_halved),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
