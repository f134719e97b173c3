#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/run.h"
#include "tests/support/test.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void test_log_capture_keeps_level_and_sentence(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	log_error(&log, "a.glb: %s", "is empty");
	log_note(&log, "two");
	assert_int_equal(capture.count, 2);
	assert_string_equal(capture.sentence[0], "a.glb: is empty");
	assert_true(log_capture_has(&capture, LOG_NOTE, "two"));
	assert_false(log_capture_has(&capture, LOG_ERROR, "two"));
	assert_int_equal(log_capture_count(&capture, LOG_ERROR), 1);
}

static void test_log_capture_counts_beyond_its_capacity(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	for (int i = 0; i < LOG_CAPTURE_CAPACITY + 3; i++) {
		log_error(&log, "%d", i);
	}
	assert_int_equal(capture.count, LOG_CAPTURE_CAPACITY + 3);
	assert_int_equal(
		log_capture_count(&capture, LOG_ERROR), LOG_CAPTURE_CAPACITY);
}

static void test_temp_dir_holds_files_and_goes_away(void **state)
{
	struct test_path directory = temp_dir_make();
	struct test_path file = path_join(&directory, "a");
	size_t size;
	char *data;

	(void)state;
	file_write(file.text, "x\0y", 3);
	data = file_read(file.text, &size);
	assert_int_equal(size, 3);
	assert_memory_equal(data, "x\0y", 4);
	free(data);
	temp_dir_remove(&directory);
	assert_int_not_equal(access(directory.text, F_OK), 0);
}

static void test_run_takes_exit_code_and_both_outputs(void **state)
{
	const char *const argv[] = {
		"sh", "-c", "echo out; echo err >&2; exit 3", NULL};
	struct run_result result = run_command(argv, 10);

	(void)state;
	assert_int_equal(result.exit_code, 3);
	assert_string_equal(result.out, "out\n");
	assert_string_equal(result.err, "err\n");
	run_release(&result);
}

static void test_run_reports_a_signal(void **state)
{
	const char *const argv[] = {"sh", "-c", "kill -9 $$", NULL};
	struct run_result result = run_command(argv, 10);

	(void)state;
	assert_int_equal(result.exit_code, 128 + 9);
	run_release(&result);
}

static void test_near_is_within_the_tolerance(void **state)
{
	(void)state;
	assert_true(test_is_near(1.0, 1.0, 0));
	assert_true(test_is_near(1.0, 1.04, 0.05));
	assert_true(test_is_near(-INFINITY, -INFINITY, 0));
	assert_false(test_is_near(1.0, 1.06, 0.05));
	assert_false(test_is_near(INFINITY, -INFINITY, 1e9));
}

static void test_nothing_is_near_a_nan(void **state)
{
	(void)state;
	assert_false(test_is_near(NAN, 1, 1e9));
	assert_false(test_is_near(1, NAN, 1e9));
	assert_false(test_is_near(NAN, NAN, 1e9));
}

int main(void)
{
	static const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_log_capture_keeps_level_and_sentence),
		cmocka_unit_test(test_log_capture_counts_beyond_its_capacity),
		cmocka_unit_test(test_temp_dir_holds_files_and_goes_away),
		cmocka_unit_test(test_run_takes_exit_code_and_both_outputs),
		cmocka_unit_test(test_run_reports_a_signal),
		cmocka_unit_test(test_near_is_within_the_tolerance),
		cmocka_unit_test(test_nothing_is_near_a_nan),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
