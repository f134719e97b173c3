#define _GNU_SOURCE /* setresuid() */

#include "platform/process/user.h"
#include "tests/support/log_capture.h"
#include "tests/support/test.h"

#include <errno.h>
#include <linux/capability.h>
#include <pwd.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

static const char other[] = "nobody";
static struct log_capture heard; /* in a child */

/* The exit status of a child that becomes the user. */
static int in_child(void (*run)(const struct log *log))
{
	struct log log = log_capture_begin(&heard);
	pid_t child = fork();
	int status = 0;

	if (child == 0) {
		run(&log);
		_exit(99);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_true(WIFEXITED(status));
	return WEXITSTATUS(status);
}

static void become_other(const struct log *log)
{
	const struct passwd *user = getpwnam(other);
	uid_t uid = user->pw_uid;
	gid_t gid = user->pw_gid;

	if (user_become(other, log) != 0 || heard.count != 0) {
		_exit(1);
	}
	if (getuid() != uid || geteuid() != uid || getgid() != gid ||
		getegid() != gid) {
		_exit(2);
	}
	if (setuid(0) == 0 || setgid(0) == 0) {
		_exit(3);
	}
	if (user_become(other, log) != 0 || user_become("root", log) != -EPERM) {
		_exit(4);
	}
	for (gid_t group[64], *at = group + getgroups(64, group); at > group;) {
		if (*--at == 0) {
			_exit(5);
		}
	}
	_exit(0);
}

/* The list of users cannot be opened, which does not mean that one is missing. */
static void become_other_without_descriptors(const struct log *log)
{
	int next;
	struct rlimit limit;

	if (!getpwnam(other)) {
		_exit(1);
	}
	next = dup(STDERR_FILENO);
	close(next);
	limit = (struct rlimit){(rlim_t)next, (rlim_t)next};
	if (setrlimit(RLIMIT_NOFILE, &limit) != 0) {
		_exit(2);
	}
	if (user_become(other, log) != -EMFILE || heard.count != 1 ||
		strcmp(heard.sentence[0],
			"--user nobody: Too many open files") != 0) {
		_exit(3);
	}
	_exit(0);
}

static void test_a_lack_of_descriptors_is_told(void **state)
{
	(void)state;
	assert_int_equal(in_child(become_other_without_descriptors), 0);
}

static void become_root_again(const struct log *log)
{
	if (setreuid(getpwnam(other)->pw_uid, 0) != 0) {
		_exit(1);
	}
	if (user_become("root", log) != 0 || getuid() != 0 || geteuid() != 0) {
		_exit(2);
	}
	_exit(0);
}

/* It may change its groups, but not its user, of which it has kept root. */
static void become_other_with_a_way_back(const struct log *log)
{
	struct __user_cap_header_struct header = {
		.version = _LINUX_CAPABILITY_VERSION_3};
	struct __user_cap_data_struct may[2] = {
		{.effective = 1u << CAP_SETGID, .permitted = 1u << CAP_SETGID}};

	if (setresuid(getpwnam(other)->pw_uid, 1, 0) != 0 ||
		syscall(SYS_capset, &header, may) != 0) {
		_exit(1);
	}
	_exit(user_become(other, log) == -EPERM && heard.count == 1 ? 0 : 2);
}

static void test_a_user_with_a_way_back_to_root_is_refused(void **state)
{
	(void)state;
	if (getuid() != 0 || !getpwnam(other)) {
		skip_because("only root can keep a way back");
	}
	assert_int_equal(in_child(become_other_with_a_way_back), 0);
}

static void test_a_process_with_the_rights_of_root_becomes_root(void **state)
{
	(void)state;
	if (getuid() != 0 || !getpwnam(other)) {
		skip_because("only root can act as another user");
	}
	assert_int_equal(in_child(become_root_again), 0);
}

static void test_root_becomes_another_user_for_good(void **state)
{
	(void)state;
	if (getuid() != 0 || !getpwnam(other)) {
		skip_because("only root can become another user");
	}
	assert_int_equal(in_child(become_other), 0);
}

static void test_the_user_of_the_process_stays(void **state)
{
	const struct passwd *user = getpwuid(getuid());
	struct log log = log_to_nowhere();

	(void)state;
	if (!user) {
		skip_because("this user has no name");
	}
	assert_int_equal(user_become(user->pw_name, &log), 0);
	assert_int_equal(getuid(), geteuid());
}

static void test_others_than_root_are_refused(void **state)
{
	const struct passwd *user = getpwnam(other);
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);
	int result;

	(void)state;
	if (getuid() != 0 || !user) {
		skip_because("only root can act as another user");
	}
	assert_int_equal(seteuid(user->pw_uid), 0);
	result = user_become("root", &log);
	assert_int_equal(seteuid(0), 0);
	assert_int_equal(result, -EPERM);
	assert_int_equal(capture.count, 1);
	assert_contains(capture.sentence[0],
		"--user root: only root can become another user");
}

static void test_an_unknown_user_is_refused(void **state)
{
	struct log_capture capture;
	struct log log = log_capture_begin(&capture);

	(void)state;
	errno = EMFILE; /* of an earlier call */
	assert_int_equal(user_become("no such user", &log), -ENOENT);
	assert_int_equal(capture.count, 1);
	assert_int_equal(capture.level[0], LOG_ERROR);
	assert_contains(capture.sentence[0], "--user no such user: ");
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_a_lack_of_descriptors_is_told),
		cmocka_unit_test(
			test_a_process_with_the_rights_of_root_becomes_root),
		cmocka_unit_test(test_root_becomes_another_user_for_good),
		cmocka_unit_test(test_a_user_with_a_way_back_to_root_is_refused),
		cmocka_unit_test(test_the_user_of_the_process_stays),
		cmocka_unit_test(test_others_than_root_are_refused),
		cmocka_unit_test(test_an_unknown_user_is_refused),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
