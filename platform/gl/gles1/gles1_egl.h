/*
 * EGL, opened at run time, and an OpenGL ES 1.1 context.
 *
 * The context draws into a pbuffer, which every EGL has, or on a native window.
 *
 * Vendors give the libraries different names. The request may name them, or
 * LIMBER_EGL and LIMBER_GLES in the environment, as file names for dlopen().
 */
#ifndef PLATFORM_GL_GLES1_GLES1_EGL_H
#define PLATFORM_GL_GLES1_GLES1_EGL_H

/* Keeps X11's headers out. */
#define EGL_NO_X11
#define MESA_EGL_NO_X11_HEADERS
#include <EGL/egl.h>

#include "platform/base/log.h"
#include "platform/gl/gl_context.h"
#include "platform/gl/loader.h"

struct egl_api {
#define EGL_FUNCTION(result, name, parameters) result(*name) parameters;
#define EGL_OPTIONAL(result, name, parameters) result(*name) parameters;
#include "platform/gl/gles1/egl_functions.h"
#undef EGL_FUNCTION
#undef EGL_OPTIONAL
};

struct egl {
	struct egl_api api;
	void *gles; /* the library of the GL calls */
	EGLDisplay display;
	EGLConfig config;
	EGLContext context;
	EGLSurface surface; /* or EGL_NO_SURFACE */
	struct log log;
};

/*
 * Opens the libraries and a display, and creates a context for pictures of the
 * request's format, which is not current yet. For pixels it tries Mesa's
 * surfaceless display before the default one. For a native surface it uses the
 * default display and creates the surface. Returns 0, or -errno after logging
 * an error, with nothing left open.
 */
int egl_open(struct egl *egl, const struct gl_request *request);

/* gl_driver.find_screen(). */
int egl_find_screen(const struct gl_request *request);

/*
 * Replaces the surface by a pbuffer of this size and makes it current. Returns
 * 0, or -errno after logging an error.
 */
int egl_set_pbuffer(struct egl *egl, int width, int height);

/* Limits the current surface to one picture for each refresh of the screen. */
void egl_set_swap_interval(struct egl *egl);

/* The surface's current size; 0 if EGL does not tell it. */
void egl_get_size(const struct egl *egl, int *width, int *height);

/* Shows the picture of a window. Returns 0, or -errno after logging an error. */
int egl_swap(struct egl *egl);

/*
 * Makes context and surface current. Returns 0, or -errno after logging an
 * error.
 */
int egl_make_current(struct egl *egl);

/* library_fill()'s find(): the GL call of that name ("glClear"), or NULL. */
library_function egl_get_function(void *egl, const char *name);

/* Closes everything. Fine after egl_open() has failed. */
void egl_close(struct egl *egl);

#endif
