/*
 * Displays: where finished pictures go.
 *
 * A display either hands out a buffer of pixels for each frame, or a native
 * surface that only a GL driver of the same kind can draw on.
 */
#ifndef PLATFORM_DISPLAY_DISPLAY_H
#define PLATFORM_DISPLAY_DISPLAY_H

#include <stdbool.h>

#include "platform/base/log.h"
#include "platform/base/survey.h"
#include "platform/buttons/buttons.h"
#include "platform/display/pixels.h"
#include "platform/display/surface.h"

struct display;

/*
 * What a display is asked for; strings are borrowed for the call only, the log
 * is copied.
 */
struct display_options {
	int width, height;        /* wanted size in pixels */
	bool size_given;          /* by somebody, not by default */
	enum pixel_format format; /* of pictures */
	bool format_given;        /* else what suits the display */
	const char *device;       /* what stood behind the name, or NULL */
	const char *title;        /* window */
	const char *output;       /* image: the file to write */
	int frame_count;          /* image: frames to expect, 0: not known */
	double rate_hz;           /* image: frames a second of an animation */
	const struct log *log;
};

/* What a display came to be. */
struct display_info {
	int width, height;        /* of the first frame */
	enum pixel_format format; /* of every frame */
	/*
	 * How often the screen shows a picture, for which end_frame() waits.
	 * 0: it does not wait, or nobody knows.
	 */
	double rate_hz;
};

/* What happened outside since the last poll. */
struct display_events {
	bool close;   /* the person closed the window */
	bool resized; /* begin_frame() hands out another size from now on */
	bool graph;   /* to show how long frames take, or no longer */
	bool picture; /* to keep the picture in a file */
};

struct display_driver {
	const char *name;
	const char *summary;
	const char *argument; /* what "NAME:..." takes, or NULL: nothing */

	/*
	 * True when this display may be chosen unasked, because create() has a
	 * chance on this machine: a cheap look at the environment, silent.
	 * Optional: NULL means always. Those that show nobody anything (image,
	 * null) say no.
	 */
	bool (*probe)(void);

	/*
	 * Checks the device and the output as words of the command line, and
	 * opens nothing. 0, or -EINVAL after logging an error. Optional: NULL
	 * where every device is possible.
	 */
	int (*check)(const struct display_options *options);

	/*
	 * Checks the options as check() does. 0, or -errno after a sentence
	 * with nothing left open. Mandatory.
	 */
	int (*create)(
		const struct display_options *options, struct display **out);

	/*
	 * Size, format and pace. The size of a surface is zero, as only the GL
	 * driver learns it, and its format a wish. Mandatory.
	 */
	void (*get_info)(
		const struct display *display, struct display_info *out);

	/*
	 * The surface that a GL driver draws on instead of into pixels; it
	 * stays the display's. Mandatory for displays without begin_frame(),
	 * NULL in others.
	 */
	void (*get_surface)(
		const struct display *display, struct native_surface *out);

	/*
	 * The buffer to draw the next frame into, valid until end_frame().
	 * 0, or -errno after a sentence. Mandatory for displays of pixels.
	 */
	int (*begin_frame)(struct display *display, struct pixels *out);

	/*
	 * Shows or stores the frame; may wait for the screen's turn. 0, or
	 * -errno after a sentence. Mandatory.
	 */
	int (*end_frame)(struct display *display);

	/*
	 * Collects what happened; keys go into the queue stamped now_ms.
	 * Optional.
	 */
	void (*poll)(struct display *display, int64_t now_ms,
		struct button_queue *queue, struct display_events *events);

	/*
	 * Completes what is stored (an animation's file), which destroy()
	 * without it throws away. 0, or -errno after a sentence. Optional;
	 * called once, before destroy().
	 */
	int (*finish)(struct display *display);

	/* NULL is fine. Mandatory. */
	void (*destroy)(struct display *display);

	/*
	 * Says which of the machine's screens it could show pictures on, at
	 * least one finding: SURVEY_WORKS means that create() would do. Opens
	 * nothing for longer than a look. Optional: NULL where the machine
	 * does not matter.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers in order of preference, NULL at the end. */
extern const struct display_driver *const display_registry[];

/* The driver of that name, or NULL. */
const struct display_driver *display_find(const char *name);

/*
 * The driver that "NAME" or "NAME:DEVICE" means. NULL after a sentence: there
 * is no such driver (it lists those there are), or it takes no device.
 */
const struct display_driver *display_choose(
	const char *spec, const struct log *log);

/*
 * Checks what display_open() would open, as far as words tell. options->device
 * is ignored. 0, with the driver in *driver, or -EINVAL after logging an error:
 * spec names no driver (it lists those there are), or its driver does not
 * accept the device or the output.
 */
int display_check(const char *spec, const struct display_options *options,
	const struct display_driver **driver);

/*
 * Opens the display that spec means, with the device it names; for NULL or
 * "auto" the first whose probe says yes and that opens. 0, or -errno after a
 * sentence about each that was tried and, for auto, which there are.
 * options->device is ignored.
 */
int display_open(const char *spec, const struct display_options *options,
	const struct display_driver **driver, struct display **out);

#endif
