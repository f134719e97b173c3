/*
 * GPIO chips and lines, the same for every libgpiod: v1/ is built where the
 * library is 1.x, v2/ where it is 2.x (toolchain/sources.mk).
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
	bool active_low;
	enum gpio_bias bias;
};

struct gpio_edge {
	int64_t stamp_ns; /* of the kernel, see event_time.h */
	bool active;      /* what the line became */
};

/* Opens a device such as /dev/gpiochip0. 0 or -errno. */
int gpio_chip_open(const char *path, struct gpio_chip **out);

/* The lines of the chip must be released first. NULL is fine. */
void gpio_chip_close(struct gpio_chip *chip);

/* Both stay valid while the chip is open. */
const char *gpio_chip_label(const struct gpio_chip *chip);
const char *gpio_chip_name(const struct gpio_chip *chip);

unsigned int gpio_chip_line_count(const struct gpio_chip *chip);

/* The offset of the line of that name, or -1. */
int gpio_chip_find(struct gpio_chip *chip, const char *name);

/* Who has the line, "" when nobody or when it cannot be told. */
void gpio_line_holder(
	struct gpio_chip *chip, unsigned int offset, char *text, size_t size);

/* What anybody may know of a line. */
struct gpio_line_info {
	char name[64];   /* "" when it has none */
	char holder[64]; /* "" when that cannot be told */
	bool taken;
};

/* Looks at a line without taking it. 0 or -errno. */
int gpio_line_get_info(struct gpio_chip *chip, unsigned int offset,
	struct gpio_line_info *out);

/*
 * Takes a line as an input that reports both edges. consumer is what other
 * programs see as its holder. 0 or -errno: -EBUSY when it is taken.
 */
int gpio_line_request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpio_line **out);

/* NULL is fine. */
void gpio_line_release(struct gpio_line *line);

/* Readable when edges wait, for poll(). */
int gpio_line_fd(const struct gpio_line *line);

/* 1 when active, 0 when not, or -errno. */
int gpio_line_level(struct gpio_line *line);

enum {
	GPIO_EDGES_MAX = 16 /* as many as the kernel keeps of a line */
};

/*
 * The edges that wait, oldest first; their number or -errno. Blocks when there
 * are none: poll first.
 */
int gpio_line_read(
	struct gpio_line *line, struct gpio_edge edges[GPIO_EDGES_MAX]);

#endif
