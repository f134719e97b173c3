/*
 * A library to preload that makes one call of a program fail.
 *
 * FAULT=KIND:N makes call number N of a kind fail, counted from 1 and from the
 * start of main(); KIND:N+ makes that call and all later ones fail. Without
 * FAULT nothing fails. README.md lists the kinds. Three more variables:
 *
 *	FAULT_CALLER=program  only allocations that the program itself asks for
 *	                      count, not those of its libraries
 *	FAULT_REPORT=FILE     gets the number of calls of each kind
 *	FAULT_TRACE=1         prints where the call failed, in a program under
 *	                      the address sanitizer
 *
 * The functions forward to the next library that defines them, so a program
 * under the address sanitizer can be tested, too.
 */
#define _GNU_SOURCE

#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <link.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

enum kind {
	ALLOC,
	OPEN,
	STAT,
	READ,
	READ_SHORT,
	WRITE,
	WRITE_SHORT,
	FSYNC,
	CLOSE,
	RENAME,
	MMAP,
	IOCTL,
	THREAD,
	KINDS
};

static const char *const kind_names[KINDS] = {"alloc", "open", "stat", "read",
	"read-short", "write", "write-short", "fsync", "close", "rename",
	"mmap", "ioctl", "thread"};

static atomic_bool counting; /* between the start and the end of main() */
static atomic_long calls[KINDS];
static int failing = -1; /* a kind */
static long first, last;
static bool traced;
static long disk_bytes = -1; /* what may still be written, -1: any amount */

/* dlsym() itself allocates before malloc() is found. */
static _Alignas(16) char early[65536];
static size_t early_used;

static bool is_early(const void *memory)
{
	return (const char *)memory >= early &&
		(const char *)memory < early + sizeof(early);
}

static void *allocate_early(size_t size)
{
	void *memory = early + early_used;

	early_used += (size + 15) / 16 * 16;
	if (early_used > sizeof(early)) {
		abort();
	}
	return memory;
}

/* Defined in programs under the address sanitizer. */
__attribute__((weak)) void __sanitizer_print_stack_trace(void);

/* Counts a call; whether it shall fail. */
static bool fails(enum kind kind)
{
	long number;

	if (!atomic_load(&counting)) {
		return false;
	}
	number = atomic_fetch_add(&calls[kind], 1) + 1;
	if ((int)kind != failing || number < first || number > last) {
		return false;
	}
	if (traced && number == first && __sanitizer_print_stack_trace) {
		atomic_store(&counting, false);
		__sanitizer_print_stack_trace();
		atomic_store(&counting, true);
	}
	return true;
}

static const char *program_begin, *program_end; /* its code, if asked for */

static int find_program(struct dl_phdr_info *info, size_t size, void *user)
{
	(void)size;
	(void)user;
	for (int i = 0; i < info->dlpi_phnum; i++) {
		const ElfW(Phdr) *part = &info->dlpi_phdr[i];

		if (part->p_type == PT_LOAD && part->p_flags & PF_X) {
			program_begin =
				(const char *)(info->dlpi_addr + part->p_vaddr);
			program_end = program_begin + part->p_memsz;
		}
	}
	return 1; /* the program is the first object */
}

static bool allocation_fails(const void *caller)
{
	const char *at = caller;

	if (program_end && (at < program_begin || at >= program_end)) {
		return false;
	}
	return fails(ALLOC);
}

