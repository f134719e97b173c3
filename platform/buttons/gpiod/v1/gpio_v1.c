/*
 * gpio.h for libgpiod 1.x, where lines are owned by their chip.
 */
#include "platform/buttons/gpiod/gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

#include "platform/base/compiler.h"

/* struct gpio_chip and gpio_line stand for the library's own structs. */
static struct gpiod_chip *to_chip(const struct gpio_chip *chip)
{
	return (struct gpiod_chip *)chip;
}

static struct gpiod_line *to_line(const struct gpio_line *line)
{
	return (struct gpiod_line *)line;
}

/*
 * Joins the seconds and nanoseconds into which the library splits the kernel's
 * unsigned 64-bit stamp. A large stamp wraps, which event_time.h accepts.
 */
static int64_t stamp_of(const struct timespec *time)
{
	return (int64_t)((uint64_t)time->tv_sec * 1000000000 +
		(uint64_t)time->tv_nsec);
}

static int last_error(void)
{
	return errno ? -errno : -EIO;
}

int gpio_chip_open(const char *path, struct gpio_chip **out)
{
	struct gpiod_chip *chip = gpiod_chip_open(path);

	if (!chip) {
		return last_error();
	}
	*out = (struct gpio_chip *)chip;
	return 0;
}

void gpio_chip_close(struct gpio_chip *chip)
{
	if (chip) {
		gpiod_chip_close(to_chip(chip));
	}
}

const char *gpio_chip_label(const struct gpio_chip *chip)
{
	return gpiod_chip_label(to_chip(chip));
}

const char *gpio_chip_name(const struct gpio_chip *chip)
{
	return gpiod_chip_name(to_chip(chip));
}

unsigned int gpio_chip_line_count(const struct gpio_chip *chip)
{
	return gpiod_chip_num_lines(to_chip(chip));
}

int gpio_chip_find(struct gpio_chip *chip, const char *name)
{
	struct gpiod_line *line = gpiod_chip_find_line(to_chip(chip), name);

	return line ? (int)gpiod_line_offset(line) : -1;
}

int gpio_line_get_info(
	struct gpio_chip *chip, unsigned int offset, struct gpio_line_info *out)
{
	struct gpiod_line *line = gpiod_chip_get_line(to_chip(chip), offset);
	const char *name, *consumer;

	if (!line || gpiod_line_update(line) < 0) {
		return last_error();
	}
	name = gpiod_line_name(line);
	consumer = gpiod_line_consumer(line);
	out->used = gpiod_line_is_used(line);
	snprintf(out->name, sizeof(out->name), "%s", name ? name : "");
	snprintf(out->consumer, sizeof(out->consumer), "%s",
		out->used && consumer ? consumer : "");
	return 0;
}

static int request_flags(const struct gpio_settings *settings)
{
	static const int bias[] = {
		[GPIO_BIAS_AS_IS] = 0,
		[GPIO_BIAS_NONE] = GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE,
		[GPIO_BIAS_PULL_UP] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP,
		[GPIO_BIAS_PULL_DOWN] = GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN,
	};

	return bias[settings->bias] |
		(settings->active_low ? GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW : 0);
}

int gpio_line_request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpio_line **out)
{
	const struct gpiod_line_request_config config = {
		.consumer = consumer,
		.request_type = settings->output
			? GPIOD_LINE_REQUEST_DIRECTION_OUTPUT
			: GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES,
		.flags = request_flags(settings),
	};
	struct gpiod_line *line = gpiod_chip_get_line(to_chip(chip), offset);

	if (!line || gpiod_line_request(line, &config, 0) < 0) {
		return last_error();
	}
	*out = (struct gpio_line *)line;
	return 0;
}

int gpio_line_drive(struct gpio_line *line, bool active)
{
	return gpiod_line_set_value(to_line(line), active) < 0 ? last_error()
							       : 0;
}

void gpio_line_release(struct gpio_line *line)
{
	if (line) {
		gpiod_line_release(to_line(line));
	}
}

int gpio_line_fd(const struct gpio_line *line)
{
	return gpiod_line_event_get_fd(to_line(line));
}

int gpio_line_level(struct gpio_line *line)
{
	int value = gpiod_line_get_value(to_line(line));

	return value < 0 ? last_error() : value;
}

int gpio_line_read(
	struct gpio_line *line, struct gpio_edge edges[GPIO_EDGES_MAX])
{
	struct gpiod_line_event events[GPIO_EDGES_MAX];
	int count = gpiod_line_event_read_multiple(
		to_line(line), events, ARRAY_COUNT(events));

	if (count < 0) {
		return last_error();
	}
	for (int i = 0; i < count; i++) {
		edges[i] = (struct gpio_edge){
			.stamp_ns = stamp_of(&events[i].ts),
			.active = events[i].event_type ==
				GPIOD_LINE_EVENT_RISING_EDGE,
		};
	}
	return count;
}
