/*
 * Loads tables of functions from libraries that are opened at run time.
 *
 * limber does not link GL, so that it runs on machines without it. A library is
 * never closed, because GL libraries have threads and thread-local data that do
 * not survive unloading.
 */
#ifndef PLATFORM_GL_LOADER_H
#define PLATFORM_GL_LOADER_H

#include <stddef.h>

typedef void (*gl_function)(void);

/* A member of a struct of function pointers. */
struct gl_slot {
	const char *name; /* of the library's function */
	size_t offset;
};

/* The members of struct gl. */
extern const struct gl_slot gl_slots[];
extern const int gl_slot_count;

/*
 * Opens the first library of the list that can be opened; the list ends with
 * NULL. Returns NULL if there is none, with the reason for the last one in *why
 * unless why is NULL. On 32-bit ARM it also sets GALLIUM_DRIVER to softpipe
 * unless it is set.
 */
void *gl_library_open(const char *const *names, const char **why);

/* The library's function of that name, or NULL. */
gl_function gl_library_find(void *library, const char *name);

/*
 * Sets the members of table that are NULL to the result of find(user, name).
 * Returns NULL, or the name of the first function that is missing.
 */
const char *gl_load(void *table, const struct gl_slot *slots, int slot_count,
	gl_function (*find)(void *user, const char *name), void *user);

#endif
