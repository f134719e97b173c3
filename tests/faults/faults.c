/*
 * A library to preload that makes one call of a program fail.
 *
 * FAULT=KIND:N makes call number N of a kind fail, counted from 1 and from the
 * start of main(); KIND:N+ makes that call and all later ones fail. Without
 * FAULT nothing fails. README.md lists the kinds. Four more variables:
 *
 *	FAULT_CALLER=program  only allocations and libraries that the program
 *	                      itself asks for count, not those of its libraries
 *	FAULT_REPORT=FILE     gets the number of calls of each kind
 *	FAULT_SITES=N         the report also names the first call of each site
 *	FAULT_TRACE=1         prints where the call failed, in a program under
 *	                      the address sanitizer
 *
 * The functions forward to the next library that defines them, so a program
 * under the address sanitizer can be tested, too.
 */
#include "faults.h"

#include <stdatomic.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char *const kind_names[KINDS] = {"alloc", "open", "stat", "read",
	"read-short", "write", "write-short", "fsync", "close", "rename",
	"mmap", "ioctl", "thread", "library"};

static atomic_bool counting; /* between the start and the end of main() */
static atomic_long calls[KINDS];
static int failing = -1; /* a kind */
static long first, last;
static bool traced;

long faults_disk_bytes = -1;

/* Defined in programs under the address sanitizer. */
__attribute__((weak)) void __sanitizer_print_stack_trace(void);

bool faults_next_fails(enum kind kind)
{
	long number;

	if (!atomic_load(&counting)) {
		return false;
	}
	number = atomic_fetch_add(&calls[kind], 1) + 1;
	faults_note_site(kind, number);
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
		faults_disk_bytes = first;
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

/* report is open before main(), which may forbid opening files. */
static void write_report(FILE *report)
{
	for (int kind = 0; report && kind < KINDS; kind++) {
		fprintf(report, "%s %ld", kind_names[kind],
			atomic_load(&calls[kind]));
		faults_write_sites(report, kind);
		putc('\n', report);
	}
	if (report) {
		fclose(report);
	}
}

static int (*real_main)(int, char **, char **);

static int counted_main(int argc, char **argv, char **environment)
{
	const char *path = getenv("FAULT_REPORT");
	const char *frames = getenv("FAULT_SITES");
	FILE *report = path ? faults_open_stream(path, "w") : NULL;
	int status;

	if (getenv("FAULT_CALLER")) {
		faults_watch_program();
	}
	if (frames) {
		faults_watch_sites(atoi(frames), *(void **)&real_main);
	}
	read_fault();
	faults_watch_stdout();
	atomic_store(&counting, true);
	status = real_main(argc, argv, environment);
	atomic_store(&counting, false);
	write_report(report);
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
