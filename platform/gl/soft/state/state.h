/*
 * Declares the driver's GL functions, soft_gl_ followed by the name in struct
 * gl, and the checks by which they refuse parameters that GL does not allow.
 */
#ifndef PLATFORM_GL_SOFT_STATE_STATE_H
#define PLATFORM_GL_SOFT_STATE_STATE_H

#include "platform/base/compiler.h"
#include "platform/gl/soft/soft.h"

#define GL_FUNCTION(result, name, parameters) result soft_gl_##name parameters;
#include "platform/gl/gl_functions.h"
#undef GL_FUNCTION

/*
 * Returns may_go_on; where it is false, sets the current context's error,
 * unless one is set since GetError().
 */
static inline bool soft_check(bool may_go_on, GLenum error)
{
	if (!may_go_on && soft_current()->error == GL_NO_ERROR) {
		soft_current()->error = error;
	}
	return may_go_on;
}

bool soft_is_one_of(GLenum value, const GLenum *known, size_t count);

#define IS_ONE_OF(value, ...)                                \
	soft_is_one_of(value, (const GLenum[]){__VA_ARGS__}, \
		ARRAY_COUNT(((const GLenum[]){__VA_ARGS__})))

#endif
