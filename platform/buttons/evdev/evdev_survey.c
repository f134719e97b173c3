/* The keyboards and keypads that limber doctor reports. */
#include <errno.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

#include "platform/base/name_list.h"
#include "platform/buttons/evdev/system.h"

enum {
	PATH_BYTES = 256,
	NUMBERS_MAX = 256
};

/* The names of the buttons that the device's keys are mapped to. */
static struct name_list mapped_buttons(
	const struct evdev_description *description)
{
	const struct evdev_keys keys = evdev_keys_default();
	struct name_list list = {""};
	bool has[BUTTON_COUNT + 1] = {false};

	for (unsigned int code = 0; code < EVDEV_KEYS; code++) {
		if (evdev_key_bit(description->keys, code)) {
			has[evdev_keys_find(&keys, code)] = true;
		}
	}
	for (int i = 0; i < BUTTON_COUNT; i++) {
		if (has[i]) {
			name_list_add(&list, button_name((enum button)i));
		}
	}
	return list;
}

static bool has_keys(const struct evdev_description *description)
{
	for (size_t i = 0; i < sizeof(description->keys); i++) {
		if (description->keys[i]) {
			return true;
		}
	}
	return false;
}

static void report_device(const char *path,
	const struct evdev_description *description, const struct survey *survey)
{
	struct name_list buttons = mapped_buttons(description);
	char remedy[PATH_BYTES + 80];

	if (buttons.text[0]) {
		survey_report(survey, SURVEY_WORKS, path, NULL, "%s: %s",
			description->name, buttons.text);
		return;
	}
	snprintf(remedy, sizeof(remedy),
		"to use a key of it: --buttons evdev:%s,UP=KEY, with a KEY that evtest shows",
		path);
	survey_report(survey, SURVEY_UNUSED, path,
		has_keys(description) ? remedy : NULL,
		"%s: no key is mapped to a button", description->name);
}

/* Reports the device of that number; false when there is none. */
static bool report_number(const struct evdev_system *system, int number,
	const struct survey *survey)
{
	struct evdev_description description;
	char path[PATH_BYTES], entry[64];
	int fd, error;

	if (snprintf(path, sizeof(path), "%s/event%d", system->directory,
		    number) >= (int)sizeof(path)) {
		return false;
	}
	fd = system->open(path);
	if (fd == -EACCES || fd == -EPERM) {
		survey_report_denied(survey, path);
		return true;
	}
	if (fd < 0) {
		snprintf(entry, sizeof(entry), "class/input/event%d", number);
		return survey_report_no_node(survey, path, entry, fd);
	}
	error = system->describe(fd, &description);
	close(fd);
	if (error) {
		survey_report(survey, SURVEY_BROKEN, path,
			"unplug it and plug it in again",
			"it does not answer as a keyboard: %s",
			strerror(-error));
	} else {
		report_device(path, &description, survey);
	}
	return true;
}

void evdev_survey_on(
	const struct evdev_system *system, const struct survey *survey)
{
	bool any = false;

	for (int i = 0; i < NUMBERS_MAX; i++) {
		any = report_number(system, i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "evdev",
			"plug a keyboard in, or load the driver: sudo modprobe evdev",
			"there is no keyboard or keypad in %s",
			system->directory);
	}
}
