#include "app/cmd/show/show_screen.h"

#include <errno.h>
#include <string.h>

static bool has_surface(const struct display_driver *driver)
{
	return driver->get_surface != NULL;
}

static bool is_auto(const char *name)
{
	return !name || strcmp(name, "auto") == 0;
}

int screen_check(const struct options *options, const struct log *log)
{
	const struct display_driver *driver;

	if (options->screen.gl && !gl_is_known(options->screen.gl, log)) {
		return -EINVAL;
	}
	if (is_auto(options->screen.display)) {
		return 0;
	}
	driver = display_choose(options->screen.display, log);
	if (!driver) {
		return -EINVAL;
	}
	if (!gl_can_draw(options->screen.gl, has_surface(driver))) {
		log_error(log,
			"--display %s with --gl %s: it draws into memory, and "
			"%s has none to offer: choose --gl gles1, or --display "
			"fbdev or kms",
			driver->name, options->screen.gl, driver->name);
		return -EINVAL;
	}
	return 0;
}

static int open_gl(struct screen *screen, const struct options *options,
	const struct log *log)
{
	struct native_surface surface;
	struct gl_request request = {
		.format = screen->info.format,
		.egl_library = options->screen.egl_library,
		.gles_library = options->screen.gles_library,
		.log = log,
	};

	if (has_surface(screen->driver)) {
		screen->driver->get_surface(screen->display, &surface);
		request.surface = &surface;
	}
	return gl_open_for(options->screen.gl, &request, &screen->gl);
}

int screen_open(struct screen *screen, const struct options *options,
	const char *display, int frames, double rate_hz, const struct log *log)
{
	const struct display_options wanted = {
		.width = options->screen.size.width,
		.height = options->screen.size.height,
		.size_given = options->screen.size.given,
		.format = options->screen.format,
		.format_given = options->screen.format_given,
		.title = "limber",
		.output = options->screen.output,
		.frame_count = frames,
		.rate_hz = rate_hz,
		.log = log,
	};
	int error = display_open(
		display, &wanted, &screen->driver, &screen->display);

	if (error) {
		return error;
	}
	screen->driver->get_info(screen->display, &screen->info);
	error = open_gl(screen, options, log);
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

int screen_begin_frame(struct screen *screen, int *width, int *height)
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

int screen_complete_frame(struct screen *screen)
{
	return has_surface(screen->driver)
		? 0
		: screen->gl->driver->end_frame(screen->gl);
}

int screen_end_frame(struct screen *screen)
{
	int error = has_surface(screen->driver)
		? screen->gl->driver->end_frame(screen->gl)
		: 0;

	return error ? error : screen->driver->end_frame(screen->display);
}

void screen_close(struct screen *screen)
{
	screen->gl->driver->destroy(screen->gl);
	screen->driver->destroy(screen->display);
}
