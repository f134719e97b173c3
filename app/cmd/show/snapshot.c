#include "app/cmd/show/snapshot.h"

#include "app/cmd/show/film.h"
#include "platform/base/file.h"

#include <stdio.h>
#include <stdlib.h>

enum {
	NUMBER_MAX = 9999
};

/* Writes a picture as a film of one frame. */
static int write_picture(
	const char *path, const struct pixels *picture, const struct log *log)
{
	struct film film;
	int error = film_open(&film, path, picture, 1.0, 1, log);
	int close_error;

	if (error) {
		return error;
	}
	error = film_add(&film, picture, 0.0);
	close_error = film_close(&film);
	return error ? error : close_error;
}

static void write_snapshot(void *context)
{
	const struct snapshot *snapshot = context;
	char path[32];
	int number = 1;

	do {
		snprintf(path, sizeof(path), "limber-%04d.png", number);
	} while (file_exists(path) && ++number <= NUMBER_MAX);
	if (number > NUMBER_MAX) {
		log_error(&snapshot->log,
			"%s: all numbers up to this one are in use: move pictures elsewhere",
			path);
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
	pixels_copy(copy, picture);
	snapshot->log = *log;
	background_begin(&snapshot->background, write_snapshot, snapshot);
}

void snapshot_finish(struct snapshot *snapshot)
{
	background_wait(&snapshot->background);
	free(snapshot->picture.data);
	snapshot->picture = (struct pixels){0};
}
