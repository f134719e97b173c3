#include "platform/gl/loader.h"

#include <dlfcn.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"
#include "platform/gl/gl.h"

const struct gl_slot gl_slots[] = {
#define GL_FUNCTION(result, name, parameters) \
	{"gl" #name, offsetof(struct gl, name)},
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION
};

const int gl_slot_count = (int)ARRAY_COUNT(gl_slots);

#ifdef __arm__
static const bool mesa_compiler_fails = true;
#else
static const bool mesa_compiler_fails = false;
#endif

/*
 * On 32-bit ARM the machine code that Mesa's llvmpipe generates crashes or
 * draws wrong pictures (seen in Debian 13's Mesa 25). softpipe generates none.
 */
static void choose_mesa_renderer(void)
{
	if (mesa_compiler_fails) {
		setenv("GALLIUM_DRIVER", "softpipe", 0);
	}
}

void *gl_library_open(const char *const *names, const char **why)
{
	choose_mesa_renderer();
	for (; *names; names++) {
		void *library =
			dlopen(*names, RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE);

		if (library) {
			return library;
		}
		if (why) {
			*why = dlerror();
		}
	}
	return NULL;
}

gl_function gl_library_find(void *library, const char *name)
{
	void *address = dlsym(library, name);
	gl_function function;

	/* ISO C cannot convert a data pointer to a function pointer, but POSIX
	 * guarantees that both have the same representation. */
	memcpy(&function, &address, sizeof(function));
	return function;
}

const char *gl_load(void *table, const struct gl_slot *slots, int slot_count,
	gl_function (*find)(void *user, const char *name), void *user)
{
	for (int i = 0; i < slot_count; i++) {
		char *member = (char *)table + slots[i].offset;
		gl_function function;

		memcpy(&function, member, sizeof(function));
		if (function) {
			continue;
		}
		function = find(user, slots[i].name);
		if (!function) {
			return slots[i].name;
		}
		memcpy(member, &function, sizeof(function));
	}
	return NULL;
}
