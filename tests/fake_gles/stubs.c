/*
 * A function for every GL call limber uses, for those that fake.c leaves out.
 * Without parameters: nothing looks at them.
 */
#define GL_FUNCTION(result, name, parameters)                            \
	void gl##name(void);                                             \
	__attribute__((weak, visibility("default"))) void gl##name(void) \
	{                                                                \
	}
#include "platform/gl/gl_functions.h"
