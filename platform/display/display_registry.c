#include "platform/display/display.h"

#include <errno.h>
#include <string.h>

#include "platform/base/name_list.h"

#define DISPLAY_DRIVER(name) \
	extern const struct display_driver display_driver_##name;
#include "display_drivers.h"
#undef DISPLAY_DRIVER

const struct display_driver *const display_registry[] = {
#define DISPLAY_DRIVER(name) &display_driver_##name,
#include "display_drivers.h"
#undef DISPLAY_DRIVER
	NULL,
};

static struct name_list list_names(void)
{
	struct name_list names = {""};

	for (int i = 0; display_registry[i]; i++) {
		name_list_add(&names, display_registry[i]->name);
	}
	return names;
}

const struct display_driver *display_choose(
	const char *spec, const struct log *log)
{
	size_t length = strcspn(spec, ":");

	for (int i = 0; display_registry[i]; i++) {
		const struct display_driver *driver = display_registry[i];

		if (strlen(driver->name) != length ||
			strncmp(spec, driver->name, length) != 0) {
			continue;
		}
		if (spec[length] && !driver->argument) {
			log_error(log,
				"--display %s: %s takes no argument: write --display %s",
				spec, driver->name, driver->name);
			return NULL;
		}
		return driver;
	}
	log_error(log, "--display %s: no such display: choose one of auto, %s",
		spec, list_names().text);
	return NULL;
}

/* Fills *own with the options and the device that spec names. */
static int check_named(const char *spec, const struct display_options *options,
	struct display_options *own, const struct display_driver **driver)
{
	const char *colon = strchr(spec, ':');

	*driver = display_choose(spec, options->log);
	if (!*driver) {
		return -EINVAL;
	}
	*own = *options;
	own->device = colon && colon[1] ? colon + 1 : NULL;
	return (*driver)->check ? (*driver)->check(own) : 0;
}

int display_check(const char *spec, const struct display_options *options,
	const struct display_driver **driver)
{
	struct display_options own;

	return check_named(spec, options, &own, driver);
}

static int open_named(const char *spec, const struct display_options *options,
	const struct display_driver **driver, struct display **out)
{
	struct display_options own;
	int error = check_named(spec, options, &own, driver);

	return error ? error : (*driver)->create(&own, out);
}

static int open_any(const struct display_options *options,
	const struct display_driver **driver, struct display **out)
{
	struct display_options own = *options;
	int error = -ENODEV;

	own.device = NULL;
	for (int i = 0; error && display_registry[i]; i++) {
		*driver = display_registry[i];
		if (!(*driver)->probe || (*driver)->probe()) {
			error = (*driver)->create(&own, out);
		}
	}
	if (error) {
		log_error(options->log,
			"--display: found no screen to show pictures on: run limber doctor to see why, choose one of %s, or write a file with limber render",
			list_names().text);
	}
	return error;
}

int display_open(const char *spec, const struct display_options *options,
	const struct display_driver **driver, struct display **out)
{
	return !spec || strcmp(spec, "auto") == 0
		? open_any(options, driver, out)
		: open_named(spec, options, driver, out);
}
