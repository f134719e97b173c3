/*
 * GPIO lines that the program drives: an LED, a buzzer, a relay.
 */
#ifndef PLATFORM_BUTTONS_GPIO_OUTPUT_H
#define PLATFORM_BUTTONS_GPIO_OUTPUT_H

#include "platform/base/log.h"

#include <stdbool.h>

struct gpio_output;

/*
 * Checks the text that names a line: CHIP/OFFSET, CHIP/NAME or NAME, with
 * /active-low behind it for a line that is on when it is low. Opens nothing.
 * Returns 0, or -EINVAL after logging an error.
 */
int gpio_output_check(const char *line, const struct log *log);

/*
 * Opens the line as an output that is off. Other programs see "limber NAME" as
 * its user. If this machine has no such line, or the line is in use, a warning
 * is logged, and gpio_output_check_all() opens it later. Warnings begin with
 * where, such as "FILE:LINE: [output NAME] line". Returns NULL after logging an
 * error or warning if the text is wrong or memory is short. The functions below
 * do nothing for NULL.
 */
struct gpio_output *gpio_output_open(const char *where, const char *name,
	const char *line, const struct log *log);

/* Switches the line on or off: now, or when it is there. */
void gpio_output_set(struct gpio_output *output, bool on);

/*
 * Looks which of the lines are lost, for instance because their chip was
 * unplugged, and opens those that are back, as they were set. Call it once a
 * second; members may be NULL.
 */
void gpio_output_check_all(struct gpio_output *const *outputs, int count);

/* Switches the line off and gives it back. NULL is fine. */
void gpio_output_close(struct gpio_output *output);

#endif
