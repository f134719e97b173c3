#include "platform/gl/gl_context.h"

#include <errno.h>
#include <string.h>

#include "platform/base/name_list.h"

#define GL_DRIVER(name) extern const struct gl_driver gl_driver_##name;
#include "gl_drivers.h"
#undef GL_DRIVER

const struct gl_driver *const gl_registry[] = {
#define GL_DRIVER(name) &gl_driver_##name,
#include "gl_drivers.h"
#undef GL_DRIVER
	NULL,
};

static int open_first(enum pixel_format format, const struct log *log,
	struct gl_context **out)
{
	int error = -ENOENT;

	for (int i = 0; gl_registry[i]; i++) {
		error = gl_registry[i]->create(format, log, out);
		if (!error) {
			break;
		}
	}
	return error;
}

/* What a driver misses matters only when no other takes its place. */
static int open_any(enum pixel_format format, const struct log *log,
	struct gl_context **out)
{
	struct log nowhere = log_to_nowhere();
	int error = open_first(format, &nowhere, out);

	if (error) {
		error = open_first(format, log, out);
	}
	if (error) {
		log_error(log, "--gl auto: no GL driver opens here: see above");
		return error;
	}
	log_note(log, "--gl auto: using %s", (*out)->driver->name);
	return 0;
}

bool gl_is_known(const char *name, const struct log *log)
{
	struct name_list names = {"auto"};

	if (strcmp(name, "auto") == 0) {
		return true;
	}
	for (int i = 0; gl_registry[i]; i++) {
		if (strcmp(name, gl_registry[i]->name) == 0) {
			return true;
		}
		name_list_add(&names, gl_registry[i]->name);
	}
	log_error(log, "--gl %s: no such driver: choose one of %s", name,
		names.text);
	return false;
}

int gl_open(const char *name, enum pixel_format format, const struct log *log,
	struct gl_context **out)
{
	if (!name || strcmp(name, "auto") == 0) {
		return open_any(format, log, out);
	}
	for (int i = 0; gl_registry[i]; i++) {
		if (strcmp(name, gl_registry[i]->name) == 0) {
			return gl_registry[i]->create(format, log, out);
		}
	}
	gl_is_known(name, log); /* says which there are */
	return -EINVAL;
}
