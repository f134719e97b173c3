/*
 * Giving up rights before a file is read that may come from anyone.
 *
 * After confine_process() neither this process nor its threads can start
 * programs, change the machine, look into other processes or gain rights. A
 * decoder that such a file has taken over can do no more than the request
 * allows. Linux offers this since 3.17 (seccomp for all threads) and 5.13
 * (Landlock); without them the process goes on unconfined, and a note says so. So
 * it does, with a warning, if memory or descriptors are too few to confine it.
 */
#ifndef PLATFORM_PROCESS_CONFINE_H
#define PLATFORM_PROCESS_CONFINE_H

#include <stdbool.h>
#include <stddef.h>

#include "platform/base/log.h"

enum {
	CONFINE_OUTPUTS_MAX = 4
};

struct confine_request {
	/*
	 * Files and folders that may still be written, with the files beside
	 * them; NULL ends the list.
	 */
	const char *output[CONFINE_OUTPUTS_MAX + 1];
	bool writes_anywhere; /* any file may be written; output is ignored */
	bool connects; /* may open sockets, as a desktop's windows need */
};

/* Which restrictions the kernel enforces from now on. */
struct confinement {
	bool calls; /* seccomp refuses system calls */
	/* Landlock refuses to write other files; or writes_anywhere was set. */
	bool files;
};

/*
 * Confines this process for good. Threads that exist already are confined by
 * seccomp, but not by Landlock. Refused calls fail with EPERM, refused files
 * with EACCES.
 */
struct confinement confine_process(
	const struct confine_request *request, const struct log *log);

#endif
