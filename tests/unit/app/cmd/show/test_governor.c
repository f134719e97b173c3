/* The governor, with times that the tests provide. */
#include "app/cmd/show/governor.h"
#include "platform/base/compiler.h"
#include "tests/support/test.h"

struct bench {
	struct governor governor;
	double now_s;
	int changes;
};

/* Feeds frames at 30 Hz for some seconds; their cost depends on the level. */
static void run(struct bench *bench, double seconds,
	const float cost_ms[GOVERNOR_STEPS + 1])
{
	int frames = (int)(seconds * 30.0 + 0.5);

	for (int i = 0; i < frames; i++) {
		bench->now_s += 1.0 / 30.0;
		bench->changes += governor_feed(&bench->governor, bench->now_s,
			cost_ms[bench->governor.level]);
	}
}

static const float cheap[] = {
	20.0f, 19.0f, 18.0f, 18.0f, 16.0f, 14.0f, 10.0f, 8.0f};
static const float dear[] = {
	45.0f, 42.0f, 38.0f, 31.0f, 29.0f, 27.0f, 22.0f, 18.0f};
static const float hopeless[] = {
	90.0f, 89.0f, 88.0f, 87.0f, 85.0f, 80.0f, 60.0f, 50.0f};
/* Frames fit after one step and slightly exceed the budget without it. */
static const float edge[] = {
	34.0f, 29.0f, 28.0f, 27.0f, 26.0f, 25.0f, 24.0f, 23.0f};

static struct bench begin(float budget_ms)
{
	return (struct bench){.governor = governor_begin(budget_ms)};
}

static void test_without_a_budget_quality_stays(void **state)
{
	struct bench bench = begin(0.0f);

	(void)state;
	run(&bench, 60.0, hopeless);
	assert_int_equal(bench.changes, 0);
	assert_null(governor_text(&bench.governor));
}

static void test_within_the_budget_quality_stays(void **state)
{
	struct bench bench = begin(33.0f);

	(void)state;
	run(&bench, 60.0, cheap);
	assert_int_equal(bench.changes, 0);
}

static void test_triangles_go_first_then_influences_normals_poses(void **state)
{
	struct bench bench = begin(33.0f);
	int level = 0;

	(void)state;
	while (bench.now_s < 60.0 && level < GOVERNOR_STEPS) {
		struct demo_reduction reduction;

		run(&bench, 1.0 / 30.0, hopeless);
		if (bench.governor.level == level) {
			continue;
		}
		assert_int_equal(bench.governor.level, ++level);
		reduction = governor_reduction(&bench.governor);
		assert_near(reduction.error_px, level == 1 ? 2.0f : 4.0f, 0.0);
		assert_int_equal(reduction.max_influences,
			level < 3            ? 0
				: level == 3 ? 2
					     : 1);
		assert_int_equal(reduction.hold_normals, level >= 5);
	}
	assert_int_equal(level, GOVERNOR_STEPS);
	assert_true(bench.now_s < 5.0);
	run(&bench, 10.0, hopeless);
	assert_int_equal(bench.changes, GOVERNOR_STEPS);
}

static void test_it_stops_at_the_first_level_that_fits(void **state)
{
	struct bench bench = begin(33.0f);

	(void)state;
	run(&bench, 20.0, dear);
	assert_int_equal(bench.governor.level, 3);
	assert_int_equal(bench.changes, 3);
}

static void test_quality_is_restored_when_frames_get_cheaper(void **state)
{
	struct bench bench = begin(33.0f);

	(void)state;
	run(&bench, 5.0, dear);
	assert_int_equal(bench.governor.level, 3);
	run(&bench, 20.0, cheap);
	assert_int_equal(bench.governor.level, 0);
	assert_null(governor_text(&bench.governor));
}

