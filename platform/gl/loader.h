/*
 * Opening GL libraries. limber does not link GL, so that it runs on machines
 * without it.
 */
#ifndef PLATFORM_GL_LOADER_H
#define PLATFORM_GL_LOADER_H

#include "platform/process/library.h"

/* The members of struct gl. */
extern const struct library_slot gl_slots[];
extern const int gl_slot_count;

/*
 * library_open(). On 32-bit ARM it also sets GALLIUM_DRIVER to softpipe unless
 * it is set.
 */
void *gl_library_open(const char *const *names, const char **why);

#endif
