/*
 * GL drivers: who carries out the calls of struct gl.
 *
 * As everywhere in GL, the calls mean the context that is current on the
 * calling thread: the one last created or last begun a frame with. Use one
 * context at a time, from the thread that made it.
 */
#ifndef PLATFORM_GL_GL_CONTEXT_H
#define PLATFORM_GL_GL_CONTEXT_H

#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/display/pixels.h"
#include "platform/display/surface.h"
#include "platform/gl/gl.h"

/* What every driver's context begins with; made and destroyed by the driver. */
struct gl_context {
	const struct gl_driver *driver;
	struct gl gl;            /* the calls, all filled in */
	const char *description; /* vendor and version, for people */
	bool accelerated;        /* a graphics processor draws */
	int width, height;       /* of a native surface, else 0 */
};

/* What a context is asked for; borrowed for the call, the log is copied. */
struct gl_request {
	enum pixel_format format; /* of pictures; a surface may have another */
	const struct native_surface *surface; /* NULL: draw into pixels */
	const char *egl_library;  /* file names as for dlopen() of gles1's */
	const char *gles_library; /* libraries; NULL: the usual ones */
	const struct log *log;
};

struct gl_driver {
	const char *name;
	const char *summary;
	bool surface;         /* can draw on a native surface as well */
	const char *packages; /* Debian's, that bring it; NULL: none */

	/*
	 * True when "auto" shall try this driver: a cheap look at the machine,
	 * silent. NULL: always. What then turns out not to be accelerated is
	 * passed over, unless the driver never is.
	 */
	bool (*probe)(void);
	bool accelerates; /* there may be a graphics processor behind it */

	/*
	 * Opens the library and makes a context current on this thread for
	 * pictures of this format or for the surface, which only drivers with
	 * .surface are asked for. 0, or -errno after a sentence that names
	 * what is missing (library, function, display) and what to install or
	 * choose instead. Mandatory.
	 */
	int (*create)(const struct gl_request *request, struct gl_context **out);

	/*
	 * Draws the next frame into target, whose size may change from frame
	 * to frame; sets the viewport and the scissor box to all of it when it
	 * does. target's pixels have the format given to create() and are
	 * used until end_frame(); between frames only state, matrices and
	 * textures may be set. What the buffers hold at the start is
	 * undefined: clear them. For a native surface target is NULL and the
	 * context tells the size. 0 or -errno after a sentence. Mandatory.
	 */
	int (*begin_frame)(
		struct gl_context *context, const struct pixels *target);

	/*
	 * Completes the picture in target, or shows the surface's and may
	 * wait for the screen's turn. 0 or -errno after a sentence. Mandatory.
	 */
	int (*end_frame)(struct gl_context *context);

	/* NULL is fine. Mandatory. */
	void (*destroy)(struct gl_context *context);

	/*
	 * Whether there is something to make native surfaces on; shows
	 * nothing. 0, or -errno after a sentence. Mandatory with .surface.
	 */
	int (*find_screen)(const struct gl_request *request);
};

/* Built-in drivers in order of preference, NULL at the end. */
extern const struct gl_driver *const gl_registry[];

/* True for "auto" and the drivers' names; else says which names there are. */
bool gl_is_known(const char *name, const struct log *log);

/*
 * Whether the named driver can draw for a display: on its native surface, or
 * into its pixels. For a known name or NULL. Silent.
 */
bool gl_can_draw(const char *name, bool on_surface);

/*
 * Opens the named driver. For NULL or "auto" the one with a graphics processor
 * behind it, where there is one, else the best without. 0, or -errno after a
 * sentence for each driver tried, or for an unknown name (-EINVAL) the names
 * there are.
 */
int gl_open_for(const char *name, const struct gl_request *request,
	struct gl_context **out);

/* The same for pixels of this format, drawn with the usual libraries. */
int gl_open(const char *name, enum pixel_format format, const struct log *log,
	struct gl_context **out);

#endif
