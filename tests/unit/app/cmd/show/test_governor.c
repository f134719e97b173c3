/* The governor, with times that the tests provide. */
#include "app/cmd/show/governor.h"
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
		cmocka_unit_test(test_it_does_not_flutter_at_the_edge),
		cmocka_unit_test(
			test_steps_that_do_not_last_come_ever_less_often),
		cmocka_unit_test(test_poses_come_as_often_as_the_level_says),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
