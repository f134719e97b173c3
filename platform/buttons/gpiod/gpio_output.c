#include "platform/buttons/gpio_output.h"

#include "platform/buttons/gpiod/gpio_held.h"

#include <stdlib.h>
#include <string.h>

struct gpio_output {
	struct log log;
	struct gpio_held held;
	bool on;    /* whether the line is to be on, also while it is missing */
	char who[]; /* of held */
};

int gpio_output_check(const char *line, const struct log *log)
{
	struct gpio_line_spec spec;

	return gpio_line_spec_parse_output(line, &spec, log);
}

static void drive(struct gpio_output *output)
{
	int error = gpio_line_drive(output->held.line, output->on);

	if (error) {
		gpio_held_lose(&output->held, error, &output->log);
	}
}

static void open_first(struct gpio_output *output)
{
	struct gpio_chips chips;

	gpio_chips_open(&chips);
	if (chips.count > 0) {
		(void)gpio_held_open(&output->held, &chips, &output->log);
	} else {
		gpio_chips_report_missing(
			&chips, output->who, "it works", &output->log);
	}
	gpio_chips_close(&chips);
}

struct gpio_output *gpio_output_open(const char *where, const char *name,
	const char *line, const struct log *log)
{
	size_t bytes = strlen(where) + 1;
	struct gpio_output *output;
	struct gpio_line_spec spec;

	if (gpio_line_spec_parse_output(line, &spec, log) != 0) {
		return NULL;
	}
	output = calloc(1, sizeof(*output) + bytes);
	if (!output) {
		log_warning(log, "%s: there is not enough memory", where);
		return NULL;
	}
	memcpy(output->who, where, bytes);
	output->log = *log;
	output->held = gpio_held_none(&spec, output->who, name);
	open_first(output);
	return output;
}

void gpio_output_set(struct gpio_output *output, bool on)
{
	if (!output) {
		return;
	}
	output->on = on;
	if (output->held.line) {
		drive(output);
	}
}

/* Reads the line: the kernel does not tell that a chip is gone. */
static bool is_missing(struct gpio_output *output)
{
	int level;

	if (!output) {
		return false;
	}
	if (!output->held.line) {
		return true;
	}
	level = gpio_line_level(output->held.line);
	if (level < 0) {
		gpio_held_lose(&output->held, level, &output->log);
	}
	return level < 0;
}

void gpio_output_check_all(struct gpio_output *const *outputs, int count)
{
	struct gpio_chips chips;
	bool any = false;

	for (int i = 0; i < count; i++) {
		any = is_missing(outputs[i]) || any;
	}
	if (!any) {
		return;
	}
	gpio_chips_open(&chips);
	for (int i = 0; i < count; i++) {
		struct gpio_output *output = outputs[i];

		if (output && !output->held.line &&
			gpio_held_retry(&output->held, &chips, &output->log)) {
			drive(output);
		}
	}
	gpio_chips_close(&chips);
}

void gpio_output_close(struct gpio_output *output)
{
	if (output) {
		gpio_output_set(output, false);
		gpio_held_close(&output->held);
		free(output);
	}
}
