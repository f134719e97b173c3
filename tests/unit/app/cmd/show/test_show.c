/*
 * Whole runs of play and render: which moments a demo is updated for, and which
 * buttons it gets.
 */
#include "tests/unit/app/cmd/show/show_run.h"

#include <jansson.h>
#include <stdlib.h>

/* The last frames are drawn; those before them are skipped to. */
static void check_updates(const double *wanted_s, int count)
{
	assert_int_equal(noted.updates, count);
	for (int i = 0; i < count; i++) {
		assert_near(noted.updated_s[i], wanted_s[i], 1e-9);
	}
}

static void test_a_fixed_clock_skips_to_the_begin_at_its_rate(void **state)
{
	static const double wanted_s[] = {0.0, 0.1, 0.2, 0.25, 0.35};
	struct run *run = *state;

	run->plan.begin_s = 0.25;
	run->plan.frames = 2;
	assert_int_equal(shown(run), EXIT_OK);
	check_updates(wanted_s, 5);
	assert_int_equal(run->said.count, 0);
}

/* 60 updates a second, none of them at the begin, where the first frame is. */
static void test_the_real_clock_skips_to_the_begin_at_60_hz(void **state)
{
	enum {
		SKIPPED = 6
	};
	struct run *run = *state;

	run->plan.clock = clock_real();
	run->plan.begin_s = 5.5 / 60.0;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, SKIPPED + 1);
	for (int i = 0; i < SKIPPED; i++) {
		assert_near(noted.updated_s[i], i / 60.0, 1e-9);
	}
	assert_true(noted.updated_s[SKIPPED] >= run->plan.begin_s);
}

static void test_nothing_is_skipped_at_the_begin(void **state)
{
	static const double wanted_s[] = {0.0, 0.1, 0.2};
	struct run *run = *state;

	run->plan.frames = 3;
	assert_int_equal(shown(run), EXIT_OK);
	check_updates(wanted_s, 3);
}

/* To the nearest frame, and at least one. */
static void test_a_period_is_a_whole_number_of_frames(void **state)
{
	static const struct {
		double period_s;
		int frames;
	} cases[] = {{0.34, 3}, {0.36, 4}, {1.0, 10}, {0.1, 1}, {0.0, 1}};
	struct run *run = *state;

	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		noted.updates = 0;
		noted.period_s = cases[i].period_s;
		run->plan.frames = -1;
		assert_int_equal(shown(run), EXIT_OK);
		assert_int_equal(noted.updates, cases[i].frames);
	}
}

/* Updates without a picture up to the begin, and then those of the frames. */
static void test_a_whole_period_begins_where_it_repeats(void **state)
{
	static const struct {
		int frames, updates;
		bool unattended;
		double begin_s;
	} cases[] = {{-1, 4, true, 0.0}, {-1, 3, true, 0.1}, {3, 3, true, 0.0},
		{-1, 2, false, 0.0}};
	struct run *run = *state;

	run->demo.settled_s = noted_period_s;
	noted.period_s = 0.2;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		noted.updates = 0;
		run->plan.frames = cases[i].frames;
		run->plan.unattended = cases[i].unattended;
		run->plan.begin_s = cases[i].begin_s;
		assert_int_equal(shown(run), EXIT_OK);
		check_updates((double[]){0.0, 0.1, 0.2, 0.3}, cases[i].updates);
	}
}

static void test_a_script_presses_buttons_from_the_first_update_on(void **state)
{
	static const struct button_event wanted[] = {{50, BUTTON_UP, true, 0},
		{150, BUTTON_UP, false, 0}, {220, BUTTON_F6, true, 0},
		{260, BUTTON_F6, false, 0}};
	struct run *run = *state;

	press_by_script(run);
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.presses, 4);
	for (int i = 0; i < 4; i++) {
		assert_int_equal(noted.pressed[i].time_ms, wanted[i].time_ms);
		assert_int_equal(noted.pressed[i].button, wanted[i].button);
		assert_int_equal(noted.pressed[i].down, wanted[i].down);
	}
}

static void test_a_button_has_the_action_of_another_or_none(void **state)
{
	struct run *run = *state;

	press_by_script(run);
	run->options.input.action[BUTTON_UP] = BUTTON_ENTER;
	run->options.input.action[BUTTON_F6] = BUTTON_COUNT;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.presses, 2);
	assert_int_equal(noted.pressed[0].button, BUTTON_ENTER);
	assert_int_equal(noted.pressed[1].button, BUTTON_ENTER);
}

static void test_events_are_recorded_as_a_script(void **state)
{
	struct run *run = *state;
	struct test_path record = path_join(&run->folder, "record.txt");
	char *text;

	press_by_script(run);
	run->options.input.action[BUTTON_UP] = BUTTON_ENTER;
	run->options.input.record_buttons = record.text;
	assert_int_equal(shown(run), EXIT_OK);
	text = file_read(record.text, NULL);
	assert_string_equal(
		text, "50 UP down\n150 UP up\n220 F6 down\n260 F6 up\n");
	free(text);
}

static json_t *stats_of(struct run *run)
{
	struct test_path path = path_join(&run->folder, "stats.json");
	json_t *stats;

	run->options.show.stats = path.text;
	assert_int_equal(shown(run), EXIT_OK);
	stats = json_load_file(path.text, 0, NULL);
	assert_non_null(stats);
	return stats;
}

static int integer(const json_t *object, const char *key)
{
	return (int)json_integer_value(json_object_get(object, key));
}

/* Skipped updates are no frames. A fixed clock's presses have no latency. */
static void test_stats_count_drawn_frames_and_presses_in_real_time(void **state)
{
	struct run *run = *state;
	json_t *fixed, *real;

	press_by_script(run);
	fixed = stats_of(run);
	run->plan.clock = clock_real();
	run->options.show.fps = 1000.0;
	run->plan.begin_s = 0.3;
	real = stats_of(run);
	assert_int_equal(integer(fixed, "frames"), 3);
	assert_int_equal(integer(fixed, "presses"), 0);
	assert_int_equal(integer(real, "frames"), 3);
	assert_int_equal(integer(real, "presses"), 4);
	json_decref(fixed);
	json_decref(real);
}

/* The fifth frame is due after at least four periods. */
static void test_frames_of_the_real_clock_keep_to_the_pace(void **state)
{
	struct run *run = *state;

	run->plan.clock = clock_real();
	run->plan.frames = 5;
	run->options.show.fps = 100.0;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, 5);
	assert_true(noted.updated_s[0] >= 0.0);
	assert_true(noted.updated_s[4] - noted.updated_s[0] >= 0.03);
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		SHOW_TEST(test_a_fixed_clock_skips_to_the_begin_at_its_rate),
		SHOW_TEST(test_the_real_clock_skips_to_the_begin_at_60_hz),
		SHOW_TEST(test_nothing_is_skipped_at_the_begin),
		SHOW_TEST(test_a_period_is_a_whole_number_of_frames),
		SHOW_TEST(test_a_whole_period_begins_where_it_repeats),
		SHOW_TEST(test_a_script_presses_buttons_from_the_first_update_on),
		SHOW_TEST(test_a_button_has_the_action_of_another_or_none),
		SHOW_TEST(test_events_are_recorded_as_a_script),
		SHOW_TEST(test_stats_count_drawn_frames_and_presses_in_real_time),
		SHOW_TEST(test_frames_of_the_real_clock_keep_to_the_pace),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
