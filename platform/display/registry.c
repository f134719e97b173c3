#include "platform/display/display.h"

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

const struct display_driver *display_find(const char *name)
{
	for (int i = 0; display_registry[i]; i++) {
		if (strcmp(name, display_registry[i]->name) == 0) {
			return display_registry[i];
		}
	}
	return NULL;
}

static const struct display_driver *find_by_probe(void)
{
	for (int i = 0; display_registry[i]; i++) {
		if (!display_registry[i]->probe || display_registry[i]->probe()) {
			return display_registry[i];
		}
	}
	return NULL;
}

const struct display_driver *display_choose(
	const char *name, const struct log *log)
{
	const struct display_driver *driver =
		name ? display_find(name) : find_by_probe();
	struct name_list names = {""};

	if (driver) {
		return driver;
	}
	for (int i = 0; display_registry[i]; i++) {
		name_list_add(&names, display_registry[i]->name);
	}
	if (name) {
		log_error(log, "--display %s: no such display: choose one of %s",
			name, names.text);
	} else {
		log_error(log,
			"--display: nothing to show pictures on was found: "
			"choose one of %s, or write a file with limber render",
			names.text);
	}
	return NULL;
}
