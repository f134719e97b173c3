/* Opening files for reading, named pipes among them. */
#define _DEFAULT_SOURCE /* usleep() */

#include "platform/base/file.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
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
	static const char text[] = "\0one\ntwo";
	struct pipe_bench bench = make_written_pipe();
	FILE *file;

	(void)state;
	assert_int_equal(write(bench.writer, text, sizeof(text)), sizeof(text));
	file = file_open(bench.path.text);
	close(bench.writer);
	expect_content(file, text, sizeof(text));
	remove_pipe(&bench);
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

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_a_pipe_that_no_program_writes_to_is_refused),
		cmocka_unit_test(test_nothing_of_a_pipe_is_lost),
		cmocka_unit_test(test_a_slow_writer_is_waited_for),
		cmocka_unit_test(test_other_files_are_opened_as_by_fopen),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
