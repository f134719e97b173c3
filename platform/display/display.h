/*
 * Displays: where finished pictures go.
 *
 * A display either hands out a buffer of pixels for each frame, or it has a
 * native surface that only GL drivers with .surface can draw on.
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

/* What to open. Strings must be valid during the call only; *log is copied. */
struct display_options {
	int width, height;        /* wanted size in pixels */
	bool size_given;          /* the user gave the size */
	enum pixel_format format; /* of pictures */
	bool format_given;        /* if not, the display chooses the format */
	const char *device;       /* what follows "NAME:", or NULL */
	const char *title;        /* window: its title, or NULL */
	const char *output;       /* image: the file to write */
	int frame_count;          /* image: expected frames, 0 if not known */
	double rate_hz;           /* image: frames a second of an animation */
	const struct log *log;
};

/* The properties of an open display. */
struct display_info {
	int width, height;        /* of the first frame, in pixels */
	enum pixel_format format; /* of every frame */
	/*
	 * The refresh rate of the screen when end_frame() waits for it. 0 when
	 * it does not wait, or the rate is not known.
	 */
	double rate_hz;
};

/* What the user did since the last poll. */
struct display_events {
	bool close;   /* closed the window */
	bool resized; /* resized the window: the next frame has another size */
	bool away; /* shows another console: draw nothing until it is false */
	bool picture; /* asked to save the picture in a file */
	int graph;    /* how often to show or hide the frame times */
	int overlay;  /* how often to show the next overlay */
	int joint; /* by how many to choose another joint; negative: backwards */
};

struct display_driver {
	const char *name;
	const char *summary;  /* one line for the help text */
	const char *argument; /* what follows "NAME:", or NULL for nothing */
	bool needs_keyboard;  /* shows on a screen, but reads no keys itself */

	/*
	 * Whether --display auto may try this driver: a quick check of the
	 * machine without logging. The displays that show nothing (image, null)
	 * return false. Optional: NULL means true.
	 */
	bool (*probe)(void);

	/*
	 * Checks the device and the output as far as that is possible without
	 * opening anything. Returns 0, or -EINVAL after logging an error.
	 * Optional: NULL when every device is allowed.
	 */
	int (*check)(const struct display_options *options);

	/*
	 * Checks the options as check() does and opens a display. Returns 0, or
	 * -errno after logging an error, with nothing left open. Mandatory.
	 */
	int (*create)(
		const struct display_options *options, struct display **out);

	/*
	 * Gets size, format and rate. For a native surface the size is 0,
	 * because only the GL driver knows it, and the format is a preference.
	 * Mandatory.
	 */
	void (*get_info)(
		const struct display *display, struct display_info *out);

	/*
	 * Gets the native surface, which the display owns. Mandatory for
	 * displays without begin_frame(), NULL for others.
	 */
	void (*get_surface)(
		const struct display *display, struct native_surface *out);

	/*
	 * Gets the buffer to draw the next frame into, valid until end_frame().
	 * Returns 0, or -errno after logging an error. Mandatory for displays
	 * of pixels.
	 */
	int (*begin_frame)(struct display *display, struct pixels *out);

	/*
	 * Shows or stores the frame, and may wait for the screen's vertical
	 * blanking. Returns 0, or -errno after logging an error. Mandatory.
	 */
	int (*end_frame)(struct display *display);

	/*
	 * Collects the user's actions. Keys are pushed into the queue with the
	 * time now_ms. Optional.
	 */
	void (*poll)(struct display *display, int64_t now_ms,
		struct button_queue *queue, struct display_events *events);

	/*
	 * Completes the file of an animation; without this call, destroy()
	 * discards it. Call it once, before destroy(). Returns 0, or -errno
	 * after logging an error. Optional.
	 */
	int (*finish)(struct display *display);

	/* Closes the display. NULL is fine. Mandatory. */
	void (*destroy)(struct display *display);

	/*
	 * Reports the screens of the machine that this driver can use, at least
	 * one finding. SURVEY_WORKS means that create() should succeed. Keeps
	 * no device open. Optional: NULL for drivers that need no device.
	 */
	void (*survey)(const struct survey *survey);
};

/* Built-in drivers in order of preference, NULL at the end. */
extern const struct display_driver *const display_registry[];

/*
 * The driver of "NAME" or "NAME:DEVICE". Returns NULL after logging an error:
 * there is no such driver, or it takes no device.
 */
const struct display_driver *display_choose(
	const char *spec, const struct log *log);

/*
 * Checks spec and options as far as that is possible without opening
 * anything. options->device is ignored. Returns 0 with the driver in *driver,
 * or -EINVAL after logging an error: there is no such driver, or it does not
 * accept the device or the output.
 */
int display_check(const char *spec, const struct display_options *options,
	const struct display_driver **driver);

/*
 * Opens the display of spec, "NAME" or "NAME:DEVICE". For NULL or "auto" it
 * opens the first one whose probe() returns true and whose create() succeeds.
 * Returns 0, or -errno after logging an error for each display it tried.
 * options->device is ignored.
 */
int display_open(const char *spec, const struct display_options *options,
	const struct display_driver **driver, struct display **out);

#endif
