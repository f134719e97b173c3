#include "tests/support/run.h"

#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static char *take_all(FILE *file)
{
	long size;
	char *text;

	assert_int_equal(fseek(file, 0, SEEK_END), 0);
	size = ftell(file);
	assert_true(size >= 0);
	rewind(file);
	text = malloc((size_t)size + 1);
	assert_non_null(text);
	assert_int_equal(fread(text, 1, (size_t)size, file), size);
	text[size] = '\0';
	fclose(file);
	return text;
}

static void become(const char *const argv[], int out, int err, int failure,
	unsigned timeout_s)
{
	int none = open("/dev/null", O_RDONLY);

	if (none >= 0 && dup2(none, 0) == 0 && dup2(out, 1) == 1 &&
		dup2(err, 2) == 2) {
		alarm(timeout_s);
		/* execvp() does not write to the strings. */
		execvp(argv[0], (char *const *)(uintptr_t)argv);
	}
	if (write(failure, &errno, sizeof(errno)) < 0) {
		_exit(126);
	}
	_exit(127);
}

struct run_result run_command(const char *const argv[], unsigned timeout_s)
{
	struct run_result result = {0};
	FILE *out = tmpfile();
	FILE *err = tmpfile();
	int failure[2];
	int cause = 0;
	int status;
	pid_t child;

	assert_non_null(out);
	assert_non_null(err);
	assert_int_equal(pipe(failure), 0);
	assert_int_equal(fcntl(failure[1], F_SETFD, FD_CLOEXEC), 0);
	fflush(stdout);
	child = fork();
	assert_true(child >= 0);
	if (child == 0) {
		become(argv, fileno(out), fileno(err), failure[1], timeout_s);
	}
	close(failure[1]);
	if (read(failure[0], &cause, sizeof(cause)) > 0) {
		print_error("%s: %s\n", argv[0], strerror(cause));
	}
	close(failure[0]);
	while (waitpid(child, &status, 0) < 0) {
		assert_int_equal(errno, EINTR);
	}
	assert_int_equal(cause, 0);
	result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status)
					     : 128 + WTERMSIG(status);
	result.out = take_all(out);
	result.err = take_all(err);
	return result;
}

void run_release(struct run_result *result)
{
	free(result->out);
	free(result->err);
	*result = (struct run_result){0};
}
