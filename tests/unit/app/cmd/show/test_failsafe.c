#include "app/cmd/show/failsafe.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static struct failsafe start(const char *path, const char *demo, int64_t now_ms,
	struct options *options, const struct log *log)
{
	*options = options_default();
	options->show.failsafe = path;
	options->show.demo = demo;
	options->show.character = "x.character";
	options->motion.clip = "walk";
	return failsafe_begin(options, now_ms, log);
}

static void test_a_minute_clears_the_count(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "starts");
	struct log log = log_to_nowhere();
	struct options options;
	struct failsafe failsafe;

	(void)state;
	failsafe = start(path.text, "arm", 1000, &options, &log);
	assert_int_equal(access(path.text, F_OK), 0);
	failsafe_feed(&failsafe, 60999);
	assert_int_equal(access(path.text, F_OK), 0);
	failsafe_feed(&failsafe, 61000);
	assert_int_not_equal(access(path.text, F_OK), 0);
	failsafe_end(&failsafe, false);
	failsafe = start(path.text, "arm", 0, &options, &log);
	assert_false(failsafe.gives_way);
	assert_string_equal(options.show.demo, "arm");
	temp_dir_remove(&folder);
}

static void test_two_bad_starts_in_a_row_give_way(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "starts");
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	struct options options;
	struct failsafe failsafe;

	(void)state;
	for (int i = 0; i < 2; i++) {
		failsafe = start(path.text, "arm", 0, &options, &log);
		assert_false(failsafe.gives_way);
		failsafe_end(&failsafe, false);
	}
	assert_int_equal(capture.count, 0);
	failsafe = start(path.text, "face", 0, &options, &log);
	assert_false(failsafe.gives_way);
	failsafe_end(&failsafe, false);
	for (int i = 0; i < 2; i++) {
		failsafe = start(path.text, "arm", 0, &options, &log);
		failsafe_end(&failsafe, false);
	}
	for (int i = 0; i < 3; i++) {
		failsafe = start(path.text, "arm", 0, &options, &log);
		assert_true(failsafe.gives_way);
		assert_string_equal(failsafe.name, "arm");
		assert_null(options.show.demo);
		assert_null(options.show.character);
		assert_null(options.motion.clip);
		failsafe_end(&failsafe, i == 1);
	}
	assert_int_equal(log_capture_count(&capture, LOG_WARNING), 3);
	temp_dir_remove(&folder);
}

static void test_the_built_in_demo_is_not_counted(void **state)
{
	static const char *const demos[] = {NULL, "walker"};
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "starts");
	struct log log = log_to_nowhere();
	struct options options;

	(void)state;
	for (int i = 0; i < 2; i++) {
		struct failsafe failsafe =
			start(path.text, demos[i], 0, &options, &log);

		assert_false(failsafe.gives_way);
		assert_int_not_equal(access(path.text, F_OK), 0);
		assert_string_equal(options.show.character, "x.character");
		failsafe_end(&failsafe, false);
	}
	temp_dir_remove(&folder);
}

/* Starts with a counting file of this content; returns what it holds then. */
static char *started_with(
	const char *content, struct log_capture *said, bool *gives_way)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "starts");
	const struct log log = log_capture_begin(said);
	struct options options;
	char *text;

	file_write(path.text, content, strlen(content));
	*gives_way = start(path.text, "arm", 0, &options, &log).gives_way;
	text = file_read(path.text, NULL);
	temp_dir_remove(&folder);
	return text;
}

/* Only "limber failsafe", a digit and this demo count on; "0 0" is no model. */
static void test_a_file_of_another_start_counts_anew(void **state)
{
	static const struct {
		const char *before, *after;
	} cases[] = {
		{"", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe 0 0 0 arm\n", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe 1 0 0 arm\n", "limber failsafe 2 0 0 arm\n"},
		{"limber failsafe 1 0 0 face\n", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe 1 0 0 arm", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe 3 0 0 arm\n", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe / 0 0 arm\n", "limber failsafe 1 0 0 arm\n"},
		{"limber failsafe ", "limber failsafe 1 0 0 arm\n"},
	};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		struct log_capture said;
		bool gives_way;
		char *text = started_with(cases[i].before, &said, &gives_way);

		assert_string_equal(text, cases[i].after);
		assert_false(gives_way);
		assert_int_equal(said.count, 0);
		free(text);
	}
}

static void test_the_file_that_gives_way_stays_as_it_is(void **state)
{
	static const char two[] = "limber failsafe 2 0 0 arm\n";
	struct log_capture said;
	bool gives_way;
	char *text = started_with(two, &said, &gives_way);

	(void)state;
	assert_true(gives_way);
	assert_string_equal(text, two);
	assert_contains(said.sentence[0], "arm: it ended limber 2 times");
	free(text);
}

static void test_a_file_of_the_users_is_not_replaced(void **state)
{
	static const char *const texts[] = {
		"my notes\n", "limber failsafe", "limber failsafE 1 0 0 arm\n"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(texts); i++) {
		struct log_capture said;
		bool gives_way;
		char *text = started_with(texts[i], &said, &gives_way);

		assert_string_equal(text, texts[i]);
		assert_false(gives_way);
		assert_int_equal(log_capture_count(&said, LOG_WARNING), 1);
		assert_contains(said.sentence[0],
			"limber did not write this file: starts are not counted");
		free(text);
	}
}

/* A model is told by its path and content, and called by its file's name. */
static void test_a_model_gives_way_until_its_file_changes(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "starts");
	struct test_path model = path_join(&folder, "robot.glb");
	struct log log = log_to_nowhere();
	struct options options;
	struct failsafe failsafe;

	(void)state;
	file_write(model.text, "1", 1);
	for (int i = 0; i <= 3; i++) {
		if (i == 3) {
			file_write(model.text, "12", 2);
		}
		options = options_default();
		options.show.failsafe = path.text;
		options.model_path = model.text;
		failsafe = failsafe_begin(&options, 0, &log);
		assert_int_equal(failsafe.gives_way, i == 2);
		assert_string_equal(failsafe.name, i == 2 ? "robot.glb" : "");
		assert_int_equal(options.model_path == NULL, i == 2);
		failsafe_end(&failsafe, false);
	}
	temp_dir_remove(&folder);
}

/* The link may lead to a file system that survives. */
static void test_a_link_stays_and_its_file_becomes_empty(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path file = path_join(&folder, "file");
	struct test_path path = path_join(&folder, "starts");
	struct log log = log_to_nowhere();
	struct options options;
	struct failsafe failsafe;
	char *text;

	(void)state;
	file_write(file.text, "", 0);
	assert_int_equal(symlink(file.text, path.text), 0);
	failsafe = start(path.text, "arm", 0, &options, &log);
	text = file_read(file.text, NULL);
	assert_string_equal(text, "limber failsafe 1 0 0 arm\n");
	free(text);
	failsafe_end(&failsafe, true);
	text = file_read(path.text, NULL);
	assert_string_equal(text, "");
	free(text);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_minute_clears_the_count),
		cmocka_unit_test(test_two_bad_starts_in_a_row_give_way),
		cmocka_unit_test(test_the_built_in_demo_is_not_counted),
		cmocka_unit_test(test_a_file_of_another_start_counts_anew),
		cmocka_unit_test(test_the_file_that_gives_way_stays_as_it_is),
		cmocka_unit_test(test_a_file_of_the_users_is_not_replaced),
		cmocka_unit_test(test_a_model_gives_way_until_its_file_changes),
		cmocka_unit_test(test_a_link_stays_and_its_file_becomes_empty),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
