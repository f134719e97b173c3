/*
 * A display together with the GL driver that draws for it.
 */
#ifndef APP_CMD_SHOW_SHOW_SCREEN_H
#define APP_CMD_SHOW_SHOW_SCREEN_H

#include "app/cmd/options/options.h"
#include "platform/display/display.h"
#include "platform/gl/gl_context.h"

struct show_screen {
	const struct display_driver *driver;
	struct display *display;
	struct display_info info;
	struct gl_context *gl;
	struct pixels pixels;    /* of the current frame; zero with a surface */
	struct pixels read_back; /* a copy of the surface's picture, owned */
};

/*
 * Checks --display, --gl and --output without opening anything. display is the
 * display's name, or NULL for auto. Returns false after logging an error if the
 * command line is wrong: a name is unknown, the GL driver cannot draw for the
 * display, or the display cannot write such a file.
 */
bool show_screen_check(const struct options_screen *options,
	const char *display, const struct log *log);

/*
 * Opens the display and the GL driver, for a process that may become another
 * user later (--user). frames is their number, 0 if unknown; rate_hz is the
 * frame rate of a file. Returns 0, or -errno after logging an error; then
 * nothing is open.
 */
int show_screen_open(struct show_screen *screen, const struct options *options,
	const char *display, int frames, double rate_hz, const struct log *log);

/*
 * Begins a frame and writes its size in pixels to *width and *height. Returns
 * 0, or -errno after logging an error.
 */
int show_screen_begin_frame(struct show_screen *screen, int *width, int *height);

/*
 * Completes the drawing, so that the picture can be read. Returns 0, or -errno
 * after logging an error.
 */
int show_screen_complete_frame(struct show_screen *screen);

/*
 * Gets the frame's picture, between show_screen_complete_frame() and
 * show_screen_end_frame(). *out is valid until the latter. Returns 0, or -errno
 * after logging an error.
 */
int show_screen_picture(
	struct show_screen *screen, struct pixels *out, const struct log *log);

/* Shows or stores the frame. Returns 0, or -errno after logging an error. */
int show_screen_end_frame(struct show_screen *screen);

void show_screen_close(struct show_screen *screen);

#endif
