#include "platform/buttons/buttons.h"

#include <errno.h>
#include <string.h>

#include "platform/base/name_list.h"

enum {
	SPEC_ITEM_BYTES = 4096
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
		log_error(log, "--buttons: give at most %d sources",
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

/* The two parts of a source's "NAME:ARGUMENT" or "NAME". */
struct spec_item {
	char text[SPEC_ITEM_BYTES];
	const char *argument; /* NULL when there is none */
};

/* True for "WORD=...", which belongs to the source before it. */
static bool continues_source(const char *item)
{
	return item[strcspn(item, "=:,")] == '=';
}

/* Reads the first source of *spec and moves *spec behind it. */
static int next_item(
	const char **spec, struct spec_item *item, const struct log *log)
{
	size_t length = strcspn(*spec, ",");
	char *colon;

	while ((*spec)[length] && continues_source(*spec + length + 1)) {
		length += 1 + strcspn(*spec + length + 1, ",");
	}
	if (length >= sizeof(item->text)) {
		log_error(log,
			"--buttons: a source may have at most %d characters",
			SPEC_ITEM_BYTES - 1);
		return -EINVAL;
	}
	memcpy(item->text, *spec, length);
	item->text[length] = '\0';
	colon = item->text + strcspn(item->text, ":");
	item->argument = *colon ? colon + 1 : NULL;
	*colon = '\0';
	*spec += length + ((*spec)[length] == ',');
	return 0;
}

int buttons_open(
	struct buttons *buttons, const char *spec, const struct log *log)
{
	struct spec_item item;

	buttons->source_count = 0;
	button_queue_init(&buttons->queue, BUTTON_DEBOUNCE_MS);
	while (spec && *spec) {
		int error = next_item(&spec, &item, log);

		if (!error) {
			error = buttons_add(
				buttons, item.text, item.argument, log);
		}
		if (error) {
			buttons_close(buttons);
			return error;
		}
	}
	return 0;
}

int buttons_check(const char *spec, const struct log *log)
{
	struct spec_item item;

	while (spec && *spec) {
		const struct button_driver *driver;
		int error = next_item(&spec, &item, log);

		if (error) {
			return error;
		}
		driver = find_driver(item.text, log);
		if (!driver) {
			return -EINVAL;
		}
		error = driver->check ? driver->check(item.argument, log) : 0;
		if (error) {
			return error;
		}
	}
	return 0;
}

void buttons_poll(struct buttons *buttons, int64_t now_ms)
{
	for (int i = 0; i < buttons->source_count; i++) {
		buttons->queue.source = i + 1;
		buttons->queue.exact = buttons->source[i].driver->exact;
		buttons->source[i].driver->poll(
			buttons->source[i].source, now_ms, &buttons->queue);
	}
	buttons->queue.source = 0;
	buttons->queue.exact = false;
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
