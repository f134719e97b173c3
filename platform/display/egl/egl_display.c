/*
 * A native surface of EGL: the whole screen without a desktop, or a window
 * whose number the user gives. The GL driver opens EGL and draws on it.
 */
#include <errno.h>
#include <stdlib.h>

#include "platform/display/display.h"

struct display {
	struct native_surface surface;
	enum pixel_format format;
};

/* Never chosen by auto: what window 0 means depends on the vendor's EGL. */
static bool egl_probe(void)
{
	return false;
}

static bool read_window(const char *text, uintptr_t *out)
{
	unsigned long long value;
	char *end;

	errno = 0;
	value = strtoull(text, &end, 0);
	*out = (uintptr_t)value;
	return !errno && end != text && !*end && text[0] != '-' && *out == value;
}

static int egl_check(const struct display_options *options)
{
	uintptr_t window;

	if (options->device && !read_window(options->device, &window)) {
		log_error(options->log,
			"--display egl:%s: give the number of a native window, such as 0x1e00003, or --display egl for the whole screen",
			options->device);
		return -EINVAL;
	}
	return 0;
}

static int egl_create(
	const struct display_options *options, struct display **out)
{
	int error = egl_check(options);
	struct display *display;
	uintptr_t window = 0;

	if (error) {
		return error;
	}
	if (options->device) {
		read_window(options->device, &window);
	}
	display = calloc(1, sizeof(*display));
	if (!display) {
		log_error(options->log, "--display egl: out of memory");
		return -ENOMEM;
	}
	display->surface.window = window;
	/* Most panels of boards have 16 bits. */
	display->format =
		options->format_given ? options->format : PIXELS_RGB565;
	*out = display;
	return 0;
}

static void egl_get_info(const struct display *display, struct display_info *out)
{
	*out = (struct display_info){.format = display->format};
}

static void egl_get_surface(
	const struct display *display, struct native_surface *out)
{
	*out = display->surface;
}

/* The GL driver's end_frame() shows the picture. */
static int egl_end_frame(struct display *display)
{
	(void)display;
	return 0;
}

static void egl_destroy(struct display *display)
{
	free(display);
}

const struct display_driver display_driver_egl = {
	.name = "egl",
	.summary = "the screen of a vendor's EGL, for --gl gles1",
	.argument = "WINDOW",
	.needs_keyboard = true,
	.probe = egl_probe,
	.check = egl_check,
	.create = egl_create,
	.get_info = egl_get_info,
	.get_surface = egl_get_surface,
	.end_frame = egl_end_frame,
	.destroy = egl_destroy,
};
