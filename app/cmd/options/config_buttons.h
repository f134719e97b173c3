/*
 * The [buttons] section of limber.conf, which becomes a --buttons SPEC.
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
	CONFIG_LIST_ROOM = 4000
};

/* Begins zeroed. */
struct config_buttons {
	char lines[CONFIG_LIST_ROOM]; /* ",UP=chip 18,..." */
	char keys[CONFIG_LIST_ROOM];  /* ",UP=KEY_W,..." */
	char keyboard[256];           /* part of a name, a path, or "" */
	bool keyboard_given, no_keyboard;
	char sources[1024];
};

/* All keys of the section, NULL at the end. */
extern const char *const config_buttons_keys[];

/* One key. 0, or -EINVAL after a sentence. */
int config_buttons_set(struct config_buttons *buttons, const char *key,
	const char *value, const struct log *log);

/* The SPEC, "" for none; at most size bytes. -EINVAL after a sentence. */
int config_buttons_spec(const struct config_buttons *buttons, char *spec,
	size_t size, const struct log *log);

#endif
