/*
 * Lines that the program holds for as long as it runs, while their chips, such
 * as a USB adapter's, come and go.
 *
 * A line that is missing is looked for again by its spec. Buttons and outputs
 * differ only in what they do with an open line.
 */
#ifndef PLATFORM_BUTTONS_GPIOD_GPIO_HELD_H
#define PLATFORM_BUTTONS_GPIOD_GPIO_HELD_H

#include "platform/buttons/gpiod/gpio_line_spec.h"

enum {
	GPIO_CHIPS_MAX = 32,
	GPIO_RETRY_MS = 1000 /* between two looks at lines that may be lost */
};

/* All chips of the machine that can be opened, while lines are looked for. */
struct gpio_chips {
	struct gpio_chip *chip[GPIO_CHIPS_MAX];
	int count;
	char denied[32]; /* the last one that may not be opened, or "" */
};

void gpio_chips_open(struct gpio_chips *chips);
void gpio_chips_close(struct gpio_chips *chips);

/*
 * Warns if this machine has no chips yet, or one that the user may not open.
 * who begins the warning, and works says what a chip would bring back.
 */
void gpio_chips_report_missing(const struct gpio_chips *chips, const char *who,
	const char *works, const struct log *log);

struct gpio_held {
	struct gpio_line_spec spec;
	const char *who;   /* begins its messages, such as "gpiod:UP" */
	char consumer[32]; /* what other programs see as its user */
	/*
	 * A line has its own handle of its chip, which it closes when it is
	 * lost: the chip gets its former number again only if nobody holds it.
	 */
	struct gpio_chip *chip;
	struct gpio_line *line; /* NULL: missing */
};

/* A missing line of a spec, used as "limber NAME". who must outlive it. */
struct gpio_held gpio_held_none(
	const struct gpio_line_spec *spec, const char *who, const char *name);

/* Opens a missing line. Returns whether it is open; if not, log gets why. */
bool gpio_held_open(struct gpio_held *held, const struct gpio_chips *chips,
	const struct log *log);

/*
 * The same for a line whose absence has been logged: logs only, as a note, that
 * it is back.
 */
bool gpio_held_retry(struct gpio_held *held, const struct gpio_chips *chips,
	const struct log *log);

/* Closes a line after an error, -errno, of using it, and logs a warning. */
void gpio_held_lose(struct gpio_held *held, int error, const struct log *log);

/* Closes the line. One that is missing is fine. */
void gpio_held_close(struct gpio_held *held);

#endif
