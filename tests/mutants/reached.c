/*
 * What GCC calls at the beginning of each function of limber's that is built with
 * -finstrument-functions: it sets the byte of a file that has the function's
 * distance from the program's start (reach.py reads it). The file is mapped at the
 * first call, so that neither a signal nor a rule of the kernel for a confined
 * program keeps a call from being noted. Without the file, the program aborts.
 */
#define _GNU_SOURCE
#include <fcntl.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <sys/syscall.h>
#include <unistd.h>

extern char __executable_start;

static unsigned char *calls;

/* Tests have functions of their own for open() and mmap(). */
static unsigned char *map_calls(void)
{
	long fd = syscall(SYS_openat, AT_FDCWD, CALLS, O_RDWR | O_CLOEXEC), at;

	if (fd < 0) {
		abort();
	}
	at = syscall(SYS_mmap, NULL, (size_t)CALLS_BYTES,
		PROT_READ | PROT_WRITE, MAP_SHARED, fd, 0L);
	syscall(SYS_close, fd);
	if (at == -1) {
		abort();
	}
	return (unsigned char *)at;
}

void __cyg_profile_func_enter(void *function, void *site);
void __cyg_profile_func_exit(void *function, void *site);

void __cyg_profile_func_enter(void *function, void *site)
{
	size_t at = (size_t)((char *)function - &__executable_start);

	(void)site;
	if (!calls) {
		calls = map_calls();
	}
	if (at >= CALLS_BYTES) {
		abort();
	}
	calls[at] = 1;
}

void __cyg_profile_func_exit(void *function, void *site)
{
	(void)function;
	(void)site;
}
