/*
 * A display and the GL driver that draws for it.
 */
#ifndef APP_CMD_SHOW_SHOW_SCREEN_H
#define APP_CMD_SHOW_SHOW_SCREEN_H

#include "app/cmd/options/options.h"
#include "platform/display/display.h"
#include "platform/gl/gl_context.h"

struct screen {
	const struct display_driver *driver;
	struct display *display;
	struct display_info info;
	struct gl_context *gl;
	struct pixels pixels; /* of the frame under way; no data: a surface */
};

/*
 * Whether the names of --display and --gl mean something, and go together: 0,
 * or -EINVAL after a sentence, whatever the machine has.
 */
int screen_check(const struct options *options, const struct log *log);

/*
 * Opens the display, NULL for one to be found, and the driver. frames: how
 * many there will be, 0 if not known, at rate_hz of the animation's time. 0,
 * or -errno after a sentence with nothing left open.
 */
int screen_open(struct screen *screen, const struct options *options,
	const char *display, int frames, double rate_hz, const struct log *log);

/* Begins a frame and tells its size. 0, or -errno after a sentence. */
int screen_begin_frame(struct screen *screen, int *width, int *height);

/*
 * Completes the picture: it is in pixels, or can be read back from the
 * surface. 0, or -errno after a sentence.
 */
int screen_complete_frame(struct screen *screen);

/* Then shows or stores it. 0, or -errno after a sentence. */
int screen_end_frame(struct screen *screen);

void screen_close(struct screen *screen);

#endif
