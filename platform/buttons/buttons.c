#include "platform/buttons/buttons.h"

#include <errno.h>
#include <string.h>

#include "platform/base/name_list.h"

enum {
	SPEC_ITEM_ROOM = 4096
};

static const struct button_driver *find_driver(
	const char *name, const struct log *log)
{
	struct name_list names = {""};

	for (int i = 0; button_registry[i]; i++) {
		if (strcmp(name, button_registry[i]->name) == 0) {
			return button_registry[i];
		}
		name_list_add(&names, button_registry[i]->name);
	}
	log_error(log, "--buttons %s: no such source: choose among %s", name,
		names.text);
	return NULL;
}

int buttons_add(struct buttons *buttons, const char *driver,
	const char *argument, const struct log *log)
{
	const struct button_driver *found = find_driver(driver, log);
	int next = buttons->source_count;
	int error;

	if (!found) {
		return -EINVAL;
	}
	if (next == BUTTON_SOURCES_MAX) {
		log_error(log, "--buttons: no more than %d sources at once",
			BUTTON_SOURCES_MAX);
		return -E2BIG;
	}
	error = found->create(argument, log, &buttons->source[next].source);
	if (error) {
		return error;
	}
	buttons->source[next].driver = found;
	buttons->source_count++;
	return 0;
}

/* One "NAME" or "NAME:ARGUMENT" of length bytes. */
static int open_item(struct buttons *buttons, const char *item, size_t length,
	const struct log *log)
{
	char name[SPEC_ITEM_ROOM];
	char *colon;

	if (length >= sizeof(name)) {
		log_error(log, "--buttons: a source of more than %d characters",
			SPEC_ITEM_ROOM - 1);
		return -ENAMETOOLONG;
	}
	memcpy(name, item, length);
	name[length] = '\0';
	colon = strchr(name, ':');
	if (colon) {
		*colon = '\0';
	}
	return buttons_add(buttons, name, colon ? colon + 1 : NULL, log);
}

int buttons_open(
	struct buttons *buttons, const char *spec, const struct log *log)
{
	buttons->source_count = 0;
	button_queue_init(&buttons->queue, BUTTON_DEBOUNCE_MS);
	while (spec && *spec) {
		size_t length = strcspn(spec, ",");
		int error = open_item(buttons, spec, length, log);

		if (error) {
			buttons_close(buttons);
			return error;
		}
		spec += length;
		spec += *spec == ',';
	}
	return 0;
}

void buttons_poll(struct buttons *buttons, int64_t now_ms)
{
	for (int i = 0; i < buttons->source_count; i++) {
		buttons->source[i].driver->poll(
			buttons->source[i].source, now_ms, &buttons->queue);
	}
	button_queue_settle(&buttons->queue, now_ms);
}

void buttons_close(struct buttons *buttons)
{
	while (buttons->source_count > 0) {
		int last = --buttons->source_count;

		buttons->source[last].driver->destroy(
			buttons->source[last].source);
	}
}
