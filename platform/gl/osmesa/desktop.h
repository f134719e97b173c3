/*
 * OpenGL ES 1.1's fixed-point calls on a desktop OpenGL.
 *
 * The two differ in the ...x entry points only, so each of those becomes a
 * small function that converts its numbers. Calls of GL carry no context;
 * what they mean depends on what is current on the calling thread. The shims
 * need the same of their own, and it is the one thing here that is not passed.
 */
#ifndef PLATFORM_GL_OSMESA_DESKTOP_H
#define PLATFORM_GL_OSMESA_DESKTOP_H

#include "platform/gl/gl.h"
#include "platform/gl/loader.h"

struct desktop_gl {
#define DESKTOP_FUNCTION(result, name, parameters) result(*name) parameters;
#include "platform/gl/osmesa/desktop_functions.h"
#undef DESKTOP_FUNCTION
};

/* The slots of struct desktop_gl. */
extern const struct gl_slot desktop_slots[];
extern const int desktop_slot_count;

/* Sets the ...x members of gl; the others are left as they are. */
void desktop_set_shims(struct gl *gl);

/*
 * Has this thread's shims call desktop from now on; NULL when no context is
 * current any more. desktop must live until then.
 */
void desktop_make_current(const struct desktop_gl *desktop);

#endif
