/*
 * GL drivers, which implement the calls of struct gl.
 *
 * As always in GL, the calls use the context that is current on the calling
 * thread: the one that was created last, or whose frame was begun last. Use one
 * context at a time, from the thread that created it.
 */
#ifndef PLATFORM_GL_GL_CONTEXT_H
#define PLATFORM_GL_GL_CONTEXT_H

#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/display/pixels.h"
#include "platform/display/surface.h"
#include "platform/gl/gl.h"

struct gl_counts;

/* The first member of every driver's own context. */
struct gl_context {
	const struct gl_driver *driver;
	struct gl gl;            /* all calls are set */
	const char *description; /* vendor and version, for messages */
	bool accelerated;        /* a graphics processor draws */
	int width, height;       /* of a native surface, else 0 */
};

/* What to create. Pointers must be valid during the call only; *log is copied. */
struct gl_request {
	enum pixel_format format; /* of pictures; a surface may have another */
	const struct native_surface *surface; /* NULL to draw into pixels */
	const char *egl_library;  /* gles1: file names for dlopen(), or NULL */
	const char *gles_library; /* for the default libraries */
	const struct log *log;
};

struct gl_driver {
	const char *name;
	const char *summary;  /* one line for the help text */
	bool surface;         /* can also draw on a native surface */
	const char *packages; /* the Debian packages it needs, or NULL */

	/*
	 * Whether "auto" may try this driver: a quick check of the machine
	 * without logging. NULL means true.
	 */
	bool (*probe)(void);
	/*
	 * Whether the driver may use a graphics processor. If it may but does
	 * not, "auto" skips it.
	 */
	bool accelerates;

	/*
	 * Opens the library and makes a context current on this thread, for
	 * pictures of the format or, only if .surface is set, for the surface.
	 * Returns 0, or -errno after logging what is missing (library,
	 * function, display) and what to install or choose instead. Mandatory.
	 */
	int (*create)(const struct gl_request *request, struct gl_context **out);

	/*
	 * Begins a frame in target, whose size may differ from the last one's;
	 * then viewport and scissor box are set to all of it. Its pixels have
	 * the format given to create() and are used until end_frame(). The
	 * buffers are undefined until they are cleared. Between frames only
	 * state, matrices and textures may be set. For a native surface target
	 * is NULL, and the context has the size. Returns 0, or -errno after
	 * logging an error. Mandatory.
	 */
	int (*begin_frame)(
		struct gl_context *context, const struct pixels *target);

	/*
	 * Completes the picture in target. A surface is shown, which may wait
	 * for vertical blanking. Returns 0, or -errno after logging an error.
	 * Mandatory.
	 */
	int (*end_frame)(struct gl_context *context);

	/*
	 * From now on counts what is drawn and adds it to *counts
	 * (gl_counts.h); NULL stops counting. Optional.
	 */
	void (*count)(struct gl_context *context, struct gl_counts *counts);

	/* Destroys the context. NULL is fine. Mandatory. */
	void (*destroy)(struct gl_context *context);

	/*
	 * Whether the machine has a screen or windows for native surfaces.
	 * Returns 0, or -errno after logging an error. Mandatory with .surface.
	 */
	int (*find_screen)(const struct gl_request *request);
};

/* Built-in drivers in order of preference, NULL at the end. */
extern const struct gl_driver *const gl_registry[];

/* True for NULL, "auto" and the drivers' names; otherwise logs an error. */
bool gl_is_known(const char *name, const struct log *log);

/*
 * Whether the driver can draw for a display: on its native surface, or into its
 * pixels. The name must be known or NULL.
 */
bool gl_can_draw(const char *name, bool on_surface);

/*
 * Opens the named driver. For NULL or "auto" it opens the first one that uses a
 * graphics processor, else the first of the others. Returns 0, or -errno after
 * logging an error for each driver it tried; -EINVAL for an unknown name.
 */
int gl_open(const char *name, const struct gl_request *request,
	struct gl_context **out);

#endif
