#include "platform/display/display.h"

#include <string.h>

#define DISPLAY_DRIVER(name)                                                   \
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
