#include "platform/camera/camera.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/name_list.h"

enum {
	SPEC_BYTES = 4096,
	DEFAULT_WIDTH = 320,
	DEFAULT_HEIGHT = 240
};

static bool read_side(const char *text, char end, char **after, int *out)
{
	long value;

	if (*text < '0' || *text > '9') {
		return false;
	}
	value = strtol(text, after, 10);
	if (**after != end || value < 1 || value > CAMERA_SIDE_MAX) {
		return false;
	}
	*out = (int)value;
	return true;
}

static bool read_size(const char *text, struct camera_options *options)
{
	char *end;

	return read_side(text, 'x', &end, &options->width) &&
		read_side(end + 1, '\0', &end, &options->height);
}

/* Reads what follows a comma of spec: WxH or FORMAT. */
static int read_modifier(
	const char *spec, const char *text, struct camera_options *options)
{
	if (*text >= '0' && *text <= '9') {
		if (read_size(text, options)) {
			return 0;
		}
		log_error(options->log,
			"--camera %s: %s is no size: give a size such as 320x240, up to %dx%d",
			spec, text, CAMERA_SIDE_MAX, CAMERA_SIDE_MAX);
		return -EINVAL;
	}
	if (*text == '\0') {
		log_error(options->log,
			"--camera %s: give a size or a format after the comma",
			spec);
		return -EINVAL;
	}
	options->format = text;
	return 0;
}

static const struct camera_driver *find_driver(
	const char *spec, const char *name, const struct log *log)
{
	struct name_list names = {""};

	for (int i = 0; camera_registry[i]; i++) {
		if (strcmp(name, camera_registry[i]->name) == 0) {
			return camera_registry[i];
		}
		name_list_add(&names, camera_registry[i]->name);
	}
	log_error(log,
		"--camera %s: no such camera: give a device such as /dev/video0, auto, or one of %s",
		spec, names.text);
	return NULL;
}

/* Splits name, a copy of spec, into driver, argument, size and format. */
static int read_spec(const char *spec, char *name,
	struct camera_options *options, const struct camera_driver **driver)
{
	char *comma = strchr(name, ',');
	char *colon;

	while (comma) {
		char *modifier = comma + 1;
		int error;

		*comma = '\0';
		comma = strchr(modifier, ',');
		if (comma) {
			*comma = '\0';
		}
		error = read_modifier(spec, modifier, options);
		if (error) {
			return error;
		}
	}
	if (name[0] == '/' || strcmp(name, "auto") == 0) {
		options->argument = name[0] == '/' ? name : NULL;
		*driver = find_driver(spec, "v4l2", options->log);
		return *driver ? 0 : -EINVAL;
	}
	colon = strchr(name, ':');
	if (colon) {
		*colon = '\0';
		options->argument = colon + 1;
	}
	*driver = find_driver(spec, name, options->log);
	return *driver ? 0 : -EINVAL;
}

/* Reads spec, copied to name, which *options points into. */
static int read_all(const char *spec, const struct log *log,
	char name[SPEC_BYTES], struct camera_options *options,
	const struct camera_driver **driver)
{
	*options = (struct camera_options){
		.width = DEFAULT_WIDTH, .height = DEFAULT_HEIGHT, .log = log};
	if (strlen(spec) >= SPEC_BYTES) {
		log_error(log, "--camera: give at most %d characters",
			SPEC_BYTES - 1);
		return -EINVAL;
	}
	strcpy(name, spec);
	return read_spec(spec, name, options, driver);
}

int camera_feed_check(const char *spec, const struct log *log)
{
	const struct camera_driver *driver;
	struct camera_options options;
	char name[SPEC_BYTES];

	return read_all(spec, log, name, &options, &driver);
}

int camera_feed_open(
	const char *spec, const struct log *log, struct camera_feed *out)
{
	struct camera_options options;
	char name[SPEC_BYTES];
	int error;

	*out = (struct camera_feed){0};
	error = read_all(spec, log, name, &options, &out->driver);
	if (!error) {
		error = out->driver->create(&options, &out->source);
	}
	if (error) {
		*out = (struct camera_feed){0};
	}
	return error;
}

void camera_feed_close(struct camera_feed *feed)
{
	if (feed->driver) {
		feed->driver->destroy(feed->source);
	}
	*feed = (struct camera_feed){0};
}
