/*
 * Standard descriptors that are closed when the program begins, and files that
 * are written when they are. Each case is a process of its own.
 */
#include "platform/base/output_file.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <fcntl.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

/* The status of a process that runs the function and ends with its result. */
static int status_of(int (*run)(int argument), int argument)
{
	pid_t child = fork();
	int status = -1;

	assert_true(child >= 0);
	if (child == 0) {
		_exit(run(argument));
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

static bool is_open(int fd)
{
	return fcntl(fd, F_GETFD) >= 0;
}

/* closed has a bit for each standard descriptor. Returns 0, or what is wrong. */
static int begin_without(int closed)
{
	for (int fd = 0; fd < 3; fd++) {
		if (closed & 1 << fd) {
			close(fd);
		}
	}
	output_file_prepare_process();
	for (int fd = 0; fd < 3; fd++) {
		char byte = 'x';

		if (!is_open(fd)) {
			return 1 + fd;
		}
		/* What takes its place is nothing to write to or to read from. */
		if (closed & 1 << fd &&
			(write(fd, &byte, 1) >= 0 || read(fd, &byte, 1) >= 0)) {
			return 4 + fd;
		}
	}
	return open("/dev/null", O_RDONLY) > 2 ? 0 : 7;
}

static void test_files_never_get_the_number_of_a_standard_one(void **state)
{
	(void)state;
	for (int closed = 0; closed < 8; closed++) {
		assert_int_equal(status_of(begin_without, closed), 0);
	}
}

static int begin_with_all(int unused)
{
	int last = dup(0);

	(void)unused;
	close(last);
	output_file_prepare_process();
	return is_open(last) ? 1 : 0;
}

static void test_open_descriptors_are_left_alone(void **state)
{
	(void)state;
	assert_int_equal(status_of(begin_with_all, 0), 0);
}

/* The file of a descriptor keeps what was written to it before. */
static int write_to_each(int fd)
{
	struct log log = log_to_nowhere();
	struct output_file *file;
	FILE *kept = tmpfile();
	char path[32], text[32] = "";

	snprintf(path, sizeof(path), "/dev/fd/%d", fd);
	if (!kept || write(fileno(kept), "first ", 6) != 6 ||
		dup2(fileno(kept), fd) != fd ||
		output_file_create(path, &log, &file) != 0) {
		return 1;
	}
	fputs("second", output_file_stream(file));
	if (output_file_commit(file) != 0) {
		return 2;
	}
	return pread(fileno(kept), text, sizeof(text) - 1, 0) == 12 &&
			strcmp(text, "first second") == 0
		? 0
		: 3;
}

static void test_each_descriptor_can_be_written_to(void **state)
{
	(void)state;
	for (int fd = 0; fd < 12; fd++) {
		assert_int_equal(status_of(write_to_each, fd), 0);
	}
}

/* A file of standard output, while a standard descriptor is closed. */
static int write_without(int closed)
{
	struct log log = log_to_nowhere();
	struct output_file *file;
	int error;

	close(closed);
	if (output_file_create("/dev/fd/1", &log, &file) != 0) {
		return 1;
	}
	if (is_open(closed)) {
		return 2;
	}
	fputs("text", output_file_stream(file));
	error = output_file_commit(file);
	return error ? 3 : is_open(1) ? 0 : 4;
}

static void test_a_copy_of_a_descriptor_is_no_standard_one(void **state)
{
	struct test_path folder = temp_dir_make();
	struct test_path path = path_join(&folder, "out");
	int kept = dup(STDOUT_FILENO);
	int fd = open(path.text, O_WRONLY | O_CREAT | O_TRUNC, 0600);
	int without_input, without_errors;

	(void)state;
	assert_true(kept >= 0 && fd >= 0);
	fflush(stdout);
	dup2(fd, STDOUT_FILENO);
	close(fd);
	without_input = status_of(write_without, STDIN_FILENO);
	without_errors = status_of(write_without, STDERR_FILENO);
	dup2(kept, STDOUT_FILENO);
	close(kept);
	assert_int_equal(without_input, 0);
	assert_int_equal(without_errors, 0);
	temp_dir_remove(&folder);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(
			test_files_never_get_the_number_of_a_standard_one),
		cmocka_unit_test(test_open_descriptors_are_left_alone),
		cmocka_unit_test(test_each_descriptor_can_be_written_to),
		cmocka_unit_test(test_a_copy_of_a_descriptor_is_no_standard_one),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
