/*
 * How a run of play or render ends, by an error, a signal or what cannot be
 * opened, and which files it leaves.
 */
#include "tests/unit/app/cmd/show/show_run.h"

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

int main(void)
{
	static const struct CMUnitTest tests[] = {
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
