#include "app/cmd/show/film.h"

#include <stddef.h>

enum {
	CATCH_UP_MAX = 50 /* most frames that fill a long pause */
};

int film_open(struct film *film, const char *path, const struct pixels *size,
	double rate_hz, int frames, const struct log *log)
{
	const struct display_options options = {
		.width = size->width,
		.height = size->height,
		.size_given = true,
		.format = size->format,
		.format_given = true,
		.output = path,
		.frame_count = frames,
		.rate_hz = rate_hz,
		.log = log,
	};

	*film = (struct film){
		.log = *log,
		.rate_hz = rate_hz,
		.next_s = -1.0,
		.width = size->width,
		.height = size->height,
	};
	return display_open("image", &options, &film->driver, &film->display);
}

static int write_frame(const struct film *film, const struct pixels *picture)
{
	struct pixels frame;
	int error = film->driver->begin_frame(film->display, &frame);

	if (error) {
		return error;
	}
	pixels_copy(&frame, picture);
	return film->driver->end_frame(film->display);
}

int film_add(struct film *film, const struct pixels *picture, double now_s)
{
	int error = 0;

	if (!film->display) {
		return 0;
	}
	if (picture->width != film->width || picture->height != film->height) {
		if (!film->resized) {
			log_warning(&film->log,
				"--record: the size of the pictures has changed: the film leaves them out");
		}
		film->resized = true;
		return 0;
	}
	if (film->next_s < 0.0 ||
		now_s - film->next_s > CATCH_UP_MAX / film->rate_hz) {
		film->next_s = now_s;
	}
	/* Times are rounded: up to a thousandth of a frame early is in time. */
	while (!error && film->next_s <= now_s + 0.001 / film->rate_hz) {
		error = write_frame(film, picture);
		film->next_s += 1.0 / film->rate_hz;
	}
	return error;
}

int film_close(struct film *film)
{
	int error = 0;

	if (film->display) {
		if (film->next_s >= 0.0) {
			error = film->driver->finish(film->display);
		}
		film->driver->destroy(film->display);
		film->display = NULL;
	}
	return error;
}