#define NEXT(name) \
	static __typeof__(name) *next; \
	if (!next) { \
		*(void **)&next = dlsym(RTLD_NEXT, #name); \
	}

void *malloc(size_t size)
{
	static void *(*next)(size_t);
	static volatile bool searching; /* dlsym() calls back */

	if (!next) {
		if (searching) {
			return allocate_early(size);
		}
		searching = true;
		*(void **)&next = dlsym(RTLD_NEXT, "malloc");
		searching = false;
	}
	if (allocation_fails(__builtin_return_address(0))) {
		errno = ENOMEM;
		return NULL;
	}
	return next(size);
}

void *calloc(size_t count, size_t size)
{
	static void *(*next)(size_t, size_t);
	static volatile bool searching; /* dlsym() calls back */

	if (!next) {
		if (searching) {
			return allocate_early(count * size);
		}
		searching = true;
		*(void **)&next = dlsym(RTLD_NEXT, "calloc");
		searching = false;
	}
	if (allocation_fails(__builtin_return_address(0))) {
		errno = ENOMEM;
		return NULL;
	}
	return next(count, size);
}

void *realloc(void *memory, size_t size)
{
	NEXT(realloc)

	if (is_early(memory)) {
		abort();
	}
	if (allocation_fails(__builtin_return_address(0))) {
		errno = ENOMEM;
		return NULL;
	}
	return next(memory, size);
}

void *aligned_alloc(size_t alignment, size_t size)
{
	NEXT(aligned_alloc)

	if (allocation_fails(__builtin_return_address(0))) {
		errno = ENOMEM;
		return NULL;
	}
	return next(alignment, size);
}

void free(void *memory)
{
	static void (*next)(void *);
	static volatile bool searching; /* dlsym() calls back */

	if (!next && !searching) {
		searching = true;
		*(void **)&next = dlsym(RTLD_NEXT, "free");
		searching = false;
	}
	/* What dlsym() frees while it searches is left. */
	if (next && !is_early(memory)) {
		next(memory);
	}
}

static int open_or_fail(int folder, const char *path, int flags, mode_t mode)
{
	NEXT(openat)

	if (fails(OPEN)) {
		errno = flags & O_CREAT ? ENOSPC : EMFILE;
		return -1;
	}
	return next(folder, path, flags, mode);
}

static mode_t mode_of(int flags, va_list arguments)
{
	return flags & (O_CREAT | O_TMPFILE) ? va_arg(arguments, mode_t) : 0;
}

#define OPEN_FUNCTION(name) \
	int name(const char *path, int flags, ...) \
	{ \
		va_list arguments; \
		mode_t mode; \
\
		va_start(arguments, flags); \
		mode = mode_of(flags, arguments); \
		va_end(arguments); \
		return open_or_fail(AT_FDCWD, path, flags, mode); \
	}

OPEN_FUNCTION(open)
OPEN_FUNCTION(open64)
int __open_2(const char *path, int flags);
int __open64_2(const char *path, int flags);

/* What open() becomes with _FORTIFY_SOURCE. */
int __open_2(const char *path, int flags)
{
	return open_or_fail(AT_FDCWD, path, flags, 0);
}

int __open64_2(const char *path, int flags)
{
	return open_or_fail(AT_FDCWD, path, flags, 0);
}

int fstat(int fd, struct stat *status)
{
	NEXT(fstat)

	if (fails(STAT)) {
		errno = EIO;
		return -1;
	}
	return next(fd, status);
}

int fstat64(int fd, struct stat64 *status)
{
	NEXT(fstat64)

	if (fails(STAT)) {
		errno = EIO;
		return -1;
	}
	return next(fd, status);
}

ssize_t read(int fd, void *bytes, size_t size)
{
	NEXT(read)

	if (fails(READ)) {
		errno = EIO;
		return -1;
	}
	return next(fd, bytes, fails(READ_SHORT) && size > 1 ? 1 : size);
}

ssize_t __read_chk(int fd, void *bytes, size_t size, size_t room);

ssize_t __read_chk(int fd, void *bytes, size_t size, size_t room)
{
	if (size > room) {
		abort();
	}
	return read(fd, bytes, size);
}

/* A sentence about a failure must not become a failure. */
ssize_t write(int fd, const void *bytes, size_t size)
{
	NEXT(write)
	ssize_t written;

	if (fd == STDERR_FILENO) {
		return next(fd, bytes, size);
	}
	if (fails(WRITE) || (disk_bytes == 0 && size > 0)) {
		errno = ENOSPC;
		return -1;
	}
	if (disk_bytes >= 0 && size > (size_t)disk_bytes) {
		size = (size_t)disk_bytes;
	}
	written = next(
		fd, bytes, fails(WRITE_SHORT) && size > 1 ? 1 : size);
	if (disk_bytes >= 0 && written > 0) {
		disk_bytes -= written;
	}
	return written;
}

int fsync(int fd)
{
	NEXT(fsync)

	if (fails(FSYNC)) {
		errno = EIO;
		return -1;
	}
	return next(fd);
}

/* Closes the descriptor in any case, as Linux does. */
int close(int fd)
{
	NEXT(close)
	bool fault = fails(CLOSE);
	int result = next(fd);

	if (fault) {
		errno = EIO;
		return -1;
	}
	return result;
}

int rename(const char *from, const char *to)
{
	NEXT(rename)

	if (fails(RENAME)) {
		errno = EIO;
		return -1;
	}
	return next(from, to);
}

#define MMAP_FUNCTION(name, offset_type) \
	void *name(void *at, size_t size, int protection, int flags, int fd, \
		offset_type offset) \
	{ \
		NEXT(name) \
\
		if (fails(MMAP)) { \
			errno = ENOMEM; \
			return MAP_FAILED; \
		} \
		return next(at, size, protection, flags, fd, offset); \
	}

MMAP_FUNCTION(mmap, off_t)
MMAP_FUNCTION(mmap64, off64_t)

int ioctl(int fd, unsigned long request, ...)
{
	NEXT(ioctl)
	va_list arguments;
	void *argument;

	va_start(arguments, request);
	argument = va_arg(arguments, void *);
	va_end(arguments);
	if (fails(IOCTL)) {
		errno = EIO;
		return -1;
	}
	return next(fd, request, argument);
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attributes,
	void *(*run)(void *), void *user)
{
	NEXT(pthread_create)

	return fails(THREAD) ? EAGAIN : next(thread, attributes, run, user);
}

static ssize_t read_cookie(void *cookie, char *bytes, size_t size)
{
	return read((int)(long)cookie, bytes, size);
}

static ssize_t write_cookie(void *cookie, const char *bytes, size_t size)
{
	size_t done = 0;

	while (done < size) {
		ssize_t count =
			write((int)(long)cookie, bytes + done, size - done);

		if (count <= 0) {
			return (ssize_t)done;
		}
		done += (size_t)count;
	}
	return (ssize_t)size;
}

static int close_cookie(void *cookie)
{
	return close((int)(long)cookie);
}

/* The C library's own streams call no function that could be replaced. */
static FILE *open_stream(const char *path, const char *mode)
{
	int fd = mode[0] == 'r' && !strchr(mode, '+')
		? open_or_fail(AT_FDCWD, path, O_RDONLY | O_CLOEXEC, 0)
		: open_or_fail(AT_FDCWD, path,
			  O_WRONLY | O_CREAT | O_CLOEXEC |
				  (mode[0] == 'a' ? O_APPEND : O_TRUNC),
			  0666);
	FILE *file;

	if (fd < 0) {
		return NULL;
	}
	file = fopencookie((void *)(long)fd, mode,
		(cookie_io_functions_t){.read = read_cookie,
			.write = write_cookie,
			.close = close_cookie});
	if (!file) {
		close(fd);
	}
	return file;
}

FILE *fopen(const char *path, const char *mode)
{
	return open_stream(path, mode);
}

FILE *fopen64(const char *path, const char *mode)
{
	return open_stream(path, mode);
}

static void read_fault(void)
{
	const char *fault = getenv("FAULT");
	const char *colon = fault ? strchr(fault, ':') : NULL;

	if (!colon) {
		return;
	}
	traced = getenv("FAULT_TRACE") != NULL;
	first = atol(colon + 1);
	if (strncmp(fault, "disk:", 5) == 0) {
		disk_bytes = first;
		return;
	}
	last = strchr(colon, '+') ? 1L << 30 : first;
	for (int kind = 0; kind < KINDS; kind++) {
		size_t length = strlen(kind_names[kind]);

		if (length == (size_t)(colon - fault) &&
			strncmp(fault, kind_names[kind], length) == 0) {
			failing = kind;
		}
	}
	if (failing < 0) {
		fprintf(stderr, "faults: FAULT=%s: there is no such kind\n",
			fault);
		_exit(99);
	}
}

static void write_report(void)
{
	const char *path = getenv("FAULT_REPORT");
	FILE *file = path ? open_stream(path, "w") : NULL;

	if (!file) {
		return;
	}
	for (int kind = 0; kind < KINDS; kind++) {
		fprintf(file, "%s %ld\n", kind_names[kind],
			atomic_load(&calls[kind]));
	}
	fclose(file);
}

static int (*real_main)(int, char **, char **);

static int counted_main(int argc, char **argv, char **environment)
{
	int status;

	if (getenv("FAULT_CALLER")) {
		dl_iterate_phdr(find_program, NULL);
	}
	read_fault();
	stdout = fopencookie((void *)STDOUT_FILENO, "w",
		(cookie_io_functions_t){.write = write_cookie});
	atomic_store(&counting, true);
	status = real_main(argc, argv, environment);
	atomic_store(&counting, false);
	write_report();
	return status;
}

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
	int (*init)(int, char **, char **), void (*fini)(void),
	void (*rtld_fini)(void), void *stack_end);

int __libc_start_main(int (*main)(int, char **, char **), int argc, char **argv,
	int (*init)(int, char **, char **), void (*fini)(void),
	void (*rtld_fini)(void), void *stack_end)
{
	static int (*next)(int (*)(int, char **, char **), int, char **,
		int (*)(int, char **, char **), void (*)(void), void (*)(void),
		void *);

	*(void **)&next = dlsym(RTLD_NEXT, "__libc_start_main");
	real_main = main;
	return next(counted_main, argc, argv, init, fini, rtld_fini, stack_end);
}
