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
#include "platform/gl/gl.h"

/* What every driver's context begins with; made and destroyed by the driver. */
struct gl_context {
	const struct gl_driver *driver;
	struct gl gl;            /* the calls, all filled in */
	const char *description; /* vendor and version, for people */
};

struct gl_driver {
	const char *name;
	const char *summary;
	bool surface; /* draws on a native surface only */

	/*
	 * Opens the library and makes a context current on this thread for
	 * pictures of this format. 0, or -errno after a sentence that names
	 * what is missing (library, function, display) and what to install or
	 * choose instead. The log is copied. Mandatory.
	 */
	int (*create)(enum pixel_format format, const struct log *log,
		struct gl_context **out);

	/*
	 * Draws the next frame into target, whose size may change from frame
	 * to frame; sets the viewport and the scissor box to all of it when it
	 * does. target's pixels have the format given to create() and are
	 * used until end_frame(); between frames only state, matrices and
	 * textures may be set. What the buffers hold at the start is
	 * undefined: clear them. 0 or -errno after a sentence. Mandatory.
	 */
	int (*begin_frame)(
		struct gl_context *context, const struct pixels *target);

	/*
	 * Completes the picture in target. 0 or -errno after a sentence.
	 * Mandatory.
	 */
	int (*end_frame)(struct gl_context *context);

	/* NULL is fine. Mandatory. */
	void (*destroy)(struct gl_context *context);
};

/* Built-in drivers in order of preference, NULL at the end. */
extern const struct gl_driver *const gl_registry[];

/* True for "auto" and the drivers' names; else says which names there are. */
bool gl_is_known(const char *name, const struct log *log);

/*
 * Opens the named driver, or for NULL or "auto" the first that opens. 0, or
 * -errno after a sentence: one for each driver tried, or for an unknown name
 * (-EINVAL) the names there are.
 */
int gl_open(const char *name, enum pixel_format format, const struct log *log,
	struct gl_context **out);

#endif
