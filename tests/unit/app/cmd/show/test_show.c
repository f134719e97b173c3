/*
 * Whole runs of play and render: which moments a demo is updated for, which
 * buttons it gets, how a run ends and which files it leaves.
 */
#include "app/cmd/command.h"
#include "app/cmd/show/show.h"
#include "platform/process/confine.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <jansson.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>

enum {
	NOTED_MAX = 64
};

/* What the demo below was asked to do; its functions carry no context. */
static struct {
	double updated_s[NOTED_MAX];
	int updates;
	struct button_event pressed[NOTED_MAX];
	int presses;
	double period_s;
	const struct log *log;
	int error_at, signal_at; /* the update that causes it; -1: none */
	bool signal_first;       /* comes while the demo is prepared */
	bool connects, writes_anywhere;
} noted;

/* Replaces limber's: tests go on after a run, and the leak check needs rights. */
struct confinement confine_process(
	const struct confine_request *request, const struct log *log)
{
	(void)log;
	noted.connects = request->connects;
	noted.writes_anywhere = request->writes_anywhere;
	return (struct confinement){false, false};
}

static int note_prepare(struct demo *demo, const struct demo_env *env)
{
	noted.log = env->log;
	if (noted.signal_first) {
		raise(SIGTERM);
		log_error(env->log, "a made-up error of what was cut short");
	}
	return demo_driver_viewer.prepare(demo, env);
}

static void note_update(struct demo *demo, double time_s)
{
	assert_true(noted.updates < NOTED_MAX);
	if (noted.updates == noted.error_at) {
		log_error(noted.log, "a made-up error");
	}
	if (noted.updates == noted.signal_at) {
		raise(SIGTERM);
	}
	noted.updated_s[noted.updates++] = time_s;
	demo_driver_viewer.update(demo, time_s);
}

static void note_press(struct demo *demo, const struct button_event *event)
{
	(void)demo;
	assert_true(noted.presses < NOTED_MAX);
	noted.pressed[noted.presses++] = *event;
}

static double noted_period_s(const struct demo *demo)
{
	(void)demo;
	return noted.period_s;
}

/* A run that shows a model on nothing; each test changes what it is about. */
struct run {
	struct demo_driver demo;
	struct test_path model, folder;
	struct show_plan plan;
	struct options options;
	struct log_capture said;
};

static int begin(void **state)
{
	static struct run run;

	memset(&noted, 0, sizeof(noted));
	noted.error_at = noted.signal_at = -1;
	run = (struct run){
		.demo = demo_driver_viewer,
		.model = fixture_path("gltf/clip/cubic.gltf"),
		.folder = temp_dir_make(),
		.options = options_default(),
	};
	run.demo.prepare = note_prepare;
	run.demo.update = note_update;
	run.demo.press = note_press;
	run.demo.period_s = noted_period_s;
	run.plan = (struct show_plan){
		.demo = &run.demo,
		.model_path = run.model.text,
		.display = "null",
		.clock = clock_fixed(10.0, 0.0),
		.frames = 1,
	};
	run.options.screen.size.width = 40;
	run.options.screen.size.height = 30;
	run.options.screen.gl = "soft";
	*state = &run;
	return 0;
}

static int end(void **state)
{
	struct run *run = *state;

	temp_dir_remove(&run->folder);
	return 0;
}

static int shown(struct run *run)
{
	const struct log log = log_capture_begin(&run->said);

	return show_run(&run->plan, &run->options, &log);
}

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

/* The script's presses before the begin reach the demo, too. */
static void press_by_script(struct run *run)
{
	static const char script[] =
		"50 UP down\n150 UP up\n220 F6 down\n260 F6 up\n";
	static struct test_path path;

	path = path_join(&run->folder, "script.txt");
	file_write(path.text, script, sizeof(script) - 1);
	run->options.input.script = path.text;
	run->plan.begin_s = 0.2;
	run->plan.frames = 3;
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

static void draw_to_gif(struct run *run)
{
	static struct test_path path;

	path = path_join(&run->folder, "film.gif");
	run->plan.display = "image";
	run->options.screen.output = path.text;
	run->plan.frames = 3;
}

static void test_an_error_leaves_no_film_and_no_stats(void **state)
{
	struct run *run = *state;
	struct test_path stats = path_join(&run->folder, "stats.json");

	draw_to_gif(run);
	run->options.show.stats = stats.text;
	noted.error_at = 2;
	assert_int_equal(shown(run), EXIT_FAILED);
	assert_int_equal(noted.updates, 3);
	assert_int_equal(log_capture_count(&run->said, LOG_ERROR), 1);
	assert_int_equal(temp_dir_count(&run->folder), 0);
}

/* A screen shows the next frame. */
static void test_an_error_does_not_end_what_is_shown(void **state)
{
	struct run *run = *state;

	run->plan.frames = 3;
	noted.error_at = 1;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, 3);
}

/* The update or frame that begins after the signal is the last. */
static void test_a_signal_ends_what_is_shown_in_order(void **state)
{
	struct run *run = *state;

	run->plan.frames = 0;
	noted.signal_at = 4;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, 6);
	assert_int_equal(run->said.count, 0);
}

