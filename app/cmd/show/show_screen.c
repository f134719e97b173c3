#include "app/cmd/show/show_screen.h"

#include <stdlib.h>
#include <string.h>

static bool has_surface(const struct display_driver *driver)
{
	return driver->get_surface != NULL;
}

static bool is_auto(const char *name)
{
	return !name || strcmp(name, "auto") == 0;
}

static struct display_options display_options_of(
	const struct options_screen *options, const struct log *log)
{
	return (struct display_options){
		.width = options->size.width,
		.height = options->size.height,
		.size_given = options->size.given,
		.format = options->format,
		.format_given = options->format_given,
		.title = "limber",
		.output = options->output,
		.log = log,
	};
}

bool show_screen_check(const struct options_screen *options,
	const char *display, const struct log *log)
{
	const struct display_options wanted = display_options_of(options, log);
	const struct display_driver *driver;

	if (options->gl && !gl_is_known(options->gl, log)) {
		return false;
	}
	if (is_auto(display)) {
		return true;
	}
	if (display_check(display, &wanted, &driver) != 0) {
		return false;
	}
	if (!gl_can_draw(options->gl, has_surface(driver))) {
		log_error(log,
			"--display %s with --gl %s: this GL driver draws into memory, which %s does not offer: choose --gl gles1, or --display fbdev or kms",
			driver->name, options->gl, driver->name);
		return false;
	}
	return true;
}

static int open_gl(struct show_screen *screen,
	const struct options_screen *options, const struct log *log)
{
	struct native_surface surface;
	struct gl_request request = {
		.format = screen->info.format,
		.egl_library = options->egl_library,
		.gles_library = options->gles_library,
		.log = log,
	};

	if (has_surface(screen->driver)) {
		screen->driver->get_surface(screen->display, &surface);
		request.surface = &surface;
	}
	return gl_open(options->gl, &request, &screen->gl);
}

int show_screen_open(struct show_screen *screen, const struct options *options,
	const char *display, int frames, double rate_hz, const struct log *log)
{
	struct display_options wanted =
		display_options_of(&options->screen, log);
	int error;

	wanted.frame_count = frames;
	wanted.rate_hz = rate_hz;
	error = display_open(
		display, &wanted, &screen->driver, &screen->display);
	if (error) {
		return error;
	}
	screen->driver->get_info(screen->display, &screen->info);
	error = open_gl(screen, &options->screen, log);
	if (error) {
		screen->driver->destroy(screen->display);
		return error;
	}
	if (has_surface(screen->driver)) {
		screen->info.width = screen->gl->width;
		screen->info.height = screen->gl->height;
	}
	return 0;
}

int show_screen_begin_frame(struct show_screen *screen, int *width, int *height)
{
	struct gl_context *gl = screen->gl;
	struct pixels pixels;
	int error;

	screen->pixels = (struct pixels){0};
	if (has_surface(screen->driver)) {
		error = gl->driver->begin_frame(gl, NULL);
		*width = gl->width;
		*height = gl->height;
		return error;
	}
	error = screen->driver->begin_frame(screen->display, &pixels);
	if (!error) {
		error = gl->driver->begin_frame(gl, &pixels);
		screen->pixels = pixels;
		*width = pixels.width;
		*height = pixels.height;
	}
	return error;
}

int show_screen_complete_frame(struct show_screen *screen)
{
	return has_surface(screen->driver)
		? 0
		: screen->gl->driver->end_frame(screen->gl);
}

/* Flips a picture that ReadPixels() read, whose first row is the lowest. */
static void flip_rows(struct pixels *picture, uint8_t *row)
{
	size_t bytes = (size_t)picture->stride_bytes;

	for (int y = 0; y < picture->height / 2; y++) {
		uint8_t *upper = picture->data + (size_t)y * bytes;
		uint8_t *lower = picture->data +
			(size_t)(picture->height - 1 - y) * bytes;

		memcpy(row, upper, bytes);
		memcpy(upper, lower, bytes);
		memcpy(lower, row, bytes);
	}
}

/*
 * Reads the surface into read_back, which is reallocated if the size changes.
 */
static int read_surface(struct show_screen *screen, const struct log *log)
{
	struct pixels *picture = &screen->read_back;
	int width = screen->gl->width, height = screen->gl->height;
	int error;

	if (picture->width != width || picture->height != height) {
		free(picture->data);
		*picture = (struct pixels){0};
		/* The extra row is scratch for flip_rows(). */
		error = pixels_alloc(
			picture, width, height + 1, PIXELS_RGBA8888, log);
		if (error) {
			return error;
		}
		picture->height = height;
	}
	screen->gl->gl.ReadPixels(
		0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, picture->data);
	flip_rows(picture,
		picture->data + (size_t)height * (size_t)picture->stride_bytes);
	return 0;
}

int show_screen_picture(
	struct show_screen *screen, struct pixels *out, const struct log *log)
{
	int error = 0;

	if (!screen->pixels.data) {
		error = read_surface(screen, log);
	}
	*out = screen->pixels.data ? screen->pixels : screen->read_back;
	return error;
}

int show_screen_end_frame(struct show_screen *screen)
{
	int error = has_surface(screen->driver)
		? screen->gl->driver->end_frame(screen->gl)
		: 0;

	return error ? error : screen->driver->end_frame(screen->display);
}

void show_screen_close(struct show_screen *screen)
{
	free(screen->read_back.data);
	screen->gl->driver->destroy(screen->gl);
	screen->driver->destroy(screen->display);
}
