/*
 * Shared libraries that are opened at run time: limber runs where they are
 * missing, and does not wait for them at its start.
 *
 * A library is never closed, because GL and window libraries have threads and
 * thread-local data that do not survive unloading.
 */
#ifndef PLATFORM_PROCESS_LIBRARY_H
#define PLATFORM_PROCESS_LIBRARY_H

#include <stddef.h>

typedef void (*library_function)(void);

/* A member of a struct of function pointers. */
struct library_slot {
	const char *name; /* of the library's function */
	size_t offset;
};

/*
 * Opens the first library of the list that can be opened; the list ends with
 * NULL. Returns NULL if there is none, with the reason for the last one in *why
 * unless why is NULL.
 */
void *library_open(const char *const *names, const char **why);

/* The library's function of that name, or NULL. */
library_function library_find(void *library, const char *name);

/*
 * Sets the members of table that are NULL to the result of find(user, name).
 * Returns NULL, or the name of the first function that is missing.
 */
const char *library_fill(void *table, const struct library_slot *slots,
	int slot_count, library_function (*find)(void *user, const char *name),
	void *user);

#endif
