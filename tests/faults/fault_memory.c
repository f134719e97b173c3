/* Allocations that fail. */
#include "faults.h"

#include <errno.h>
#include <link.h>
#include <pthread.h>
#include <stdlib.h>

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

/*
 * The address sanitizer asks for the bounds of each thread's stack and aborts
 * without them; what the C library takes for the answer must not fail. Limber
 * never asks. The variable lies in the memory that every thread has from its
 * start: one made at its first use would itself be allocated.
 */
static _Thread_local bool asks_for_bounds
	__attribute__((tls_model("initial-exec")));

int pthread_getattr_np(pthread_t thread, pthread_attr_t *attributes)
{
	FAULTS_NEXT(pthread_getattr_np)
	int status;

	asks_for_bounds = true;
	status = next(thread, attributes);
	asks_for_bounds = false;
	return status;
}

bool faults_watches(const void *caller)
{
	const char *at = caller;

	return !program_end || (at >= program_begin && at < program_end);
}

static bool allocation_fails(const void *caller)
{
	return !asks_for_bounds && faults_watches(caller) &&
		faults_next_fails(ALLOC);
}

void faults_watch_program(void)
{
	dl_iterate_phdr(find_program, NULL);
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
	FAULTS_NEXT(realloc)

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
	FAULTS_NEXT(aligned_alloc)

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
