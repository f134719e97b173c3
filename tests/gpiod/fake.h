/*
 * GPIO chips that are not there: a libgpiod of either generation that is
 * linked in place of the library (fake_v1.c, fake_v2.c), and the hands that
 * press its buttons.
 *
 * It does what the kernel does where the driver leans on it: a line belongs to
 * one holder, edges and levels are logical, and of the edges nobody read only
 * so many are kept.
 */
#ifndef TESTS_GPIOD_FAKE_H
#define TESTS_GPIOD_FAKE_H

#include <stdbool.h>
#include <stdint.h>

enum {
	FAKE_CHIPS = 3,
	FAKE_LINES = 32,
	FAKE_EDGES = 16
};

enum fake_bias {
	FAKE_AS_IS,
	FAKE_NO_PULL,
	FAKE_PULL_UP,
	FAKE_PULL_DOWN,
};

struct fake_edge {
	int64_t stamp_ns;
	bool rising;
};

struct fake_line {
	const char *name;
	const char *holder; /* who has it; NULL: free */
	char consumer[64];  /* what the driver called itself */
	bool requested, both_edges, input, active_low, high;
	enum fake_bias bias;
	int pipe[2]; /* a byte an edge */
	struct fake_edge edge[FAKE_EDGES];
	int edges;
	bool gone; /* its chip was pulled out */
};

struct fake_chip {
	const char *name, *label;
	unsigned int lines;
	int error; /* of opening it */
	int opened;
	struct fake_line line[FAKE_LINES];
};

struct fake_gpio {
	struct fake_chip chip[FAKE_CHIPS]; /* a NULL name: none there */
};

/*
 * The three chips of an i.MX31, numbered as Linux does: gpiochip0 to 2 with
 * the labels 53fa4000.gpio, 53fcc000.gpio and 53fd0000.gpio. The library
 * looks at *gpio from now on.
 */
void fake_gpio_begin(struct fake_gpio *gpio);

/* Fails the test when the driver left something open. */
void fake_gpio_end(struct fake_gpio *gpio);

/* The line's wire goes high or low, age_us ago. */
void fake_gpio_set(struct fake_line *line, bool high, int age_us);

/* The same with a stamp of the real-time clock. */
void fake_gpio_set_real_time(struct fake_line *line, bool high, int age_us);

/* Pulls the line's chip out: its file is at its end. */
void fake_gpio_lose(struct fake_line *line);

/* For the two libraries. -1 and errno, or what they are asked for. */
struct fake_chip *fake_chip_open(const char *path);
unsigned int fake_line_offset(const struct fake_line *line);
void fake_chip_close(struct fake_chip *chip);
struct fake_line *fake_chip_line(struct fake_chip *chip, unsigned int offset);
int fake_chip_find(const struct fake_chip *chip, const char *name);
int fake_line_request(struct fake_line *line, const char *consumer);
void fake_line_release(struct fake_line *line);
int fake_line_value(const struct fake_line *line);
int fake_line_read(struct fake_line *line, struct fake_edge *edges, int room);

#endif
