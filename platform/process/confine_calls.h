/*
 * The system calls that a confined process cannot make.
 */
#ifndef PLATFORM_PROCESS_CONFINE_CALLS_H
#define PLATFORM_PROCESS_CONFINE_CALLS_H

#include <stdbool.h>

/*
 * Makes them fail with EPERM from now on, sockets too unless connects is set.
 * The process has PR_SET_NO_NEW_PRIVS. Returns 0 or -errno.
 */
int confine_calls(bool connects);

#endif
