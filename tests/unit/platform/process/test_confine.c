/*
 * Tries what a confined process must not do. Each attempt is a process of its
 * own, because nothing takes the confinement back.
 */
#define _GNU_SOURCE

#include "platform/process/confine.h"
#include "tests/support/files.h"
#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <sched.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/mount.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
	UNCONFINED = 200 /* an exit status that no errno has */
};

/* Where the attempts write. */
static char allowed[256], beside[256], forbidden[256];

static int write_to(const char *path)
{
	int fd = open(path, O_WRONLY | O_CREAT | O_TRUNC, 0600);

	if (fd < 0) {
		return errno;
	}
	close(fd);
	return 0;
}

static int run_program(void)
{
	execl("/bin/true", "true", (char *)NULL);
	return errno;
}

static int open_socket(void)
{
	return socket(AF_UNIX, SOCK_STREAM, 0) < 0 ? errno : 0;
}

static int mount_something(void)
{
	return mount("none", "/", "tmpfs", 0, NULL) < 0 ? errno : 0;
}

static int leave_namespace(void)
{
	return unshare(CLONE_NEWUSER) < 0 ? errno : 0;
}

static int write_output(void)
{
	return write_to(allowed);
}

static int rename_output(void)
{
	int error = write_to(beside);

	return error ? error : rename(beside, allowed) < 0 ? errno : 0;
}

static int write_elsewhere(void)
{
	return write_to(forbidden);
}

static int remove_elsewhere(void)
{
	return unlink(forbidden) < 0 ? errno : 0;
}

static int make_folder_elsewhere(void)
{
	char path[300];

	snprintf(path, sizeof(path), "%s.folder", forbidden);
	return mkdir(path, 0700) < 0 ? errno : 0;
}

static void *try_program(void *result)
{
	*(int *)result = run_program();
	return NULL;
}

static int run_program_in_a_thread(void)
{
	pthread_t thread;
	int result = 0;

	if (pthread_create(&thread, NULL, try_program, &result) != 0) {
		return EAGAIN;
	}
	pthread_join(thread, NULL);
	return result;
}

static int allocate_and_read(void)
{
	void *memory = mmap(NULL, 1 << 20, PROT_READ | PROT_WRITE,
		MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
	int fd = open("/proc/self/stat", O_RDONLY);

	return memory == MAP_FAILED || fd < 0 ? errno : 0;
}

/* What the attempt returned in a confined process. */
static int try_confined(
	struct confine_request request, int (*attempt)(void), bool files)
{
	const struct log log = log_to_nowhere();
	pid_t child = fork();
	int status;

	assert_true(child >= 0);
	if (child == 0) {
		struct confinement held = confine_process(&request, &log);

		_exit((files ? held.files : held.calls) ? attempt()
							: UNCONFINED);
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	assert_true(WIFEXITED(status));
	if (WEXITSTATUS(status) == UNCONFINED) {
		skip_because(files ? "this kernel has no Landlock"
				   : "this kernel has no seccomp");
	}
	return WEXITSTATUS(status);
}

static const struct confine_request nothing = {.connects = false};

static void test_no_program_can_be_started(void **state)
{
	(void)state;
	assert_int_equal(try_confined(nothing, run_program, false), EPERM);
	assert_int_equal(
		try_confined(nothing, run_program_in_a_thread, false), EPERM);
}

static void test_the_machine_cannot_be_changed(void **state)
{
	(void)state;
	assert_int_equal(try_confined(nothing, mount_something, false), EPERM);
	assert_int_equal(try_confined(nothing, leave_namespace, false), EPERM);
}

static void test_sockets_need_a_request(void **state)
{
	const struct confine_request connects = {.connects = true};

	(void)state;
	assert_int_equal(try_confined(nothing, open_socket, false), EPERM);
	assert_int_equal(try_confined(connects, open_socket, false), 0);
}

static void test_only_the_outputs_can_be_written(void **state)
{
	const struct confine_request request = {.output = {allowed}};

	(void)state;
	assert_int_equal(try_confined(request, write_output, true), 0);
	assert_int_equal(try_confined(request, rename_output, true), 0);
	assert_int_equal(try_confined(request, write_elsewhere, true), EACCES);
	assert_int_equal(try_confined(request, remove_elsewhere, true), EACCES);
	assert_int_equal(
		try_confined(request, make_folder_elsewhere, true), EACCES);
}

static void test_a_device_does_not_open_its_folder(void **state)
{
	const struct confine_request request = {.output = {"/dev/null"}};

	(void)state;
	snprintf(allowed, sizeof(allowed), "/dev/null");
	assert_int_equal(try_confined(request, write_output, true), 0);
	snprintf(forbidden, sizeof(forbidden), "/dev/limber-test");
	assert_int_equal(try_confined(request, write_elsewhere, true), EACCES);
}

static void test_work_goes_on(void **state)
{
	(void)state;
	assert_int_equal(try_confined(nothing, allocate_and_read, false), 0);
}

static struct test_path places;

static int make_places(void **state)
{
	(void)state;
	places = temp_dir_make();
	snprintf(allowed, sizeof(allowed), "%.200s/out", places.text);
	mkdir(allowed, 0700);
	snprintf(forbidden, sizeof(forbidden), "%.200s/other", places.text);
	snprintf(allowed, sizeof(allowed), "%.200s/out/x.obj", places.text);
	snprintf(beside, sizeof(beside), "%.200s/out/x.part", places.text);
	return write_to(forbidden);
}

static int remove_places(void **state)
{
	(void)state;
	temp_dir_remove(&places);
	return 0;
}

int main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_no_program_can_be_started),
		cmocka_unit_test(test_the_machine_cannot_be_changed),
		cmocka_unit_test(test_sockets_need_a_request),
		cmocka_unit_test(test_only_the_outputs_can_be_written),
		cmocka_unit_test(test_a_device_does_not_open_its_folder),
		cmocka_unit_test(test_work_goes_on),
	};

	return cmocka_run_group_tests(tests, make_places, remove_places);
}
