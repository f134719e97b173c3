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
#include <linux/landlock.h>
#include <linux/seccomp.h>
#include <pthread.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

enum {
	UNCONFINED = 200, /* an exit status that no errno has */
	X32_BIT = 0x40000000
};

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

/* Where the attempts write. */
static char allowed[256], beside[256], forbidden[256];
static struct test_path places;

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

/*
 * Without confinement each of these fails for root, too, but not with EPERM: no
 * pointer and no descriptor is -1.
 */
static int change_the_machine(void)
{
	static const int numbers[] = {
		SYS_execve,
		SYS_execveat,
		SYS_process_vm_readv,
		SYS_process_vm_writev,
		SYS_pidfd_open,
		SYS_pidfd_getfd,
		SYS_kcmp,
		SYS_mount,
		SYS_umount2,
		SYS_pivot_root,
		SYS_chroot,
		SYS_unshare,
		SYS_setns,
		SYS_reboot,
		SYS_kexec_load,
		SYS_init_module,
		SYS_finit_module,
		SYS_delete_module,
		SYS_swapon,
		SYS_swapoff,
		SYS_sethostname,
		SYS_bpf,
		SYS_userfaultfd,
		SYS_add_key,
		SYS_request_key,
		SYS_keyctl,
		SYS_capset,
		SYS_io_uring_setup,
#ifndef __SANITIZE_ADDRESS__ /* whose leak check needs it */
		SYS_ptrace,
#endif
	};

	for (size_t i = 0; i < sizeof(numbers) / sizeof(numbers[0]); i++) {
		if (syscall(numbers[i], -1, -1, -1, -1, -1, -1) != -1 ||
			errno != EPERM) {
			return 1 + (int)i;
		}
	}
	return EPERM;
}

static int use_a_socket(void)
{
	if (bind(-1, NULL, 0) != -1 || errno != EPERM ||
		connect(-1, NULL, 0) != -1 || errno != EPERM ||
		listen(-1, 0) != -1 || errno != EPERM) {
		return errno;
	}
	return socketpair(AF_UNIX, SOCK_STREAM, 0, NULL) < 0 ? errno : 0;
}

#if defined(__x86_64__)
/* getpid() as programs for x32 and for 32 bits call it. */
static int call_as_x32(void)
{
	return syscall(X32_BIT + SYS_getpid) < 0 ? errno : 0;
}

static int call_as_32_bits(void)
{
	long result = 20;

	__asm__ volatile("int $0x80"
			 : "+a"(result)
			 :
			 : "r8", "r9", "r10", "r11", "memory");
	return result < 0 ? (int)-result : 0;
}

static bool has_32_bit_calls(void)
{
	pid_t child = fork();
	int status = -1;

	if (child == 0) {
		_exit(call_as_32_bits());
	}
	assert_int_equal(waitpid(child, &status, 0), child);
	return status == 0;
}
#endif

/* The greatest of four descriptors that are free. */
static int fourth_free(void)
{
	int fd[4];

	for (int i = 0; i < 4; i++) {
		fd[i] = open("/dev/null", O_RDONLY);
	}
	for (int i = 0; i < 4; i++) {
		close(fd[i]);
	}
	return fd[3];
}

static int keep_descriptors(void)
{
	static const struct confine_request request = {
		.output = {allowed, beside}};
	const struct log log = log_to_nowhere();
	int before = fourth_free();

	(void)confine_process(&request, &log);
	return fourth_free() == before ? 0 : EMFILE;
}

static int write_relative(void)
{
	return write_to("here");
}

