/*
 * Running a command and looking at what it says.
 */
#ifndef TESTS_SUPPORT_RUN_H
#define TESTS_SUPPORT_RUN_H

struct run_result {
	int exit_code; /* 128 + signal for a command that was killed */
	char *out;     /* all of standard output, zero-terminated */
	char *err;     /* all of standard error */
};

/*
 * Runs argv[0] (searched on PATH) with no standard input and waits for it;
 * SIGALRM ends it after timeout_s. Fails the running test when it cannot be
 * started at all. The caller ends with run_release().
 */
struct run_result run_command(const char *const argv[], unsigned timeout_s);

void run_release(struct run_result *result);

#endif
