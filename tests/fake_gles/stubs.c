/*
 * A function for every GL call that fake.c does not define. They have no
 * parameters because nothing uses them.
 */
#define GL_FUNCTION(result, name, parameters)                            \
	void gl##name(void);                                             \
	__attribute__((weak, visibility("default"))) void gl##name(void) \
	{                                                                \
	}
#include "platform/gl/gl_functions.h"
