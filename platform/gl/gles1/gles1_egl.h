/*
 * EGL with an OpenGL ES 1.1 context on it, opened at run time.
 *
 * The context draws on a pbuffer, which any EGL has, or on a native window.
 * Nothing here knows of struct gl.
 *
 * Vendors name the libraries in their own ways: what the request names, else
 * LIMBER_EGL and LIMBER_GLES in the environment, file names as for dlopen(),
 * stand in for the usual names.
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
	EGLSurface surface; /* current with the context, or EGL_NO_SURFACE */
	struct log log;     /* what a sentence begins with is "--gl gles1" */
};

/*
 * Opens the libraries, a display, a configuration for pictures of the
 * request's format and a context; nothing is current yet. For pixels, Mesa's
 * display without a screen is tried first, then the default one; for a native
 * surface the default one alone, and the surface is made. 0, or -errno after a
 * sentence with nothing left open.
 */
int egl_open(struct egl *egl, const struct gl_request *request);

/* gl_driver.find_screen(). */
int egl_find_screen(const struct gl_request *request);

/*
 * Replaces the surface by a pbuffer of this size and makes it current. 0, or
 * -errno after a sentence.
 */
int egl_set_pbuffer(struct egl *egl, int width, int height);

/* Shows at most one picture a turn of the screen, for what is current. */
void egl_set_swap_interval(struct egl *egl);

/* The surface's size now; 0 where EGL does not tell. */
void egl_get_size(const struct egl *egl, int *width, int *height);

/* Shows what was drawn on a window. 0, or -errno after a sentence. */
int egl_swap(struct egl *egl);

/* Makes context and surface current. 0, or -errno after a sentence. */
int egl_make_current(struct egl *egl);

/* A GL call by name ("glClear"), or NULL; for gl_load(), with a struct egl. */
gl_function egl_get_function(void *egl, const char *name);

/* Fine on what egl_open() left after a failure. */
void egl_close(struct egl *egl);

#endif
