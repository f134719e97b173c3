/* Looking for files and opening them, named pipes among them. */
#define _DEFAULT_SOURCE /* usleep() */

#include "platform/base/compiler.h"
#include "platform/base/file.h"
#include "tests/support/files.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

/* A named pipe, and the descriptors of this test that hold it open. */
struct pipe_bench {
	struct test_path folder, path;
	int reader, writer; /* -1 while closed */
};

static struct pipe_bench make_pipe(void)
{
	struct pipe_bench bench = {temp_dir_make(), .reader = -1, .writer = -1};

	bench.path = path_join(&bench.folder, "pipe");
	assert_int_equal(mkfifo(bench.path.text, 0600), 0);
	return bench;
}

/* A reader, so that opening the pipe for writing does not wait. */
static struct pipe_bench make_written_pipe(void)
{
	struct pipe_bench bench = make_pipe();

	bench.reader = open(bench.path.text, O_RDONLY | O_NONBLOCK);
	bench.writer = open(bench.path.text, O_WRONLY);
	assert_true(bench.reader >= 0 && bench.writer >= 0);
	return bench;
}

static void remove_pipe(struct pipe_bench *bench)
{
	if (bench->reader >= 0) {
		close(bench->reader);
	}
	temp_dir_remove(&bench->folder);
}

static void expect_content(FILE *file, const char *text, size_t size)
{
	char found[64];

	assert_non_null(file);
	assert_int_equal(fread(found, 1, sizeof(found), file), size);
	assert_memory_equal(found, text, size);
	assert_int_equal(fclose(file), 0);
}

static void test_a_pipe_that_no_program_writes_to_is_refused(void **state)
{
	struct pipe_bench bench = make_pipe();

	(void)state;
	errno = 0;
	assert_null(file_open(bench.path.text));
	assert_int_equal(errno, EPIPE);
	remove_pipe(&bench);
}

static void test_nothing_of_a_pipe_is_lost(void **state)
{
	(void)state;
	for (int first = 0; first < 256; first += 51) {
		const char text[] = {(char)first, 'o', '\n', '\0', 't'};
		struct pipe_bench bench = make_written_pipe();
		FILE *file;

		assert_int_equal(
			write(bench.writer, text, sizeof(text)), sizeof(text));
		file = file_open(bench.path.text);
		close(bench.writer);
		expect_content(file, text, sizeof(text));
		remove_pipe(&bench);
	}
}

static void test_a_slow_writer_is_waited_for(void **state)
{
	struct pipe_bench bench = make_written_pipe();
	FILE *file = file_open(bench.path.text);
	pid_t child = fork();
	int status;

	(void)state;
	if (child == 0) {
		usleep(50000);
		_exit(write(bench.writer, "late", 4) != 4);
	}
	close(bench.writer);
	expect_content(file, "late", 4);
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_int_equal(status, 0);
	remove_pipe(&bench);
}

static void test_other_files_are_opened_as_by_fopen(void **state)
{
	FILE *file = file_open("/dev/null");

	(void)state;
	expect_content(file, "", 0);
	errno = 0;
	assert_null(file_open("/no/such/file"));
	assert_int_equal(errno, ENOENT);
}

static void test_anything_at_a_path_exists(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "file");

	(void)state;
	assert_true(file_exists(folder.text));
	assert_false(file_exists(path.text));
	file_write(path.text, "", 0);
	assert_true(file_exists(path.text));
	temp_dir_remove(&folder);
}

/* Gives a file the modification time, and returns its stamp. */
static uint64_t stamp_at(const char *path, time_t second, long nanosecond)
{
	const struct timespec times[2] = {
		{.tv_sec = second, .tv_nsec = nanosecond},
		{.tv_sec = second, .tv_nsec = nanosecond}};

	assert_int_equal(utimensat(AT_FDCWD, path, times, 0), 0);
	return file_stamp(path);
}

