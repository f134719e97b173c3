/*
 * The [buttons] section of limber.conf, which becomes the value of --buttons.
 *
 *	UP = gpio 53fd0000.gpio 18 active-low pull-up debounce=20
 *	ENTER = gpio KEY_COL4, key KEY_KPENTER
 *	keyboard = all
 *	sources = script:run.txt
 */
#ifndef APP_CMD_OPTIONS_CONFIG_BUTTONS_H
#define APP_CMD_OPTIONS_CONFIG_BUTTONS_H

#include <stdbool.h>
#include <stddef.h>

#include "platform/base/log.h"

enum {
	CONFIG_LIST_BYTES = 4000
};

/* The values of the keys that were read. The caller zeroes it first. */
struct config_buttons {
	char lines[CONFIG_LIST_BYTES]; /* ",UP=chip 18,..." */
	char keys[CONFIG_LIST_BYTES];  /* ",UP=KEY_W,..." */
	char keyboard[256]; /* part of a device's name, a path, or "": all */
	bool keyboard_given, no_keyboard;
	char sources[1024];
};

/* The keys that the section may have; ends with NULL. */
extern const char *const config_buttons_keys[];

/*
 * Reads one "key = value" line. Returns 0, or -EINVAL after logging an error.
 */
int config_buttons_set(struct config_buttons *buttons, const char *key,
	const char *value, const struct log *log);

/*
 * Writes the value of --buttons to spec, of size bytes; "" when no key was set.
 * Returns 0, or -EINVAL after logging an error when it is too long.
 */
int config_buttons_spec(const struct config_buttons *buttons, char *spec,
	size_t size, const struct log *log);

#endif