static int write_in_the_root(void)
{
	int error = write_to("/limber-test");

	return error ? error : unlink("/limber-test") < 0 ? errno : 0;
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
	if (WEXITSTATUS(status) == UNCONFINED && files && !has_landlock()) {
		skip_because("this kernel has no Landlock");
	}
	if (WEXITSTATUS(status) == UNCONFINED && !files && !has_seccomp()) {
		skip_because("this kernel has no seccomp");
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
	const struct confine_request connects = {.connects = true};

	(void)state;
	assert_int_equal(
		try_confined(nothing, change_the_machine, false), EPERM);
	assert_int_equal(
		try_confined(connects, change_the_machine, false), EPERM);
}

static void test_calls_in_other_forms_are_refused(void **state)
{
	(void)state;
#if defined(__x86_64__)
	assert_int_equal(try_confined(nothing, call_as_x32, false), EPERM);
	if (!has_32_bit_calls()) {
		skip_because("this kernel runs no programs of 32 bits");
	}
	assert_int_equal(try_confined(nothing, call_as_32_bits, false), EPERM);
#else
	skip_because("this machine has one form of calls");
#endif
}

static void test_sockets_need_a_request(void **state)
{
	const struct confine_request connects = {.connects = true};

	(void)state;
	assert_int_equal(try_confined(nothing, open_socket, false), EPERM);
	assert_int_equal(try_confined(nothing, use_a_socket, false), EPERM);
	assert_int_equal(try_confined(connects, open_socket, false), 0);
	assert_int_equal(try_confined(connects, use_a_socket, false), EBADF);
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

static void test_several_outputs_can_be_written(void **state)
{
	struct confine_request request = {.output = {"/nowhere/x", allowed}};
	struct test_path loop = path_join(&places, "loop");

	(void)state;
	assert_int_equal(symlink("loop", loop.text), 0);
	assert_int_equal(try_confined(request, write_output, true), 0);
	request.output[0] = loop.text;
	assert_int_equal(try_confined(request, write_output, true), 0);
	request.output[0] = forbidden;
	assert_int_equal(try_confined(request, write_output, true), 0);
	assert_int_equal(try_confined(request, write_elsewhere, true), 0);
}

static void test_outputs_may_lie_in_this_folder_and_in_the_root(void **state)
{
	const struct confine_request here = {.output = {"there"}};
	const struct confine_request root = {.output = {"/x.obj"}};
	char *before = getcwd(NULL, 0);

	(void)state;
	assert_int_equal(chdir(places.text), 0);
	assert_int_equal(try_confined(here, write_relative, true), 0);
	assert_int_equal(try_confined(nothing, write_relative, true), EACCES);
	assert_int_equal(chdir(before), 0);
	free(before);
	if (access("/", W_OK) == 0) {
		assert_int_equal(try_confined(root, write_in_the_root, true), 0);
	}
}

static int make_new_folder(void)
{
	struct test_path folder = path_join(&places, "new");

	return mkdir(folder.text, 0700) < 0 ? errno : 0;
}

/* Shells complete the names of folders with a slash. */
static void test_an_output_may_be_a_new_folder(void **state)
{
	static const char *const ends[] = {"new", "new/", "new//"};

	(void)state;
	for (size_t i = 0; i < ARRAY_COUNT(ends); i++) {
		struct test_path folder = path_join(&places, ends[i]);
		const struct confine_request request = {.output = {folder.text}};

		assert_int_equal(
			try_confined(request, make_new_folder, true), 0);
		assert_int_equal(rmdir(folder.text), 0);
	}
}

static void test_files_can_be_left_out(void **state)
{
	const struct confine_request request = {.writes_anywhere = true};

	(void)state;
	assert_int_equal(try_confined(request, write_elsewhere, false), 0);
	assert_int_equal(try_confined(request, run_program, false), EPERM);
}

static void test_confinement_leaves_no_descriptor_open(void **state)
{
	(void)state;
	assert_int_equal(try_confined(nothing, keep_descriptors, false), 0);
}

/* With the sanitizers alone: whether it finds memory that nothing points to. */
__attribute__((weak)) int __lsan_do_recoverable_leak_check(void);

static int find_leaks(void)
{
	return __lsan_do_recoverable_leak_check
		? __lsan_do_recoverable_leak_check()
		: 0;
}

static void test_confinement_gives_its_memory_back(void **state)
{
	const struct confine_request request = {
		.output = {"there", "/dev/null", forbidden, "/nowhere/x"}};

	(void)state;
	assert_int_equal(try_confined(request, find_leaks, false), 0);
}

static void test_work_goes_on(void **state)
{
	(void)state;
	assert_int_equal(try_confined(nothing, allocate_and_read, false), 0);
}

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
		cmocka_unit_test(test_calls_in_other_forms_are_refused),
		cmocka_unit_test(test_sockets_need_a_request),
		cmocka_unit_test(test_only_the_outputs_can_be_written),
		cmocka_unit_test(test_several_outputs_can_be_written),
		cmocka_unit_test(
			test_outputs_may_lie_in_this_folder_and_in_the_root),
		cmocka_unit_test(test_an_output_may_be_a_new_folder),
		cmocka_unit_test(test_files_can_be_left_out),
		cmocka_unit_test(test_confinement_leaves_no_descriptor_open),
		cmocka_unit_test(test_confinement_gives_its_memory_back),
		cmocka_unit_test(test_a_device_does_not_open_its_folder),
		cmocka_unit_test(test_work_goes_on),
	};

	return cmocka_run_group_tests(tests, make_places, remove_places);
}
