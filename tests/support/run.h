/*
 * Runs a command and keeps its output.
 */
#ifndef TESTS_SUPPORT_RUN_H
#define TESTS_SUPPORT_RUN_H

struct run_result {
	int exit_code; /* 128 + signal for a command that was killed */
	char *out;     /* all of standard output, zero-terminated */
	char *err;     /* all of standard error */
};

/*
 * Runs argv[0], which is searched for on PATH, without standard input and waits
 * until it ends. SIGALRM ends it after timeout_s. Fails the running test when
 * the command cannot be started. The caller ends with run_release().
 */
struct run_result run_command(const char *const argv[], unsigned timeout_s);

void run_release(struct run_result *result);

#endif
