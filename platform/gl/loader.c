#include "platform/gl/loader.h"

#include <stdbool.h>
#include <stdlib.h>

#include "platform/base/compiler.h"
#include "platform/gl/gl.h"

const struct library_slot gl_slots[] = {
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
	return library_open(names, why);
}
