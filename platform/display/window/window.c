/*
 * A window on the desktop, through SDL.
 *
 * The processor copies the pictures. SDL could draw them with OpenGL, but then
 * --gl osmesa would bring a second copy of Mesa into the same thread, and each
 * copy would use the other's context.
 */
#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"
#include "platform/display/display.h"
#include "platform/display/window/sdl.h"
#include "platform/display/window/window_survey.h"

struct display {
	struct log log;
	struct sdl sdl;
	SDL_Window *window;
	enum pixel_format format;
	struct pixels pixels;
	SDL_Surface *picture;             /* SDL's view of the same pixels */
	bool pressed[BUTTON_HOLDERS_MAX]; /* keys[] that are not released yet */
};

/* Each key is a holder of its own in the queue: two keys are one button. */
static const struct {
	SDL_Keycode key;
	enum button button;
} keys[] = {
	{SDLK_UP, BUTTON_UP},
	{SDLK_DOWN, BUTTON_DOWN},
	{SDLK_LEFT, BUTTON_LEFT},
	{SDLK_RIGHT, BUTTON_RIGHT},
	{SDLK_RETURN, BUTTON_ENTER},
	{SDLK_KP_ENTER, BUTTON_ENTER},
	{SDLK_F6, BUTTON_F6},
	{SDLK_F8, BUTTON_F8},
	{SDLK_F9, BUTTON_F9},
	{SDLK_F10, BUTTON_F10},
};

_Static_assert(ARRAY_COUNT(keys) <= BUTTON_HOLDERS_MAX, "each key is a holder");

static bool is_set(const char *variable)
{
	const char *value = getenv(variable);

	return value && value[0];
}

static bool window_probe(void)
{
	return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") ||
		is_set("SDL_VIDEODRIVER");
}

/* Without a desktop SDL chooses a driver that shows nothing. */
static bool is_visible(const struct display *display)
{
	const char *driver = display->sdl.GetCurrentVideoDriver();

	return is_set("SDL_VIDEODRIVER") ||
		(driver &&
			(strcmp(driver, "x11") == 0 ||
				strcmp(driver, "wayland") == 0));
}

static int failed(const struct display *display, const char *what)
{
	log_error(&display->log,
		"--display window: %s: %s: choose another --display, or write a file with limber render",
		what, display->sdl.GetError());
	return -EIO;
}

static void window_destroy(struct display *display)
{
	if (!display) {
		return;
	}
	display->sdl.FreeSurface(display->picture);
	if (display->window) {
		display->sdl.DestroyWindow(display->window);
	}
	display->sdl.QuitSubSystem(SDL_INIT_VIDEO);
	free(display->pixels.data);
	free(display);
}

static int resize(struct display *display, int width, int height)
{
	struct pixels pixels;
	SDL_Surface *picture;
	int error = pixels_alloc(
		&pixels, width, height, display->format, &display->log);

	if (error) {
		return error;
	}
	picture = display->sdl.CreateRGBSurfaceWithFormatFrom(pixels.data, width,
		height, 8 * pixel_bytes(pixels.format), pixels.stride_bytes,
		pixels.format == PIXELS_RGB565 ? SDL_PIXELFORMAT_RGB565
					       : SDL_PIXELFORMAT_RGBA32);
	if (!picture) {
		free(pixels.data);
		return failed(display, "SDL cannot create a picture");
	}
	display->sdl.SetSurfaceBlendMode(picture, SDL_BLENDMODE_NONE);
	display->sdl.FreeSurface(display->picture);
	free(display->pixels.data);
	display->picture = picture;
	display->pixels = pixels;
	return 0;
}

static int open_window(
	struct display *display, const struct display_options *options)
{
	display->sdl.SetHint(SDL_HINT_FRAMEBUFFER_ACCELERATION, "0");
	display->window = display->sdl.CreateWindow(
		options->title ? options->title : "limber",
		SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, options->width,
		options->height, SDL_WINDOW_RESIZABLE);
	if (!display->window) {
		return failed(display, "SDL cannot open a window");
	}
	/* Fails on Wayland without Xwayland, which has no such surface. */
	if (!display->sdl.GetWindowSurface(display->window)) {
		return failed(display, "SDL cannot draw in its window");
	}
	return 0;
}

/* Starts SDL's part for windows, unless there is no desktop to show them. */
static int start_sdl(struct display *display)
{
	int error = sdl_load(&display->sdl, &display->log);

	if (error) {
		return error;
	}
	if (!is_set("SDL_VIDEODRIVER") && !is_set("WAYLAND_DISPLAY")) {
		/* Otherwise Wayland's library prints an error of its own. */
		display->sdl.SetHint(SDL_HINT_VIDEODRIVER, "x11");
	}
	if (display->sdl.InitSubSystem(SDL_INIT_VIDEO) != 0) {
		failed(display, "there is no desktop");
		return -ENODEV;
	}
	if (!is_visible(display)) {
		log_error(&display->log,
			"--display window: the desktop that DISPLAY or WAYLAND_DISPLAY names does not answer: start limber in a terminal of the desktop, or write a file with limber render");
		display->sdl.QuitSubSystem(SDL_INIT_VIDEO);
		return -ENODEV;
	}
	return 0;
}

