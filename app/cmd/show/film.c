#include "app/cmd/show/film.h"

#include "platform/base/file.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	PICTURES_MAX = 9999,
	BEHIND_MAX = 50 /* moments made up for after a long pause */
};

static int open_file(const struct display_driver **driver,
	struct display **display, const char *path, const struct pixels *size,
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

	return display_open("image", &options, driver, display);
}

static void copy_rows(const struct pixels *to, const struct pixels *from)
{
	size_t row = (size_t)from->width * (size_t)pixel_bytes(from->format);

	for (int y = 0; y < from->height; y++) {
		memcpy(to->data + (size_t)y * (size_t)to->stride_bytes,
			from->data + (size_t)y * (size_t)from->stride_bytes,
			row);
	}
}

static int write_frame(const struct display_driver *driver,
	struct display *display, const struct pixels *picture)
{
	struct pixels frame;
	int error = driver->begin_frame(display, &frame);

	if (error) {
		return error;
	}
	copy_rows(&frame, picture);
	return driver->end_frame(display);
}

int film_open(struct film *film, const char *path, const struct pixels *size,
	double rate_hz, const struct log *log)
{
	*film = (struct film){.log = *log,
		.rate_hz = rate_hz,
		.next_s = -1.0,
		.width = size->width,
		.height = size->height};
	return open_file(
		&film->driver, &film->display, path, size, rate_hz, 0, log);
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
				"--record: pictures of another size than the "
				"first are left out");
		}
		film->resized = true;
		return 0;
	}
	if (film->next_s < 0.0 ||
		now_s - film->next_s > BEHIND_MAX / film->rate_hz) {
		film->next_s = now_s;
	}
	/* A thousandth of a frame early is in time. */
	while (!error && film->next_s <= now_s + 0.001 / film->rate_hz) {
		error = write_frame(film->driver, film->display, picture);
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

static int write_picture(
	const char *path, const struct pixels *picture, const struct log *log)
{
	const struct display_driver *driver;
	struct display *display;
	int error = open_file(&driver, &display, path, picture, 1.0, 1, log);

	if (error) {
		return error;
	}
	error = write_frame(driver, display, picture);
	if (!error) {
		error = driver->finish(display);
	}
	driver->destroy(display);
	return error;
}

static void write_snapshot(void *context)
{
	const struct snapshot *snapshot = context;
	char path[32];
	int number = 1;

	do {
		snprintf(path, sizeof(path), "limber-%04d.png", number);
	} while (file_exists(path) && ++number <= PICTURES_MAX);
	if (number > PICTURES_MAX) {
		log_error(&snapshot->log,
			"%s: there are too many pictures already", path);
		return;
	}
	if (write_picture(path, &snapshot->picture, &snapshot->log) == 0) {
		printf("limber: the picture is in %s\n", path);
		fflush(stdout);
	}
}

void snapshot_take(struct snapshot *snapshot, const struct pixels *picture,
	const struct log *log)
{
	struct pixels *copy = &snapshot->picture;

	snapshot_finish(snapshot);
	if (pixels_alloc(copy, picture->width, picture->height, picture->format,
		    log) != 0) {
		return;
	}
	copy_rows(copy, picture);
	snapshot->log = *log;
	background_begin(&snapshot->background, write_snapshot, snapshot);
}

void snapshot_finish(struct snapshot *snapshot)
{
	background_wait(&snapshot->background);
	free(snapshot->picture.data);
	snapshot->picture = (struct pixels){0};
}

/* GL's first row is the lowest. */
static void turn_over(struct pixels *picture, uint8_t *row)
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

int film_look(const struct pixels *on, const struct gl *gl, int width,
	int height, struct pixels *room, struct pixels *out,
	const struct log *log)
{
	uint8_t *row;
	int error;

	if (on) {
		*out = *on;
		return 0;
	}
	if (room->width != width || room->height != height) {
		free(room->data);
		*room = (struct pixels){0};
		/* A row more, to turn the others over. */
		error = pixels_alloc(
			room, width, height + 1, PIXELS_RGBA8888, log);
		if (error) {
			return error;
		}
		room->height = height;
	}
	gl->ReadPixels(
		0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, room->data);
	row = room->data + (size_t)height * (size_t)room->stride_bytes;
	turn_over(room, row);
	*out = *room;
	return 0;
}
