#include "platform/buttons/gpiod/gpiod_survey.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

#include "platform/buttons/gpiod/gpio.h"

enum {
	DEVICES_MAX = 128,
	LINES_MAX = UINT16_MAX /* Linux keeps the number of lines in 16 bits */
};

static void report_line(const struct gpio_chip *chip, unsigned int offset,
	const struct gpio_line_info *line, const struct survey *survey)
{
	char subject[96];
	const char *name = line->name[0] ? line->name : "line without a name";

	snprintf(subject, sizeof(subject), "%s/%u", gpio_chip_label(chip),
		offset);
	if (line->used) {
		survey_report(survey, SURVEY_TAKEN, subject, NULL,
			"%s: used by %s", name,
			line->consumer[0] ? line->consumer : "a driver");
	} else {
		survey_report(
			survey, SURVEY_WORKS, subject, NULL, "%s: free", name);
	}
}

static void report_chip(struct gpio_chip *chip, const struct survey *survey)
{
	unsigned int lines = gpio_chip_line_count(chip), used = 0;
	unsigned int count = lines < LINES_MAX ? lines : LINES_MAX;
	struct gpio_line_info line;
	char path[64];

	for (unsigned int i = 0; i < count; i++) {
		used += gpio_line_get_info(chip, i, &line) == 0 && line.used;
	}
	snprintf(path, sizeof(path), "/dev/%s", gpio_chip_name(chip));
	survey_report(survey, SURVEY_WORKS, path, NULL,
		"label %s, %u line%s, %u of them used", gpio_chip_label(chip),
		count, count == 1 ? "" : "s", used);
	for (unsigned int i = 0; i < count; i++) {
		if (gpio_line_get_info(chip, i, &line) == 0 &&
			(line.used || line.name[0])) {
			report_line(chip, i, &line, survey);
		}
	}
}

/* Reports the chip of that number; false when there is none. */
static bool report_number(int number, const struct survey *survey)
{
	struct gpio_chip *chip;
	char path[32], entry[64];
	int error;

	snprintf(path, sizeof(path), "/dev/gpiochip%d", number);
	error = gpio_chip_open(path, &chip);
	if (!error) {
		report_chip(chip, survey);
		gpio_chip_close(chip);
	} else if (error == -EACCES || error == -EPERM) {
		survey_report_denied(survey, path);
	} else if (error == -ENOENT) {
		snprintf(entry, sizeof(entry), "bus/gpio/devices/gpiochip%d",
			number);
		return survey_report_no_node(survey, path, entry, error);
	} else {
		survey_report(survey, SURVEY_BROKEN, path,
			"enable CONFIG_GPIO_CDEV in the kernel",
			"it does not answer as a GPIO chip: %s",
			strerror(-error));
	}
	return true;
}

void gpiod_survey(const struct survey *survey)
{
	bool any = false;

	for (int i = 0; i < DEVICES_MAX; i++) {
		any = report_number(i, survey) || any;
	}
	if (!any) {
		survey_report(survey, SURVEY_MISSING, "/dev/gpiochip*",
			"on a board, enable its GPIO driver and CONFIG_GPIO_CDEV; elsewhere use --buttons evdev",
			"there is no GPIO chip");
	}
}
