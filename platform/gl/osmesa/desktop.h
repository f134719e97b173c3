/*
 * OpenGL ES 1.1 Common-Lite on desktop OpenGL.
 *
 * The two differ in their types only: desktop GL has no fixed-point calls, no
 * GL_FIXED arrays and, for positions and texture coordinates, no GL_BYTE
 * arrays. A shim is a function that converts these and calls desktop GL.
 *
 * GL calls have no parameter for the context; they use the one that is current
 * on the calling thread. Likewise, the shims use desktop_current().
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
	bool converted; /* desktop GL does not support its type */
	int size;
	GLenum type;
	int stride_bytes;
	const uint8_t *pointer;
	float *floats;   /* the converted array, owned */
	size_t capacity; /* of floats */
};

enum desktop_array_name {
	DESKTOP_VERTEX,
	DESKTOP_NORMAL,
	DESKTOP_COLOR,
	DESKTOP_TEXTURE_COORD, /* one for each texture unit */
	DESKTOP_ARRAY_COUNT = DESKTOP_TEXTURE_COORD + DESKTOP_TEXTURE_UNITS,
};

struct desktop {
	struct desktop_gl gl;
	struct desktop_array array[DESKTOP_ARRAY_COUNT];
	int client_unit;
};

/* The slots of struct desktop_gl. */
extern const struct library_slot desktop_slots[];
extern const int desktop_slot_count;

/* Sets the members of gl that have fixed-point parameters to shims. */
void desktop_set_fixed_shims(struct gl *gl);

/* Sets the members of gl that deal with vertex arrays to shims. */
void desktop_set_array_shims(struct gl *gl);

/* Makes desktop current on this thread. NULL stands for no context. */
void desktop_make_current(struct desktop *desktop);

/* The current desktop of this thread. */
struct desktop *desktop_current(void);

/* Frees the converted arrays. */
void desktop_release(struct desktop *desktop);

#endif
