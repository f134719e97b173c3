/*
 * The words that say which GPIO line a button is.
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
	char chip[GPIO_NAME_BYTES]; /* label or device name; "": any chip */
	char name[GPIO_NAME_BYTES]; /* of the line; "": by offset */
	unsigned int offset;
	struct gpio_settings settings;
	int debounce_ms; /* 0: the usual */
};

/*
 * Reads "BUTTON=CHIP/OFFSET", "BUTTON=CHIP/NAME" or "BUTTON=NAME", any of
 * them followed by /active-low, /active-high, /pull-up, /pull-down, /no-pull
 * and /debounce=MS. Spaces part the words where there are any, so that names
 * may hold slashes. 0, or -EINVAL after a sentence.
 */
int gpio_line_spec_parse(
	const char *text, struct gpio_line_spec *out, const struct log *log);

#endif