static void test_a_single_slow_frame_changes_nothing(void **state)
{
	static const float slow[] = {
		80.0f, 80.0f, 80.0f, 80.0f, 80.0f, 80.0f, 80.0f, 80.0f};
	struct bench bench = begin(33.0f);

	(void)state;
	for (int i = 0; i < 30; i++) {
		run(&bench, 1.0, cheap);
		run(&bench, 1.0 / 30.0, slow);
	}
	assert_int_equal(bench.changes, 0);
}

static void test_a_stopped_process_changes_nothing(void **state)
{
	static const float stops_ms[] = {1500.0f, 60e3f, 3600e3f};
	struct bench bench = begin(33.0f);

	(void)state;
	for (int i = 0; i < 3; i++) {
		run(&bench, 10.0, cheap);
		bench.now_s += stops_ms[i] / 1000.0;
		bench.changes += governor_feed(
			&bench.governor, bench.now_s, stops_ms[i]);
		run(&bench, 10.0, cheap);
		assert_int_equal(bench.changes, 0);
	}
}

/* Of machines that need much less than a millisecond, too. */
static void test_any_budget_above_none_is_kept(void **state)
{
	struct bench bench = begin(33.0f / 1024.0f);
	float small[GOVERNOR_STEPS + 1];

	(void)state;
	for (int i = 0; i <= GOVERNOR_STEPS; i++) {
		small[i] = dear[i] / 1024.0f;
	}
	run(&bench, 20.0, small);
	assert_int_equal(bench.governor.level, 3);
}

static void test_a_stop_takes_over_a_second_and_eight_times_the_frame_before(
	void **state)
{
	static const struct {
		float before_ms, ms;
		bool stopped;
	} rows[] = {{20.0f, 1000.0f, false}, {20.0f, 1000.5f, true},
		{100.0f, 900.0f, false}, {125.0f, 1000.5f, true},
		{200.0f, 1600.0f, false}, {200.0f, 1600.5f, true},
		{200.0f, 1599.5f, false}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(rows); i++) {
		struct bench bench = begin(33.0f);
		int frames;

		governor_feed(&bench.governor, 0.1, rows[i].before_ms);
		frames = bench.governor.frames;
		governor_feed(&bench.governor, 2.0, rows[i].ms);
		assert_int_equal(bench.governor.frames - frames,
			rows[i].stopped ? 0 : 1);
	}
}

static void test_frames_of_seconds_are_reduced(void **state)
{
	static const float seconds_ms[GOVERNOR_STEPS + 1] = {3000.0f, 3000.0f,
		3000.0f, 3000.0f, 3000.0f, 3000.0f, 3000.0f, 3000.0f};
	struct bench bench = begin(33.0f);

	(void)state;
	run(&bench, 10.0, cheap);
	run(&bench, 10.0, seconds_ms);
	assert_int_equal(bench.governor.level, GOVERNOR_STEPS);
}

static void test_it_does_not_flutter_at_the_edge(void **state)
{
	struct bench bench = begin(33.0f);

	(void)state;
	run(&bench, 300.0, edge);
	assert_int_equal(bench.governor.level, 1);
	assert_int_equal(bench.changes, 1);
}

/* A step costs more than it was measured to save: the wait grows. */
static void test_steps_that_do_not_last_come_ever_less_often(void **state)
{
	static const float cold[] = {
		60.0f, 20.0f, 20.0f, 20.0f, 20.0f, 20.0f, 20.0f, 20.0f};
	struct bench bench = begin(33.0f);
	int early;

	(void)state;
	run(&bench, 2.0, cold);
	bench.governor.saved_ms[1] = 0.0f;
	for (int i = 0; i < 20 * 30; i++) {
		run(&bench, 1.0 / 30.0, cold);
		bench.governor.saved_ms[1] = 0.0f;
	}
	early = bench.changes;
	for (int i = 0; i < 20 * 30; i++) {
		run(&bench, 1.0 / 30.0, cold);
		bench.governor.saved_ms[1] = 0.0f;
	}
	assert_true(early >= 5);
	assert_true(bench.changes - early <= early / 2);
}