static int window_create(
	const struct display_options *options, struct display **out)
{
	struct display *display = calloc(1, sizeof(*display));
	int error;

	if (!display) {
		log_error(options->log, "--display window: out of memory");
		return -ENOMEM;
	}
	display->log = *options->log;
	display->format =
		options->format_given ? options->format : PIXELS_RGBA8888;
	if (!window_probe()) {
		log_error(&display->log,
			"--display window: there is no desktop (DISPLAY and WAYLAND_DISPLAY are not set): write a file with limber render");
		free(display);
		return -ENODEV;
	}
	error = start_sdl(display);
	if (error) {
		free(display);
		return error;
	}
	error = open_window(display, options);
	if (!error) {
		error = resize(display, options->width, options->height);
	}
	if (error) {
		window_destroy(display);
		return error;
	}
	*out = display;
	return 0;
}

static void window_get_info(
	const struct display *display, struct display_info *out)
{
	*out = (struct display_info){
		.width = display->pixels.width,
		.height = display->pixels.height,
		.format = display->format,
	};
}

/* Pictures have a largest size. On a wall of screens a window may be larger. */
static int limit_side(int side)
{
	return side < PIXELS_SIZE_MAX ? side : PIXELS_SIZE_MAX;
}

static int window_begin_frame(struct display *display, struct pixels *out)
{
	int width = 0, height = 0;

	display->sdl.GetWindowSize(display->window, &width, &height);
	width = limit_side(width);
	height = limit_side(height);
	if (width > 0 && height > 0 &&
		(width != display->pixels.width ||
			height != display->pixels.height)) {
		int error = resize(display, width, height);

		if (error) {
			return error;
		}
	}
	*out = display->pixels;
	return 0;
}

static int window_end_frame(struct display *display)
{
	/* SDL owns the surface and replaces it when the size changes. */
	SDL_Surface *screen = display->sdl.GetWindowSurface(display->window);

	if (!screen ||
		display->sdl.UpperBlit(display->picture, NULL, screen, NULL) !=
			0 ||
		display->sdl.UpdateWindowSurface(display->window) != 0) {
		return failed(display, "SDL cannot show a picture");
	}
	return 0;
}

static void push_key(struct display *display, SDL_Keycode key, bool down,
	int64_t now_ms, struct button_queue *queue)
{
	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		if (keys[i].key == key) {
			display->pressed[i] = down;
			button_queue_push(queue,
				(struct button_event){now_ms, keys[i].button,
					down, (uint8_t)i});
		}
	}
}

/* A key released while another window has the focus sends no event here. */
static void release_all(
	struct display *display, int64_t now_ms, struct button_queue *queue)
{
	for (size_t i = 0; i < ARRAY_COUNT(keys); i++) {
		if (display->pressed[i]) {
			push_key(display, keys[i].key, false, now_ms, queue);
		}
	}
}

static void handle_key(struct display *display, const SDL_KeyboardEvent *key,
	int64_t now_ms, struct button_queue *queue,
	struct display_events *events)
{
	SDL_Keycode code = key->keysym.sym;

	if (key->repeat) {
		return;
	}
	if (key->state == SDL_PRESSED &&
		(code == SDLK_ESCAPE || code == SDLK_q)) {
		events->close = true;
	}
	if (key->state == SDL_PRESSED) {
		events->picture = events->picture || code == SDLK_p;
		events->graph += code == SDLK_h;
		events->overlay += code == SDLK_F7;
		events->joint += code == SDLK_PAGEDOWN;
		events->joint -= code == SDLK_PAGEUP;
	}
	push_key(display, code, key->state == SDL_PRESSED, now_ms, queue);
}

static void handle_window_event(struct display *display,
	const SDL_WindowEvent *event, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	switch (event->event) {
	case SDL_WINDOWEVENT_CLOSE:
		events->close = true;
		break;
	case SDL_WINDOWEVENT_SIZE_CHANGED:
		events->resized = true;
		break;
	case SDL_WINDOWEVENT_FOCUS_LOST:
		release_all(display, now_ms, queue);
		break;
	default:
		break;
	}
}

static void window_poll(struct display *display, int64_t now_ms,
	struct button_queue *queue, struct display_events *events)
{
	SDL_Event event;

	*events = (struct display_events){0};
	queue->exact = true;
	while (display->sdl.PollEvent(&event)) {
		switch (event.type) {
		case SDL_QUIT:
			events->close = true;
			break;
		case SDL_KEYDOWN:
		case SDL_KEYUP:
			handle_key(display, &event.key, now_ms, queue, events);
			break;
		case SDL_WINDOWEVENT:
			handle_window_event(
				display, &event.window, now_ms, queue, events);
			break;
		default:
			break;
		}
	}
	queue->exact = false;
}

const struct display_driver display_driver_window = {
	.name = "window",
	.summary = "a window on the desktop; Esc or Q closes it",
	.probe = window_probe,
	.create = window_create,
	.get_info = window_get_info,
	.begin_frame = window_begin_frame,
	.end_frame = window_end_frame,
	.poll = window_poll,
	.destroy = window_destroy,
	.survey = window_survey,
};