static void test_a_stamp_changes_with_the_file(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "file");
	struct test_path second = path_join(&folder, "second");
	uint64_t stamp[6];

	(void)state;
	assert_true(file_stamp(path.text) == 0);
	file_write(path.text, "some", 4);
	stamp[0] = stamp_at(path.text, 100, 5);
	stamp[1] = stamp_at(path.text, 101, 5);
	stamp[2] = stamp_at(path.text, 100, 6);
	stamp[3] = stamp_at(path.text, 5, 100);
	assert_true(stamp_at(path.text, 100, 5) == stamp[0]);
	file_write(second.text, "some", 4);
	stamp[4] = stamp_at(second.text, 100, 5);
	file_write(path.text, "more text", 9);
	stamp[5] = stamp_at(path.text, 100, 5);
	for (int i = 0; i < 6; i++) {
		assert_true(stamp[i] != 0);
		for (int k = 0; k < i; k++) {
			assert_true(stamp[i] != stamp[k]);
		}
	}
	temp_dir_remove(&folder);
}

static void test_files_of_the_program_are_found(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path own = path_join(&folder, "walker.glb");
	struct log_capture heard;
	struct log log = log_capture_begin(&heard);
	struct stat found, expected;
	char path[600];

	(void)state;
	assert_int_equal(unsetenv("LIMBER_ASSETS"), 0);
	assert_int_equal(
		file_find_asset("walker.glb", &log, path, sizeof(path)), 0);
	assert_int_equal(stat(path, &found), 0);
	assert_int_equal(stat("assets/walker.glb", &expected), 0);
	assert_true(found.st_ino == expected.st_ino);
	/* The folder that the environment names comes first. */
	assert_int_equal(setenv("LIMBER_ASSETS", folder.text, 1), 0);
	assert_int_equal(
		file_find_asset("walker.glb", &log, path, sizeof(path)), 0);
	assert_string_not_equal(path, own.text);
	file_write(own.text, "", 0);
	assert_int_equal(
		file_find_asset("walker.glb", &log, path, sizeof(path)), 0);
	assert_string_equal(path, own.text);
	assert_int_equal(
		file_find_asset("walker.glb", &log, path, strlen(own.text) + 1),
		0);
	assert_int_equal(heard.count, 0);
	assert_int_equal(
		file_find_asset("none.glb", &log, path, sizeof(path)), -ENOENT);
	assert_int_equal(heard.count, 1);
	assert_contains(heard.sentence[0], "none.glb: not found: ");
	assert_int_equal(unsetenv("LIMBER_ASSETS"), 0);
	temp_dir_remove(&folder);
}

static void test_a_path_that_does_not_fit_is_not_given(void **state)
{
	struct log log = log_to_nowhere();
	char path[4];

	(void)state;
	assert_int_equal(setenv("LIMBER_ASSETS", "assets", 1), 0);
	assert_int_equal(file_find_asset("walker.glb", &log, path, sizeof(path)),
		-ENOENT);
	assert_int_equal(unsetenv("LIMBER_ASSETS"), 0);
}

static void test_a_file_that_cannot_be_opened_has_its_advice(void **state)
{
	static const struct {
		int error;
		const char *demand;
	} cases[] = {{ENOENT, "check the name"}, {ENOTDIR, "check the name"},
		{EACCES, "let this user read it"}, {EPERM, "let this user"},
		{ELOOP, "the file itself"}, {ENAMETOOLONG, "a shorter name"},
		{EPIPE, "start the program"}};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(cases); i++) {
		const char *advice = file_open_advice(cases[i].error);

		assert_contains(advice, ": ");
		assert_contains(advice, cases[i].demand);
	}
	assert_string_equal(file_open_advice(EIO), "");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_pipe_that_no_program_writes_to_is_refused),
		cmocka_unit_test(test_nothing_of_a_pipe_is_lost),
		cmocka_unit_test(test_a_slow_writer_is_waited_for),
		cmocka_unit_test(test_other_files_are_opened_as_by_fopen),
		cmocka_unit_test(test_anything_at_a_path_exists),
		cmocka_unit_test(test_a_stamp_changes_with_the_file),
		cmocka_unit_test(test_files_of_the_program_are_found),
		cmocka_unit_test(test_a_path_that_does_not_fit_is_not_given),
		cmocka_unit_test(
			test_a_file_that_cannot_be_opened_has_its_advice),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
