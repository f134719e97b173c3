#include "platform/buttons/gpio_output.h"

#include "platform/buttons/gpiod/gpio_line_spec.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	DEVICES_MAX = 128 /* /dev/gpiochip0 to 127; numbers may have gaps */
};

struct gpio_output {
	struct gpio_chip *chip;
	struct gpio_line *line;
};

int gpio_output_check(const char *line, const struct log *log)
{
	struct gpio_line_spec spec;

	return gpio_line_spec_parse_output(line, &spec, log);
}

/* The line's offset on this chip, or -1. */
static int offset_on(struct gpio_chip *chip, const struct gpio_line_spec *spec)
{
	if (spec->chip[0] && strcmp(gpio_chip_label(chip), spec->chip) != 0 &&
		strcmp(gpio_chip_name(chip), spec->chip) != 0) {
		return -1;
	}
	if (spec->name[0]) {
		return gpio_chip_find(chip, spec->name);
	}
	return spec->offset < gpio_chip_line_count(chip) ? (int)spec->offset
							 : -1;
}

/* Opens the chip that has the line; NULL if there is none. */
static struct gpio_chip *open_chip(
	const struct gpio_line_spec *spec, int *offset)
{
	for (int i = 0; i < DEVICES_MAX; i++) {
		struct gpio_chip *chip;
		char path[32];

		snprintf(path, sizeof(path), "/dev/gpiochip%d", i);
		if (gpio_chip_open(path, &chip) != 0) {
			continue;
		}
		*offset = offset_on(chip, spec);
		if (*offset >= 0) {
			return chip;
		}
		gpio_chip_close(chip);
	}
	return NULL;
}

struct gpio_output *gpio_output_open(const char *where, const char *name,
	const char *line, const struct log *log)
{
	struct gpio_output *output;
	struct gpio_line_spec spec;
	char consumer[32];
	int offset, error;

	if (gpio_line_spec_parse_output(line, &spec, log) != 0) {
		return NULL;
	}
	output = calloc(1, sizeof(*output));
	if (!output) {
		log_warning(log, "%s: there is not enough memory", where);
		return NULL;
	}
	output->chip = open_chip(&spec, &offset);
	if (!output->chip) {
		log_warning(log,
			"%s: no GPIO chip that can be opened has the line %s: limber doctor lists the chips",
			where, line);
		free(output);
		return NULL;
	}
	snprintf(consumer, sizeof(consumer), "limber %.20s", name);
	error = gpio_line_request(output->chip, (unsigned int)offset,
		&spec.settings, consumer, &output->line);
	if (error) {
		log_warning(log, "%s: the line %s cannot be driven: %s", where,
			line, strerror(-error));
		gpio_chip_close(output->chip);
		free(output);
		return NULL;
	}
	return output;
}

void gpio_output_set(struct gpio_output *output, bool on)
{
	if (output) {
		gpio_line_drive(output->line, on);
	}
}

void gpio_output_close(struct gpio_output *output)
{
	if (output) {
		gpio_output_set(output, false);
		gpio_line_release(output->line);
		gpio_chip_close(output->chip);
		free(output);
	}
}
