#include "app/cmd/show/failsafe.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_minute_clears_the_count),
		cmocka_unit_test(test_two_bad_starts_in_a_row_give_way),
		cmocka_unit_test(test_the_built_in_demo_is_not_counted),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
