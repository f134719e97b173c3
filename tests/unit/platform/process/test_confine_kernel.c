/*
 * Confinement by a kernel that lacks some of it, which a filter simulates, and
 * of outputs for which it has no rule.
 */
#define _GNU_SOURCE

#include "platform/process/confine.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <linux/filter.h>
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

static bool has_seccomp(void)
{
	uint32_t action = SECCOMP_RET_ERRNO;

	return syscall(SYS_seccomp, SECCOMP_GET_ACTION_AVAIL, 0, &action) == 0;
}

static bool has_landlock(void)
{
	return syscall(SYS_landlock_create_ruleset, NULL, 0,
		       LANDLOCK_CREATE_RULESET_VERSION) > 0;
}

/* The call fails from now on as in a kernel that does not know it. */
static void forget_call(int number)
{
	struct sock_filter filter[] = {
		BPF_STMT(BPF_LD | BPF_W | BPF_ABS,
			(uint32_t)offsetof(struct seccomp_data, nr)),
		BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, (uint32_t)number, 0, 1),
		BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | ENOSYS),
		BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
	};
	const struct sock_fprog program = {ARRAY_COUNT(filter), filter};

	if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 ||
		prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
		_exit(2);
	}
}

static bool says(const struct log_capture *heard, int at, const char *missing)
{
	char note[80];

	snprintf(note, sizeof(note), "confinement: this kernel has no %s",
		missing);
	return strcmp(heard->sentence[at], note) == 0;
}

/* Exits with 0 if confinement says of this kernel what it lacks. */
static void confine_without(bool calls, bool files)
{
	const struct confine_request request = {.connects = false};
	struct log_capture heard;
	const struct log log = log_capture_begin(&heard);
	bool has_files = has_landlock() && !files;
	bool has_calls = has_seccomp() && !calls;
	struct confinement held;

	if (files) {
		forget_call(SYS_landlock_create_ruleset);
	}
	if (calls) {
		forget_call(SYS_seccomp);
	}
	held = confine_process(&request, &log);
	_exit(held.calls == has_calls && held.files == has_files &&
				heard.count == !has_calls + !has_files &&
				(has_calls || says(&heard, 0, "seccomp")) &&
				(has_files ||
					says(&heard, !has_calls, "Landlock"))
			? 0
			: 1);
}

static void test_a_note_says_what_the_kernel_lacks(void **state)
{
	(void)state;
	for (int i = 0; i < (has_seccomp() ? 4 : 1); i++) {
		pid_t child = fork();
		int status = -1;

		if (child == 0) {
			confine_without(i & 1, i & 2);
		}
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_int_equal(status, 0);
	}
}

/* Exits with 0 if files are not confined where the kernel lacks the call. */
static void confine_files_without(int call)
{
	const struct confine_request request = {.output = {"/tmp/x"}};
	struct log_capture heard;
	const struct log log = log_capture_begin(&heard);
	struct confinement held;

	forget_call(call);
	held = confine_process(&request, &log);
	_exit(!held.files && says(&heard, heard.count - 1, "Landlock") ? 0 : 1);
}

static void test_each_call_of_landlock_that_fails_is_told(void **state)
{
	static const int calls[] = {SYS_landlock_create_ruleset,
		SYS_landlock_add_rule, SYS_landlock_restrict_self};

	(void)state;
	if (!has_landlock() || !has_seccomp()) {
		skip_because("this kernel has no Landlock or no seccomp");
	}
	for (size_t i = 0; i < ARRAY_COUNT(calls); i++) {
		pid_t child = fork();
		int status = -1;

		if (child == 0) {
			confine_files_without(calls[i]);
		}
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_int_equal(status, 0);
	}
}

/* One descriptor is free: for the rules, but not for the output's folder. */
static void confine_with_one_descriptor(void)
{
	const struct confine_request request = {.output = {"/tmp/x"}};
	struct log_capture heard;
	const struct log log = log_capture_begin(&heard);
	int next = dup(STDERR_FILENO);
	struct rlimit limit = {(rlim_t)next + 1, (rlim_t)next + 1};
	struct confinement held;

	close(next);
	if (setrlimit(RLIMIT_NOFILE, &limit) != 0) {
		_exit(2);
	}
	held = confine_process(&request, &log);
	_exit(!held.files &&
				strcmp(heard.sentence[0],
					"confinement: limber runs without Landlock: Too many open files") ==
					0
			? 0
			: 1);
}

/* Otherwise no output could be written, and the folder would be blamed. */
static void test_a_lack_of_descriptors_does_not_refuse_outputs(void **state)
{
	pid_t child;
	int status = -1;

	(void)state;
	if (!has_landlock()) {
		skip_because("this kernel has no Landlock");
	}
	child = fork();
	if (child == 0) {
		confine_with_one_descriptor();
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_int_equal(status, 0);
}

/* Exits with 0 if files are confined while standard output is this one. */
static void confine_with_stdout(int descriptor)
{
	const struct confine_request request = {.output = {"/dev/stdout"}};
	struct log_capture heard;
	const struct log log = log_capture_begin(&heard);

	dup2(descriptor, STDOUT_FILENO);
	_exit(confine_process(&request, &log).files &&
				open("/dev/limber-test", O_WRONLY | O_CREAT,
					0600) < 0 &&
				errno == EACCES
			? 0
			: 1);
}

/*
 * A descriptor that is open needs no rule, and Landlock has none for a pipe. A
 * rule for /dev/stdout that leads to a file would open the folder /dev.
 */
static void test_a_descriptor_as_output_opens_no_folder(void **state)
{
	FILE *file;
	int end[2];

	(void)state;
	if (!has_landlock()) {
		skip_because("this kernel has no Landlock");
	}
	file = tmpfile();
	assert_non_null(file);
	assert_int_equal(pipe(end), 0);
	for (int i = 0; i < 2; i++) {
		pid_t child = fork();
		int status = -1;

		if (child == 0) {
			confine_with_stdout(i == 0 ? end[1] : fileno(file));
		}
		assert_int_equal(waitpid(child, &status, 0), child);
		assert_int_equal(status, 0);
	}
	close(end[0]);
	close(end[1]);
	fclose(file);
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_note_says_what_the_kernel_lacks),
		cmocka_unit_test(test_each_call_of_landlock_that_fails_is_told),
		cmocka_unit_test(
			test_a_lack_of_descriptors_does_not_refuse_outputs),
		cmocka_unit_test(test_a_descriptor_as_output_opens_no_folder),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
