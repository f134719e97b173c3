/*
 * Simulated GPIO chips, behind a replacement of libgpiod that is linked instead
 * of the library (fake_v1.c, fake_v2.c), and functions that press buttons.
 *
 * It behaves like the kernel where the driver depends on it: a line has one
 * user, edges and levels are logical, and only FAKE_EDGES edges are buffered.
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
	const char *holder; /* another user of the line, or NULL */
	void *owner;        /* the handle of its chip that got it; 1.x only */
	int error;          /* errno of requesting it, or 0 */
	char consumer[64];  /* the driver's name for itself */
	bool requested, both_edges, input, active_low, high;
	enum fake_bias bias;
	int pipe[2]; /* one byte for each edge */
	struct fake_edge edge[FAKE_EDGES];
	int edges;
	bool gone;      /* its chip was unplugged */
	int read_error; /* errno of the next reading, or 0 */
	int changes;    /* of an output's level */
};

struct fake_chip {
	const char *name, *label;
	unsigned int lines;
	int error; /* errno of opening it, or 0 */
	int opened;
	struct fake_line line[FAKE_LINES];
};

struct fake_gpio {
	struct fake_chip chip[FAKE_CHIPS]; /* name NULL for a missing chip */
};

/*
 * Sets up the three chips of an i.MX31 as Linux does: gpiochip0 to 2 with the
 * labels 53fa4000.gpio, 53fcc000.gpio and 53fd0000.gpio. The replacement of the
 * library uses *gpio from now on.
 */
void fake_gpio_begin(struct fake_gpio *gpio);

/* Fails the test if the driver left something open. */
void fake_gpio_end(struct fake_gpio *gpio);

/* Sets the level of a line, with a time stamp age_us in the past. */
void fake_gpio_set(struct fake_line *line, bool high, int age_us);

/* The same with a time stamp of the real-time clock. */
void fake_gpio_set_real_time(struct fake_line *line, bool high, int age_us);

/* Unplugs the line's chip: reading the line gives end of file. */
void fake_gpio_lose(struct fake_line *line);

/* For the two replacements. Failures return NULL or -1, and set errno. */
struct fake_chip *fake_chip_open(const char *path);
unsigned int fake_line_offset(const struct fake_line *line);
void fake_chip_close(struct fake_chip *chip);
struct fake_line *fake_chip_line(struct fake_chip *chip, unsigned int offset);
int fake_chip_find(const struct fake_chip *chip, const char *name);
int fake_line_request(struct fake_line *line, const char *consumer);
void fake_line_release(struct fake_line *line);
int fake_line_value(const struct fake_line *line);
int fake_line_drive(struct fake_line *line, bool active);
int fake_line_read(
	struct fake_line *line, struct fake_edge *edges, int capacity);

#endif