static void test_poses_come_as_often_as_the_level_says(void **state)
{
	static const int expected[] = {16, 16, 16, 16, 16, 16, 8, 4};

	(void)state;
	for (int level = 0; level <= GOVERNOR_STEPS; level++) {
		struct governor governor = governor_begin(10.0f);
		int poses = 0;

		governor.level = level;
		for (int i = 0; i < 16; i++) {
			poses += governor_poses(&governor);
		}
		assert_int_equal(poses, expected[level]);
	}
}

/* Frames at 64 Hz, whose times are exact, of one cost; returns the changes. */
static int feed(struct bench *bench, int frames, float work_ms)
{
	int changes = 0;

	for (int i = 0; i < frames; i++) {
		bench->now_s += 1.0 / 64.0;
		changes +=
			governor_feed(&bench->governor, bench->now_s, work_ms);
	}
	return changes;
}

/* The first frames weigh the same, and later the newest has 15%. */
static void test_the_mean_follows_the_newest_frames(void **state)
{
	struct bench bench = begin(100.0f);

	(void)state;
	for (int i = 1; i <= 6; i++) {
		feed(&bench, 1, 10.0f * (float)i);
		assert_near(bench.governor.mean_ms, 5.0 + 5.0 * i, 1e-4);
	}
	feed(&bench, 1, 75.0f);
	assert_near(bench.governor.mean_ms, 0.85 * 35.0 + 0.15 * 75.0, 1e-4);
	feed(&bench, 1, 0.0f);
	assert_near(bench.governor.mean_ms, 0.85 * 41.0, 1e-4);
}

/* Eight frames, the last of which is over the budget, and 0.2 s more. */
static void test_a_step_is_taken_after_a_fifth_of_a_second(void **state)
{
	struct bench bench = begin(10.0f);

	(void)state;
	for (int level = 1; level <= GOVERNOR_STEPS; level++) {
		assert_int_equal(feed(&bench, 20, 10.5f), 0);
		assert_int_equal(feed(&bench, 1, 10.5f), 1);
		assert_int_equal(bench.governor.level, level);
	}
	bench = begin(10.0f);
	assert_int_equal(feed(&bench, 1000, 10.0f), 0);
}

/* A frame that is not over the budget begins the fifth of a second anew. */
static void test_the_time_over_the_budget_is_without_a_break(void **state)
{
	struct bench bench = begin(10.0f);

	(void)state;
	feed(&bench, 20, 10.5f);
	assert_int_equal(feed(&bench, 1, 1.0f), 0);
	/* The mean is over 10 ms again at the seventh frame. */
	assert_int_equal(feed(&bench, 7 + 12, 10.5f), 0);
	assert_int_equal(feed(&bench, 1, 10.5f), 1);
}

/* Begins at the first level, whose step is known to save some time. */
static struct bench begin_reduced(float saved_ms)
{
	struct bench bench = begin(10.0f);

	bench.governor.level = 1;
	bench.governor.saved_ms[1] = saved_ms;
	return bench;
}

/* 90% of the budget is 9 ms; it must be left for a second. */
static void test_a_step_is_taken_back_after_a_second_that_leaves_room(
	void **state)
{
	struct bench bench = begin_reduced(2.0f);

	(void)state;
	assert_int_equal(feed(&bench, 8 + 63, 6.9f), 0);
	assert_int_equal(feed(&bench, 1, 6.9f), 1);
	assert_int_equal(bench.governor.level, 0);
	bench = begin_reduced(2.0f);
	assert_int_equal(feed(&bench, 1000, 7.1f), 0);
}

