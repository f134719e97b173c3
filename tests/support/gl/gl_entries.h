/*
 * The calls of gl_functions.h by number, for tests that try each of them.
 */
#ifndef TESTS_SUPPORT_GL_GL_ENTRIES_H
#define TESTS_SUPPORT_GL_GL_ENTRIES_H

enum entry {
#define GL_FUNCTION(result, name, parameters) ENTRY_##name,
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
	ENTRIES
};

static const char *const entry_names[ENTRIES] = {
#define GL_FUNCTION(result, name, parameters) #name,
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
};

#endif
