#include "platform/gl/gl_context.h"

#include <errno.h>
#include <stdbool.h>
#include <string.h>

#define GL_DRIVER(name) extern const struct gl_driver gl_driver_##name;
#include "gl_drivers.h"
#undef GL_DRIVER

const struct gl_driver *const gl_registry[] = {
#define GL_DRIVER(name) &gl_driver_##name,
#include "gl_drivers.h"
#undef GL_DRIVER
	NULL,
};

int gl_open(const char *name, enum pixel_format format, const struct log *log,
	struct gl_context **out)
{
	bool any = !name || strcmp(name, "auto") == 0;
	int error = -ENOENT;

	for (int i = 0; gl_registry[i]; i++) {
		if (any || strcmp(name, gl_registry[i]->name) == 0) {
			error = gl_registry[i]->create(format, log, out);
			if (!error || !any) {
				return error;
			}
		}
	}
	log_error(log, any ? "--gl: no GL driver opens on this machine: see "
			     "limber doctor"
			   : "--gl %s: no such driver: choose auto or one of "
			     "those that limber --help lists", name);
	return error;
}
