/*
 * Linux framebuffers.
 *
 * Pictures are drawn in memory and copied, to a page that is not shown if the
 * device has two or three. Blending reads what it draws on, which is slow in a
 * framebuffer: the processor does not cache its memory.
 */
#include "platform/display/fbdev/fbdev.h"

#include <errno.h>
#include <stdlib.h>
#include <unistd.h>

#include "platform/display/console.h"
#include "platform/display/fbdev/fbdev_screen.h"
#include "platform/display/packing.h"
#include "platform/display/placement.h"

static const char default_device[] = "/dev/fb0";

struct display {
	struct fbdev_screen screen;
	struct console console;
	struct placement place; /* of the picture on the screen */
	struct pixels picture;
	struct packing packing; /* of the copy */
	int error; /* of taking the screen again, -errno; frames fail then */
};

/* Pictures of 32 bits would look no better on a screen of 16 bits. */
static enum pixel_format choose_format(
	const struct display *display, const struct display_options *options)
{
	if (options->format_given) {
		return options->format;
	}
	return display->screen.layout.bits <= 16 ? PIXELS_RGB565
						 : PIXELS_RGBA8888;
}

/* Where the first pixel of the next picture goes in the framebuffer. */
static uint8_t *picture_start(const struct display *display)
{
	const struct fbdev_screen *screen = &display->screen;

	return fbdev_screen_back_page(screen) +
		(size_t)display->place.top * (size_t)screen->stride_bytes +
		(size_t)display->place.left *
		(size_t)pixel_layout_bytes(&screen->layout);
}

static int prepare_picture(
	struct display *display, const struct display_options *options)
{
	enum pixel_format format = choose_format(display, options);
	const struct fbdev_screen *screen = &display->screen;

	display->place =
		placement_choose(options, screen->width, screen->height);
	packing_init(&display->packing, format, &screen->layout);
	return pixels_alloc(&display->picture, display->place.width,
		display->place.height, format, options->log);
}

/* Makes all pages black, or the visible part of the only one. */
static void clear_screen(const struct display *display)
{
	const struct fbdev_screen *screen = &display->screen;
	bool paged = screen->page_count > 1;
	uint8_t *row = paged ? screen->memory : fbdev_screen_back_page(screen);
	int rows = paged ? screen->page_count * screen->height : screen->height;

	for (int y = 0; y < rows; y++, row += screen->stride_bytes) {
		packing_blacken(&display->packing, row, screen->width);
	}
}

int fbdev_create_on(const struct device_calls *calls,
	const struct display_options *options, struct display **out)
{
	struct display *display = calloc(1, sizeof(*display));
	int error;

	if (!display) {
		log_error(options->log, "--display fbdev: out of memory");
		return -ENOMEM;
	}
	error = fbdev_screen_open(&display->screen, calls,
		options->device ? options->device : default_device,
		options->log);
	if (error) {
		goto out_free;
	}
	error = prepare_picture(display, options);
	if (error) {
		goto out_screen;
	}
	console_acquire(&display->console, calls, options->log);
	clear_screen(display);
	log_note(options->log, "--display fbdev: %s, %dx%d, %d bits, %d page%s",
		display->screen.path, display->screen.width,
		display->screen.height, display->screen.layout.bits,
		display->screen.page_count,
		display->screen.page_count == 1 ? "" : "s");
	*out = display;
	return 0;
out_screen:
	fbdev_screen_close(&display->screen);
out_free:
	free(display);
	return error;
}

static int fbdev_create(
	const struct display_options *options, struct display **out)
{
	return fbdev_create_on(&device_calls_system, options, out);
}

static bool fbdev_probe(void)
{
	return access(default_device, R_OK | W_OK) == 0 &&
		!console_is_in_use(&device_calls_system);
}

static void fbdev_get_info(
	const struct display *display, struct display_info *out)
{
	*out = (struct display_info){
		.width = display->picture.width,
		.height = display->picture.height,
		.format = display->picture.format,
		.rate_hz = display->screen.waits
			? fbdev_screen_rate_hz(&display->screen)
			: 0.0,
	};
}

static int fbdev_begin_frame(struct display *display, struct pixels *out)
{
	*out = display->picture;
	return display->error;
}

static int fbdev_end_frame(struct display *display)
{
	struct fbdev_screen *screen = &display->screen;

	if (screen->page_count == 1) {
		fbdev_screen_wait(screen);
	}
	packing_copy(&display->packing, &display->picture,
		picture_start(display), screen->stride_bytes);
	return screen->page_count > 1 ? fbdev_screen_flip(screen) : 0;
}

static void set_screen_again(struct display *display)
{
	display->error = fbdev_screen_return(&display->screen);
	if (!display->error) {
		clear_screen(display);
	}
}

static void take_screen(struct display *display)
{
	set_screen_again(display);
	console_return(&display->console);
}

static void give_screen(struct display *display)
{
	fbdev_screen_leave(&display->screen);
	if (console_leave(&display->console) != 0) {
		set_screen_again(display);
	}
}

static void fbdev_poll(struct display *display, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	(void)now_ms;
	(void)queue;
	*events = (struct display_events){
		.away = console_follow(
			&display->console, give_screen, take_screen, display)};
}

static void fbdev_destroy(struct display *display)
{
	if (display) {
		fbdev_screen_close(&display->screen);
		console_release(&display->console);
		free(display->picture.data);
		free(display);
	}
}

static void fbdev_survey(const struct survey *survey)
{
	fbdev_survey_on(&device_calls_system, survey);
}

const struct display_driver display_driver_fbdev = {
	.name = "fbdev",
	.summary = "a Linux framebuffer, by default /dev/fb0",
	.argument = "DEVICE",
	.needs_keyboard = true,
	.probe = fbdev_probe,
	.create = fbdev_create,
	.get_info = fbdev_get_info,
	.begin_frame = fbdev_begin_frame,
	.end_frame = fbdev_end_frame,
	.poll = fbdev_poll,
	.destroy = fbdev_destroy,
	.survey = fbdev_survey,
};
