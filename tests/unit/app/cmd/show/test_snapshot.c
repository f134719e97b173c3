/* The pictures that a button keeps: their names, and what is said of them. */
#include "app/cmd/show/snapshot.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <unistd.h>

/* A run of the program in a folder of its own, whose output goes to a file. */
struct run {
	struct test_path folder, output;
	struct log_capture said;
	struct snapshot snapshot;
	int home, terminal; /* the former folder and standard output */
};

static int begin(void **state)
{
	struct run *run = calloc(1, sizeof(*run));
	int file;

	assert_non_null(run);
	run->folder = temp_dir_make();
	run->output = path_join(&run->folder, "output");
	run->home = open(".", O_RDONLY);
	fflush(stdout);
	run->terminal = dup(STDOUT_FILENO);
	file = open(run->output.text, O_CREAT | O_WRONLY, 0600);
	assert_true(run->home >= 0 && run->terminal >= 0 && file >= 0);
	assert_int_equal(dup2(file, STDOUT_FILENO), STDOUT_FILENO);
	close(file);
	assert_int_equal(chdir(run->folder.text), 0);
	*state = run;
	return 0;
}

static int end(void **state)
{
	struct run *run = *state;

	fflush(stdout);
	dup2(run->terminal, STDOUT_FILENO);
	close(run->terminal);
	assert_int_equal(fchdir(run->home), 0);
	close(run->home);
	temp_dir_remove(&run->folder);
	free(run);
	return 0;
}

static void take(struct run *run)
{
	static uint8_t data[2][2][4];
	const struct pixels picture = {&data[0][0][0], 2, 2, 8, PIXELS_RGBA8888};
	const struct log log = log_capture_begin(&run->said);

	snapshot_take(&run->snapshot, &picture, &log);
}

static void expect_output(const struct run *run, const char *wanted)
{
	char *text = file_read(run->output.text, NULL);

	assert_string_equal(text, wanted);
	free(text);
}

static void test_a_picture_is_announced_once_it_is_written(void **state)
{
	struct run *run = *state;

	take(run);
	snapshot_finish(&run->snapshot);
	assert_int_equal(access("limber-0001.png", R_OK), 0);
	expect_output(run, "limber: the picture is in limber-0001.png\n");
	assert_int_equal(run->said.count, 0);
	snapshot_finish(&run->snapshot);
}

static void test_the_first_free_number_is_taken(void **state)
{
	struct run *run = *state;

	file_write("limber-0001.png", "1", 1);
	file_write("limber-0003.png", "3", 1);
	take(run);
	take(run);
	snapshot_finish(&run->snapshot);
	expect_output(run,
		"limber: the picture is in limber-0002.png\n"
		"limber: the picture is in limber-0004.png\n");
	assert_int_equal(temp_dir_count(&run->folder), 4 + 1);
}

static void test_there_are_9999_numbers(void **state)
{
	struct run *run = *state;

	for (int number = 1; number < 9999; number++) {
		char path[32];

		snprintf(path, sizeof(path), "limber-%04d.png", number);
		assert_int_equal(symlink("/dev/null", path), 0);
	}
	take(run);
	snapshot_finish(&run->snapshot);
	expect_output(run, "limber: the picture is in limber-9999.png\n");
	take(run);
	snapshot_finish(&run->snapshot);
	expect_output(run, "limber: the picture is in limber-9999.png\n");
	assert_int_equal(log_capture_count(&run->said, LOG_ERROR), 1);
	assert_contains(run->said.sentence[0],
		"limber-9999.png: all numbers up to this one are in use");
	assert_int_equal(access("limber-10000.png", F_OK), -1);
}

static void test_a_picture_that_is_not_written_is_an_error(void **state)
{
	struct run *run = *state;

	assert_int_equal(mkdir("lost", 0700), 0);
	assert_int_equal(chdir("lost"), 0);
	assert_int_equal(rmdir("../lost"), 0);
	take(run);
	snapshot_finish(&run->snapshot);
	expect_output(run, "");
	assert_int_equal(log_capture_count(&run->said, LOG_ERROR), 1);
	assert_contains(run->said.sentence[0], "limber-0001.png");
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, begin, end)
	static const struct CMUnitTest tests[] = {
		CASE(test_a_picture_is_announced_once_it_is_written),
		CASE(test_the_first_free_number_is_taken),
		CASE(test_there_are_9999_numbers),
		CASE(test_a_picture_that_is_not_written_is_an_error),
	};
#undef CASE

	return cmocka_run_group_tests(tests, NULL, NULL);
}
