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

static bool is_auto(const char *name)
{
	return !name || strcmp(name, "auto") == 0;
}

static const struct gl_driver *find(const char *name)
{
	for (int i = 0; gl_registry[i]; i++) {
		if (strcmp(name, gl_registry[i]->name) == 0) {
			return gl_registry[i];
		}
	}
	return NULL;
}

/*
 * Whether "auto" tries a driver. For a native surface any driver with .surface
 * suits, accelerated or not.
 */
static bool suits_auto(
	const struct gl_driver *driver, const struct gl_request *request)
{
	if (request->surface) {
		return driver->surface;
	}
	return !driver->probe || driver->probe() ||
		(driver->accelerates && request->egl_library);
}

static int open_any(const struct gl_request *request, struct gl_context **out)
{
	int error = -ENOENT;

	for (int i = 0; error && gl_registry[i]; i++) {
		const struct gl_driver *driver = gl_registry[i];

		if (!suits_auto(driver, request)) {
			continue;
		}
		error = driver->create(request, out);
		if (!error && !request->surface && driver->accelerates &&
			!(*out)->accelerated) {
			log_note(request->log,
				"--gl auto: skipped %s, which uses no graphics processor (%s)",
				driver->name, (*out)->description);
			driver->destroy(*out);
			error = -ENOENT;
		}
	}
	if (error && !request->surface) {
		log_error(request->log,
			"--gl auto: no GL driver could be opened: choose one with --gl");
	}
	if (error) {
		return error;
	}
	log_note(request->log, "--gl auto: using %s (%s)", (*out)->driver->name,
		(*out)->description);
	return 0;
}

bool gl_is_known(const char *name, const struct log *log)
{
	struct name_list names = {"auto"};

	if (is_auto(name) || find(name)) {
		return true;
	}
	for (int i = 0; gl_registry[i]; i++) {
		name_list_add(&names, gl_registry[i]->name);
	}
	log_error(log, "--gl %s: no such driver: choose one of %s", name,
		names.text);
	return false;
}

bool gl_can_draw(const char *name, bool on_surface)
{
	return is_auto(name) || !on_surface || find(name)->surface;
}

int gl_open(const char *name, const struct gl_request *request,
	struct gl_context **out)
{
	if (!gl_is_known(name, request->log)) {
		return -EINVAL;
	}
	if (!gl_can_draw(name, request->surface != NULL)) {
		log_error(request->log,
			"--gl %s: it can only draw into memory, but this display provides none: choose --gl gles1, or another --display",
			name);
		return -EINVAL;
	}
	return is_auto(name) ? open_any(request, out)
			     : find(name)->create(request, out);
}