static void test_a_signal_while_the_model_loads_ends_in_order(void **state)
{
	struct run *run = *state;

	noted.signal_first = true;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, 0);
	assert_int_equal(run->said.count, 0);
	draw_to_gif(run);
	assert_int_equal(shown(run), EXIT_FAILED);
	assert_int_equal(noted.updates, 0);
	assert_int_equal(run->said.count, 1);
	assert_true(log_capture_has(
		&run->said, LOG_ERROR, "a signal stopped limber before"));
	assert_int_equal(temp_dir_count(&run->folder), 0);
}

static void test_a_signal_leaves_no_incomplete_file(void **state)
{
	struct run *run = *state;

	draw_to_gif(run);
	run->plan.frames = 30;
	noted.signal_at = 1;
	assert_int_equal(shown(run), EXIT_FAILED);
	assert_int_equal(noted.updates, 3);
	assert_true(log_capture_has(
		&run->said, LOG_ERROR, "a signal stopped limber before"));
	assert_int_equal(temp_dir_count(&run->folder), 0);
}

static void test_a_signal_while_skipping_ends_the_run(void **state)
{
	struct run *run = *state;

	run->plan.begin_s = 2.0;
	noted.signal_at = 2;
	assert_int_equal(shown(run), EXIT_OK);
	assert_int_equal(noted.updates, 4);
}

static void test_the_run_may_write_files_but_not_connect(void **state)
{
	struct run *run = *state;

	noted.connects = true;
	assert_int_equal(shown(run), EXIT_OK);
	assert_false(noted.connects);
	assert_true(noted.writes_anywhere);
}

/* What cannot be opened ends the run before the first update. */
static void test_what_cannot_be_opened_fails(void **state)
{
	struct run *run = *state;
	struct test_path path = path_join(&run->folder, "missing/file.gif");
	const char **const options[] = {&run->options.show.stats,
		&run->options.show.record, &run->options.input.record_buttons,
		&run->options.input.script};

	for (size_t i = 0; i < ARRAY_COUNT(options); i++) {
		*options[i] = path.text;
		assert_int_equal(shown(run), EXIT_FAILED);
		assert_int_equal(log_capture_count(&run->said, LOG_ERROR), 1);
		assert_contains(run->said.sentence[0], path.text);
		*options[i] = NULL;
	}
	run->plan.model_path = path.text;
	assert_int_equal(shown(run), EXIT_FAILED);
	assert_contains(run->said.sentence[0], path.text);
	assert_int_equal(noted.updates, 0);
}

/*
 * Whatever fails, what was opened before it is given back, as the sanitizers
 * see, and no file stays that the run has begun.
 */
static void test_a_run_that_fails_gives_back_what_it_has_opened(void **state)
{
	struct run *run = *state;
	struct test_path missing = path_join(&run->folder, "missing/a.gif");
	struct test_path record = path_join(&run->folder, "record.txt");
	struct test_path stats = path_join(&run->folder, "stats.json");
	struct test_path film = path_join(&run->folder, "film.gif");

	for (int what = 0; what < 6; what++) {
		run->options.input.record_buttons = record.text;
		run->options.show.stats = stats.text;
		run->options.show.record = film.text;
		run->options.show.user = NULL;
		run->plan.display = "null";
		run->plan.model_path = run->model.text;
		press_by_script(run);
		*(const char **[]){&run->options.input.record_buttons,
			&run->plan.display, &run->options.show.user,
			&run->plan.model_path, &run->options.show.stats,
			&run->options.show.record}[what] = missing.text;
		assert_int_not_equal(shown(run), EXIT_OK);
		assert_int_equal(noted.updates, 0);
		assert_int_equal(temp_dir_count(&run->folder), 1);
	}
}

static void test_a_wrong_camera_is_a_wrong_command_line(void **state)
{
	struct run *run = *state;

	run->options.input.camera = "no-such-camera";
	assert_int_equal(shown(run), EXIT_USAGE);
	assert_int_equal(noted.updates, 0);
}

/* Several test functions share begin() and end(). */
#define SHOW_TEST(name) cmocka_unit_test_setup_teardown(name, begin, end)

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
		SHOW_TEST(test_an_error_leaves_no_film_and_no_stats),
		SHOW_TEST(test_an_error_does_not_end_what_is_shown),
		SHOW_TEST(test_a_signal_ends_what_is_shown_in_order),
		SHOW_TEST(test_a_signal_while_the_model_loads_ends_in_order),
		SHOW_TEST(test_a_signal_leaves_no_incomplete_file),
		SHOW_TEST(test_a_signal_while_skipping_ends_the_run),
		SHOW_TEST(test_the_run_may_write_files_but_not_connect),
		SHOW_TEST(test_what_cannot_be_opened_fails),
		SHOW_TEST(test_a_run_that_fails_gives_back_what_it_has_opened),
		SHOW_TEST(test_a_wrong_camera_is_a_wrong_command_line),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
