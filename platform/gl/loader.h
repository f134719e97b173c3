/*
 * Tables of functions from libraries that are opened at run time.
 *
 * One program serves machines with and without a GL library, so nothing of GL
 * is linked. A library stays in memory once it is open: GL libraries keep
 * threads and thread-local data that do not survive being unloaded.
 */
#ifndef PLATFORM_GL_LOADER_H
#define PLATFORM_GL_LOADER_H

#include <stddef.h>

typedef void (*gl_function)(void);

/* One member of a struct that holds nothing but pointers to functions. */
struct gl_slot {
	const char *name; /* as the library spells it */
	size_t offset;
};

/* The slots of struct gl. */
extern const struct gl_slot gl_slots[];
extern const int gl_slot_count;

/*
 * The first of these libraries that opens, NULL at the end of the list; or
 * NULL, and *why (unless NULL) is the dynamic loader's reason for the last.
 * On 32-bit ARM it sets GALLIUM_DRIVER unless it is set: see there.
 */
void *gl_library_open(const char *const *names, const char **why);

/* The library's function of that name, or NULL. */
gl_function gl_library_find(void *library, const char *name);

/*
 * Fills those members of table that are still NULL with what find(user, name)
 * answers. NULL, or the name of the first that is missing.
 */
const char *gl_load(void *table, const struct gl_slot *slots, int slot_count,
	gl_function (*find)(void *user, const char *name), void *user);

#endif
