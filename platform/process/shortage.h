/*
 * Errors for want of something that other programs use up.
 */
#ifndef PLATFORM_PROCESS_SHORTAGE_H
#define PLATFORM_PROCESS_SHORTAGE_H

#include <errno.h>
#include <stdbool.h>

/*
 * Whether a call with this error, an errno, would succeed if more memory or
 * descriptors were free.
 */
static inline bool shortage_is(int error)
{
	return error == ENOMEM || error == EMFILE || error == ENFILE;
}

#endif
