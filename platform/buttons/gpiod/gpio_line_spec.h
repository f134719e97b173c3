/*
 * The text that assigns a button to a GPIO line.
 */
#ifndef PLATFORM_BUTTONS_GPIOD_GPIO_LINE_SPEC_H
#define PLATFORM_BUTTONS_GPIOD_GPIO_LINE_SPEC_H

#include "platform/buttons/buttons.h"
#include "platform/buttons/gpiod/gpio.h"

enum {
	GPIO_NAME_BYTES = 64,
	GPIO_DEBOUNCE_MAX_MS = 1000
};

struct gpio_line_spec {
	enum button button;
	char chip[GPIO_NAME_BYTES]; /* label or device name; "" for any chip */
	char name[GPIO_NAME_BYTES]; /* the line's name; "" to use the offset */
	unsigned int offset;
	struct gpio_settings settings;
	int debounce_ms; /* 0 for BUTTON_DEBOUNCE_MS */
};

/*
 * Reads "BUTTON=CHIP/OFFSET", "BUTTON=CHIP/NAME" or "BUTTON=NAME", each
 * followed by any of /active-low, /active-high, /pull-up, /pull-down, /no-pull
 * and /debounce=MS. A text with spaces is separated by them instead of slashes,
 * so that names may contain slashes. Returns 0, or -EINVAL after logging an
 * error.
 */
int gpio_line_spec_parse(
	const char *text, struct gpio_line_spec *out, const struct log *log);

/*
 * Reads the same without "BUTTON=", for an output; .button is BUTTON_COUNT.
 */
int gpio_line_spec_parse_output(
	const char *text, struct gpio_line_spec *out, const struct log *log);

#endif
