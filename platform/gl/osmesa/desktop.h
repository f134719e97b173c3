/*
 * OpenGL ES 1.1 Common-Lite on a desktop OpenGL.
 *
 * The two differ in numbers only: desktop GL has no fixed-point calls and
 * takes neither GL_FIXED nor, for positions and texture coordinates, GL_BYTE
 * arrays. Small functions of the same name convert, the shims.
 *
 * Calls of GL carry no context; what they mean depends on what is current on
 * the calling thread. The shims need the same of their own, and it is the one
 * thing here that is not passed.
 */
#ifndef PLATFORM_GL_OSMESA_DESKTOP_H
#define PLATFORM_GL_OSMESA_DESKTOP_H

#include <stdbool.h>

#include "platform/gl/gl.h"
#include "platform/gl/loader.h"

struct desktop_gl {
#define DESKTOP_FUNCTION(result, name, parameters) result(*name) parameters;
#include "platform/gl/osmesa/desktop_functions.h"
#undef DESKTOP_FUNCTION
};

enum {
	DESKTOP_TEXTURE_UNITS = 2
};

/* A vertex array as the program described it. */
struct desktop_array {
	bool enabled;
	bool converted; /* desktop GL does not take its type */
	int size;
	GLenum type;
	int stride_bytes;
	const uint8_t *pointer;
	float *floats; /* owned; room for so many floats */
	size_t room;
};

enum desktop_array_name {
	DESKTOP_VERTEX,
	DESKTOP_NORMAL,
	DESKTOP_COLOR,
	DESKTOP_TEXTURE_COORD, /* and one for each further unit */
	DESKTOP_ARRAY_COUNT = DESKTOP_TEXTURE_COORD + DESKTOP_TEXTURE_UNITS,
};

struct desktop {
	struct desktop_gl gl;
	struct desktop_array array[DESKTOP_ARRAY_COUNT];
	int client_unit;
};

/* The slots of struct desktop_gl. */
extern const struct gl_slot desktop_slots[];
extern const int desktop_slot_count;

/* Sets those members of gl that need a shim; the others stay as they are. */
void desktop_set_fixed_shims(struct gl *gl);

/* The part of desktop_set_fixed_shims() that deals with vertex arrays. */
void desktop_set_array_shims(struct gl *gl);

/*
 * Has this thread's shims work on desktop from now on; NULL when no context is
 * current any more.
 */
void desktop_make_current(struct desktop *desktop);

/* What this thread's shims work on. */
struct desktop *desktop_current(void);

/* Frees what the arrays needed. */
void desktop_release(struct desktop *desktop);

#endif