static void test_what_a_step_saves_is_measured_after_it(void **state)
{
	struct bench bench = begin(10.0f);

	(void)state;
	feed(&bench, 21, 12.0f);
	feed(&bench, 7, 9.0f);
	assert_near(bench.governor.saved_ms[1], 0.0, 0.0);
	feed(&bench, 1, 9.0f);
	assert_near(bench.governor.saved_ms[1], 3.0, 1e-4);
	/* Later frames do not change it, and no step saves less than nothing. */
	feed(&bench, 10, 11.0f);
	assert_near(bench.governor.saved_ms[1], 3.0, 1e-4);
	bench = begin(10.0f);
	feed(&bench, 21, 12.0f);
	feed(&bench, 8, 13.0f);
	assert_near(bench.governor.saved_ms[1], 0.0, 0.0);
}

/* Takes a step, and returns after how many seconds of 1 ms it is taken back. */
static double seconds_reduced(struct bench *bench)
{
	int frames = 1;

	while (feed(bench, 1, 20.0f) == 0) {
	}
	assert_int_equal(bench->governor.level, 1);
	bench->governor.measuring = false;
	while (feed(bench, 1, 1.0f) == 0) {
		frames++;
	}
	assert_int_equal(bench->governor.level, 0);
	return (frames - 8) / 64.0;
}

static void test_the_wait_doubles_up_to_half_a_minute(void **state)
{
	static const double wanted_s[] = {1, 2, 4, 8, 16, 30, 30};
	struct bench bench = begin(10.0f);

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(wanted_s); i++) {
		assert_near(seconds_reduced(&bench), wanted_s[i], 0.0);
	}
}

/* It is the first second again after more than five without a step. */
static void test_five_seconds_without_a_step_end_the_doubling(void **state)
{
	(void)state;
	for (int more = 0; more <= 1; more++) {
		struct bench bench = begin(10.0f);

		seconds_reduced(&bench);
		/* The step comes at the seventeenth frame of 20 ms. */
		feed(&bench, 5 * 64 - 17 + more, 1.0f);
		assert_near(seconds_reduced(&bench), more ? 1.0 : 2.0, 0.0);
	}
}

static void test_each_level_has_a_name(void **state)
{
	static const char *const names[GOVERNOR_STEPS] = {"triangles to 2 px",
		"triangles to 4 px", "2 influences", "1 influence",
		"normals held", "half the poses", "a quarter of poses"};
	struct governor governor = governor_begin(10.0f);

	(void)state;
	for (int i = 0; i < GOVERNOR_STEPS; i++) {
		governor.level = i + 1;
		assert_string_equal(governor_text(&governor), names[i]);
	}
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_without_a_budget_quality_stays),
		cmocka_unit_test(test_within_the_budget_quality_stays),
		cmocka_unit_test(
			test_triangles_go_first_then_influences_normals_poses),
		cmocka_unit_test(test_it_stops_at_the_first_level_that_fits),
		cmocka_unit_test(
			test_quality_is_restored_when_frames_get_cheaper),
		cmocka_unit_test(test_a_single_slow_frame_changes_nothing),
		cmocka_unit_test(test_a_stopped_process_changes_nothing),
		cmocka_unit_test(test_any_budget_above_none_is_kept),
		cmocka_unit_test(
			test_a_stop_takes_over_a_second_and_eight_times_the_frame_before),
		cmocka_unit_test(test_frames_of_seconds_are_reduced),
		cmocka_unit_test(test_it_does_not_flutter_at_the_edge),
		cmocka_unit_test(
			test_steps_that_do_not_last_come_ever_less_often),
		cmocka_unit_test(test_poses_come_as_often_as_the_level_says),
		cmocka_unit_test(test_the_mean_follows_the_newest_frames),
		cmocka_unit_test(test_a_step_is_taken_after_a_fifth_of_a_second),
		cmocka_unit_test(
			test_the_time_over_the_budget_is_without_a_break),
		cmocka_unit_test(
			test_a_step_is_taken_back_after_a_second_that_leaves_room),
		cmocka_unit_test(test_what_a_step_saves_is_measured_after_it),
		cmocka_unit_test(test_the_wait_doubles_up_to_half_a_minute),
		cmocka_unit_test(
			test_five_seconds_without_a_step_end_the_doubling),
		cmocka_unit_test(test_each_level_has_a_name),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
