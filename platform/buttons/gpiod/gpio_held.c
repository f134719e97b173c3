#include "platform/buttons/gpiod/gpio_held.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "platform/base/name_list.h"
#include "platform/buttons/device_access.h"

enum {
	DEVICES_MAX = 128 /* /dev/gpiochip0 to 127; numbers may have gaps */
};

void gpio_chips_open(struct gpio_chips *chips)
{
	*chips = (struct gpio_chips){.count = 0};
	for (int i = 0; i < DEVICES_MAX && chips->count < GPIO_CHIPS_MAX; i++) {
		char path[32];
		int error;

		snprintf(path, sizeof(path), "/dev/gpiochip%d", i);
		error = gpio_chip_open(path, &chips->chip[chips->count]);
		if (!error) {
			chips->count++;
		} else if (error == -EACCES || error == -EPERM) {
			memcpy(chips->denied, path, sizeof(chips->denied));
		}
	}
}

void gpio_chips_close(struct gpio_chips *chips)
{
	while (chips->count > 0) {
		gpio_chip_close(chips->chip[--chips->count]);
	}
}

void gpio_chips_report_missing(const struct gpio_chips *chips, const char *who,
	const char *works, const struct log *log)
{
	if (chips->denied[0]) {
		device_access_report_denied(log, chips->denied);
	} else if (chips->count == 0) {
		log_warning(log,
			"%s: no GPIO chip on this machine yet: %s when there is one",
			who, works);
	}
}

static bool chip_is_called(const struct gpio_chip *chip, const char *name)
{
	return strcmp(gpio_chip_label(chip), name) == 0 ||
		strcmp(gpio_chip_name(chip), name) == 0;
}

static void say_no_chip(const struct gpio_chips *chips,
	const struct gpio_held *held, const struct log *log)
{
	struct name_list labels = {""};

	for (int i = 0; i < chips->count; i++) {
		name_list_add(&labels, gpio_chip_label(chips->chip[i]));
	}
	log_warning(log, "%s: no chip is labelled %s: choose one of %s",
		held->who, held->spec.chip, labels.text);
}

static void say_no_line(const struct gpio_held *held, const struct log *log)
{
	const struct gpio_line_spec *spec = &held->spec;

	if (spec->name[0]) {
		log_warning(log,
			"%s: %s%s has no line named %s: gpioinfo lists the names",
			held->who, spec->chip[0] ? "chip " : "this machine",
			spec->chip, spec->name);
	} else {
		log_warning(log,
			"%s: chip %s has no line %u: choose a lower number",
			held->who, spec->chip, spec->offset);
	}
}

/* The line's offset on this chip, or -1. */
static int offset_on(struct gpio_chip *chip, const struct gpio_line_spec *spec)
{
	if (spec->name[0]) {
		return gpio_chip_find(chip, spec->name);
	}
	return spec->offset < gpio_chip_line_count(chip) ? (int)spec->offset
							 : -1;
}

/* Finds the chip and the offset of a line; NULL after logging a warning. */
static struct gpio_chip *find_line(const struct gpio_chips *chips,
	const struct gpio_held *held, const struct log *log,
	unsigned int *offset)
{
	const struct gpio_line_spec *spec = &held->spec;
	bool chip_found = !spec->chip[0];

	for (int i = 0; i < chips->count; i++) {
		struct gpio_chip *chip = chips->chip[i];
		int found;

		if (spec->chip[0] && !chip_is_called(chip, spec->chip)) {
			continue;
		}
		chip_found = true;
		found = offset_on(chip, spec);
		if (found >= 0) {
			*offset = (unsigned int)found;
			return chip;
		}
	}
	if (chip_found) {
		say_no_line(held, log);
	} else {
		say_no_chip(chips, held, log);
	}
	return NULL;
}

static void say_refused(const struct gpio_held *held, struct gpio_chip *chip,
	unsigned int offset, int error, const struct log *log)
{
	const struct gpio_settings *settings = &held->spec.settings;

	if (error == -EBUSY) {
		struct gpio_line_info line = {.used = false};

		(void)gpio_line_get_info(chip, offset, &line);
		log_warning(log,
			"%s: line %u of %s is taken by %s: free it or choose another line",
			held->who, offset, gpio_chip_label(chip),
			line.consumer[0] ? line.consumer : "a driver");
	} else {
		log_warning(log, "%s: line %u of %s cannot be %s: %s%s",
			held->who, offset, gpio_chip_label(chip),
			settings->output ? "driven" : "read", strerror(-error),
			settings->bias == GPIO_BIAS_AS_IS
				? ""
				: ": kernels before 5.5 need it without pull-up, pull-down and no-pull");
	}
}

/* Opens the line's own handle of a chip and requests it. 0 or -errno. */
static int request_line(
	struct gpio_held *held, struct gpio_chip *chip, unsigned int offset)
{
	char path[GPIO_NAME_BYTES];
	int error;

	snprintf(path, sizeof(path), "/dev/%s", gpio_chip_name(chip));
	error = gpio_chip_open(path, &held->chip);
	if (error) {
		held->chip = NULL;
		return error;
	}
	error = gpio_line_request(held->chip, offset, &held->spec.settings,
		held->consumer, &held->line);
	if (error) {
		gpio_chip_close(held->chip);
		held->chip = NULL;
		held->line = NULL;
	}
	return error;
}

struct gpio_held gpio_held_none(
	const struct gpio_line_spec *spec, const char *who, const char *name)
{
	struct gpio_held held = {.spec = *spec, .who = who};

	snprintf(held.consumer, sizeof(held.consumer), "limber %.20s", name);
	return held;
}

bool gpio_held_open(struct gpio_held *held, const struct gpio_chips *chips,
	const struct log *log)
{
	unsigned int offset;
	struct gpio_chip *chip = find_line(chips, held, log, &offset);
	int error;

	if (!chip) {
		return false;
	}
	error = request_line(held, chip, offset);
	if (error) {
		say_refused(held, chip, offset, error, log);
	}
	return !error;
}

bool gpio_held_retry(struct gpio_held *held, const struct gpio_chips *chips,
	const struct log *log)
{
	struct log nowhere = log_to_nowhere();
	bool open = gpio_held_open(held, chips, &nowhere);

	if (open) {
		log_note(log, "%s: its GPIO line is back", held->who);
	}
	return open;
}

void gpio_held_lose(struct gpio_held *held, int error, const struct log *log)
{
	log_warning(log,
		"%s: lost its GPIO line: %s: it works again when its chip is back",
		held->who, strerror(-error));
	gpio_held_close(held);
}

void gpio_held_close(struct gpio_held *held)
{
	gpio_line_release(held->line);
	gpio_chip_close(held->chip);
	held->line = NULL;
	held->chip = NULL;
}
