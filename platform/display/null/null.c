/*
 * A display that shows nothing, for benchmarks and tests.
 */
#include <errno.h>
#include <stdlib.h>

#include "platform/display/display.h"

struct display {
	struct pixels pixels;
};

/* Never chosen by auto. */
static bool null_probe(void)
{
	return false;
}

static int null_create(
	const struct display_options *options, struct display **out)
{
	struct display *display = malloc(sizeof(*display));
	int error;

	if (!display) {
		log_error(options->log, "--display null: out of memory");
		return -ENOMEM;
	}
	error = pixels_alloc(&display->pixels, options->width, options->height,
		options->format_given ? options->format : PIXELS_RGBA8888,
		options->log);
	if (error) {
		free(display);
		return error;
	}
	*out = display;
	return 0;
}

static void null_get_info(
	const struct display *display, struct display_info *out)
{
	*out = (struct display_info){
		.width = display->pixels.width,
		.height = display->pixels.height,
		.format = display->pixels.format,
	};
}

static int null_begin_frame(struct display *display, struct pixels *out)
{
	*out = display->pixels;
	return 0;
}

static int null_end_frame(struct display *display)
{
	(void)display;
	return 0;
}

static void null_destroy(struct display *display)
{
	if (display) {
		free(display->pixels.data);
		free(display);
	}
}

const struct display_driver display_driver_null = {
	.name = "null",
	.summary = "draws into memory and shows nothing",
	.probe = null_probe,
	.create = null_create,
	.get_info = null_get_info,
	.begin_frame = null_begin_frame,
	.end_frame = null_end_frame,
	.destroy = null_destroy,
};
