#define _GNU_SOURCE /* syscall() */

#include "platform/process/confine_calls.h"

#include <errno.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <stddef.h>
#include <stdint.h>
#include <sys/syscall.h>
#include <unistd.h>

#if defined(__x86_64__)
#define MACHINE AUDIT_ARCH_X86_64
#elif defined(__arm__)
#define MACHINE AUDIT_ARCH_ARM
#elif defined(__aarch64__)
#define MACHINE AUDIT_ARCH_AARCH64
#else
#define MACHINE 0
#endif

/*
 * Calls that every supported machine has. If a call has several forms, all of
 * them are listed.
 */
static const uint16_t refused[] = {
	/* Start programs and look into other processes. */
	SYS_execve,
	SYS_execveat,
	SYS_process_vm_readv,
	SYS_process_vm_writev,
	SYS_pidfd_open,
	SYS_pidfd_getfd,
	SYS_kcmp,
	/* Change the machine. */
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
	/* Gain rights, or make calls that this filter does not see (io_uring). */
	SYS_capset,
	SYS_io_uring_setup,
	/* The SOCKET_CALLS calls below are allowed if the process connects. */
	SYS_socket,
	SYS_socketpair,
	SYS_connect,
	SYS_bind,
	SYS_listen,
};

/*
 * Exists only in programs with the leak sanitizer, which must keep ptrace(): it
 * stops the threads when the program ends.
 */
__attribute__((weak)) void __lsan_do_leak_check(void);

enum {
	REFUSED = sizeof(refused) / sizeof(refused[0]),
	SOCKET_CALLS = 5,
	HEAD = 4, /* instructions of the filter in front of the list */
	TAIL = 3, /* instructions behind the list */
	X32_BIT = 0x40000000
};

static struct sock_filter load(size_t offset)
{
	return (struct sock_filter)BPF_STMT(
		BPF_LD | BPF_W | BPF_ABS, (uint32_t)offset);
}

/*
 * Skips skip instructions when the loaded value equals value, else skip_else
 * instructions.
 */
static struct sock_filter equal(uint32_t value, int skip, int skip_else)
{
	return (struct sock_filter)BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value,
		(uint8_t)skip, (uint8_t)skip_else);
}

static struct sock_filter end(uint32_t action)
{
	return (struct sock_filter)BPF_STMT(BPF_RET | BPF_K, action);
}

int confine_calls(bool connects)
{
	struct sock_filter filter[HEAD + REFUSED + TAIL];
	int count = REFUSED - (connects ? SOCKET_CALLS : 0);
	int at = 0;
	struct sock_fprog program = {.filter = filter};

	if (MACHINE == 0) {
		return -ENOSYS;
	}
	/*
	 * Refuses all calls of another architecture, such as those of 32-bit
	 * programs and of x32, whose numbers mean other calls.
	 */
	filter[at++] = load(offsetof(struct seccomp_data, arch));
	filter[at++] = equal(MACHINE, 0, count + 4);
	filter[at++] = load(offsetof(struct seccomp_data, nr));
	filter[at++] = (struct sock_filter)BPF_JUMP(
		BPF_JMP | BPF_JGE | BPF_K, X32_BIT, (uint8_t)(count + 2), 0);
	for (int i = 0; i < count; i++) {
		filter[at++] = equal(refused[i], count + 1 - i, 0);
	}
	filter[at++] = equal(__lsan_do_leak_check ? X32_BIT : SYS_ptrace, 1, 0);
	filter[at++] = end(SECCOMP_RET_ALLOW);
	filter[at++] = end(SECCOMP_RET_ERRNO | EPERM);
	program.len = (unsigned short)at;
	/* TSYNC filters all threads: a camera has a thread of its own. */
	if (syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER,
		    SECCOMP_FILTER_FLAG_TSYNC, &program) != 0) {
		/* Not counted: a kernel without seccomp. */
		return errno ? -errno : -EBUSY;
	}
	return 0;
}
