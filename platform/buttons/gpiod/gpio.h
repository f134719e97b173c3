/*
 * GPIO chips and lines, with one interface for both versions of libgpiod:
 * toolchain/sources.mk builds v1/ for libgpiod 1.x and v2/ for 2.x.
 *
 * Levels and edges are logical: an active-low line is active when it is low.
 */
#ifndef PLATFORM_BUTTONS_GPIOD_GPIO_H
#define PLATFORM_BUTTONS_GPIOD_GPIO_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct gpio_chip;
struct gpio_line;

enum gpio_bias {
	GPIO_BIAS_AS_IS,
	GPIO_BIAS_NONE,
	GPIO_BIAS_PULL_UP,
	GPIO_BIAS_PULL_DOWN,
};

struct gpio_settings {
	bool output; /* the line is driven, inactive at first; else an input */
	bool active_low;
	enum gpio_bias bias;
};

struct gpio_edge {
	int64_t stamp_ns; /* the kernel's time stamp, see event_time.h */
	bool active;      /* the level after the edge */
};

/* Opens a device such as /dev/gpiochip0. Returns 0 or -errno. */
int gpio_chip_open(const char *path, struct gpio_chip **out);

/* Closes a chip, whose lines must have been released. NULL is fine. */
void gpio_chip_close(struct gpio_chip *chip);

/* The strings stay valid while the chip is open. */
const char *gpio_chip_label(const struct gpio_chip *chip);
const char *gpio_chip_name(const struct gpio_chip *chip);

unsigned int gpio_chip_line_count(const struct gpio_chip *chip);

/* The offset of the line of that name, or -1. */
int gpio_chip_find(struct gpio_chip *chip, const char *name);

/* The state of a line, which can be read without requesting it. */
struct gpio_line_info {
	char name[64];     /* "" when it has none */
	char consumer[64]; /* who uses it; "" when nobody does or it is unknown */
	bool used;
};

/* Reads the state of a line. Returns 0 or -errno. */
int gpio_line_get_info(struct gpio_chip *chip, unsigned int offset,
	struct gpio_line_info *out);

/*
 * Requests a line: an input reports both edges. Other programs see consumer as
 * the name of its user. Returns 0 or -errno; -EBUSY when the line is in use.
 */
int gpio_line_request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpio_line **out);

/* Makes an output line active or inactive. Returns 0 or -errno. */
int gpio_line_drive(struct gpio_line *line, bool active);

/* NULL is fine. */
void gpio_line_release(struct gpio_line *line);

/* A descriptor for poll(), readable when edges are waiting. */
int gpio_line_fd(const struct gpio_line *line);

/* Returns 1 when the line is active, 0 when it is not, or -errno. */
int gpio_line_level(struct gpio_line *line);

enum {
	GPIO_EDGES_MAX = 16 /* as many as the kernel buffers for a line */
};

/*
 * Reads the waiting edges, the oldest first. Returns their number or -errno.
 * Blocks when there are none, so poll gpio_line_fd() first.
 */
int gpio_line_read(
	struct gpio_line *line, struct gpio_edge edges[GPIO_EDGES_MAX]);

#endif
