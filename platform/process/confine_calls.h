/*
 * The system calls that a confined process cannot make.
 */
#ifndef PLATFORM_PROCESS_CONFINE_CALLS_H
#define PLATFORM_PROCESS_CONFINE_CALLS_H

#include <stdbool.h>

/*
 * Makes these calls fail with EPERM from now on, in all threads; opening and
 * using sockets, too, unless connects is set. PR_SET_NO_NEW_PRIVS must be set
 * before. Returns 0 or -errno.
 */
int confine_calls(bool connects);

#endif
