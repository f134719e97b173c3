/*
 * gpio.h for libgpiod 2.x, where a line request outlives its chip.
 */
#include "platform/buttons/gpiod/gpio.h"

#include <errno.h>
#include <gpiod.h>
#include <stdio.h>
#include <stdlib.h>

struct gpio_chip {
	struct gpiod_chip *chip;
	struct gpiod_chip_info *info;
};

struct gpio_line {
	struct gpiod_line_request *request;
	struct gpiod_edge_event_buffer *events;
	unsigned int offset;
};

static int last_error(void)
{
	return errno ? -errno : -EIO;
}

int gpio_chip_open(const char *path, struct gpio_chip **out)
{
	struct gpio_chip *chip = calloc(1, sizeof(*chip));
	int error;

	if (!chip) {
		return -ENOMEM;
	}
	chip->chip = gpiod_chip_open(path);
	if (!chip->chip) {
		error = last_error();
		goto out_free;
	}
	chip->info = gpiod_chip_get_info(chip->chip);
	if (!chip->info) {
		error = last_error();
		goto out_chip;
	}
	*out = chip;
	return 0;
out_chip:
	gpiod_chip_close(chip->chip);
out_free:
	free(chip);
	return error;
}

void gpio_chip_close(struct gpio_chip *chip)
{
	if (chip) {
		gpiod_chip_info_free(chip->info);
		gpiod_chip_close(chip->chip);
		free(chip);
	}
}

const char *gpio_chip_label(const struct gpio_chip *chip)
{
	return gpiod_chip_info_get_label(chip->info);
}

const char *gpio_chip_name(const struct gpio_chip *chip)
{
	return gpiod_chip_info_get_name(chip->info);
}

unsigned int gpio_chip_line_count(const struct gpio_chip *chip)
{
	return (unsigned int)gpiod_chip_info_get_num_lines(chip->info);
}

int gpio_chip_find(struct gpio_chip *chip, const char *name)
{
	return gpiod_chip_get_line_offset_from_name(chip->chip, name);
}

int gpio_line_get_info(
	struct gpio_chip *chip, unsigned int offset, struct gpio_line_info *out)
{
	struct gpiod_line_info *info =
		gpiod_chip_get_line_info(chip->chip, offset);
	const char *name, *consumer;

	if (!info) {
		return last_error();
	}
	name = gpiod_line_info_get_name(info);
	consumer = gpiod_line_info_get_consumer(info);
	out->used = gpiod_line_info_is_used(info);
	snprintf(out->name, sizeof(out->name), "%s", name ? name : "");
	snprintf(out->consumer, sizeof(out->consumer), "%s",
		out->used && consumer ? consumer : "");
	gpiod_line_info_free(info);
	return 0;
}

/* Returns NULL with errno set when it fails. */
static struct gpiod_line_settings *make_settings(
	const struct gpio_settings *settings)
{
	static const enum gpiod_line_bias bias[] = {
		[GPIO_BIAS_AS_IS] = GPIOD_LINE_BIAS_AS_IS,
		[GPIO_BIAS_NONE] = GPIOD_LINE_BIAS_DISABLED,
		[GPIO_BIAS_PULL_UP] = GPIOD_LINE_BIAS_PULL_UP,
		[GPIO_BIAS_PULL_DOWN] = GPIOD_LINE_BIAS_PULL_DOWN,
	};
	struct gpiod_line_settings *made = gpiod_line_settings_new();

	if (made &&
		(gpiod_line_settings_set_direction(made,
			 settings->output ? GPIOD_LINE_DIRECTION_OUTPUT
					  : GPIOD_LINE_DIRECTION_INPUT) < 0 ||
			gpiod_line_settings_set_edge_detection(made,
				settings->output ? GPIOD_LINE_EDGE_NONE
						 : GPIOD_LINE_EDGE_BOTH) < 0 ||
			gpiod_line_settings_set_bias(
				made, bias[settings->bias]) < 0)) {
		gpiod_line_settings_free(made);
		return NULL;
	}
	if (made) {
		gpiod_line_settings_set_active_low(made, settings->active_low);
	}
	return made;
}

static int request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpiod_line_request **out)
{
	struct gpiod_line_settings *line = make_settings(settings);
	struct gpiod_line_config *lines = gpiod_line_config_new();
	struct gpiod_request_config *config = gpiod_request_config_new();
	int error = 0;

	if (!line || !lines || !config) {
		error = -ENOMEM;
	} else if (gpiod_line_config_add_line_settings(
			   lines, &offset, 1, line) < 0) {
		error = last_error();
	} else {
		gpiod_request_config_set_consumer(config, consumer);
		*out = gpiod_chip_request_lines(chip->chip, config, lines);
		error = *out ? 0 : last_error();
	}
	gpiod_request_config_free(config);
	gpiod_line_config_free(lines);
	gpiod_line_settings_free(line);
	return error;
}

int gpio_line_request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpio_line **out)
{
	struct gpio_line *line = calloc(1, sizeof(*line));
	int error;

	if (!line) {
		return -ENOMEM;
	}
	line->offset = offset;
	line->events = gpiod_edge_event_buffer_new(GPIO_EDGES_MAX);
	if (!line->events) {
		error = last_error();
		goto out_free;
	}
	error = request(chip, offset, settings, consumer, &line->request);
	if (error) {
		goto out_events;
	}
	*out = line;
	return 0;
out_events:
	gpiod_edge_event_buffer_free(line->events);
out_free:
	free(line);
	return error;
}

int gpio_line_drive(struct gpio_line *line, bool active)
{
	return gpiod_line_request_set_value(line->request, line->offset,
		       active ? GPIOD_LINE_VALUE_ACTIVE
			      : GPIOD_LINE_VALUE_INACTIVE) < 0
		? last_error()
		: 0;
}

void gpio_line_release(struct gpio_line *line)
{
	if (line) {
		gpiod_line_request_release(line->request);
		gpiod_edge_event_buffer_free(line->events);
		free(line);
	}
}

int gpio_line_fd(const struct gpio_line *line)
{
	return gpiod_line_request_get_fd(line->request);
}

int gpio_line_level(struct gpio_line *line)
{
	enum gpiod_line_value value =
		gpiod_line_request_get_value(line->request, line->offset);

	return value == GPIOD_LINE_VALUE_ERROR
		? last_error()
		: value == GPIOD_LINE_VALUE_ACTIVE;
}

int gpio_line_read(
	struct gpio_line *line, struct gpio_edge edges[GPIO_EDGES_MAX])
{
	int count = gpiod_line_request_read_edge_events(
		line->request, line->events, GPIO_EDGES_MAX);

	if (count < 0) {
		return last_error();
	}
	for (int i = 0; i < count; i++) {
		struct gpiod_edge_event *event =
			gpiod_edge_event_buffer_get_event(
				line->events, (unsigned long)i);

		edges[i] = (struct gpio_edge){
			.stamp_ns = (int64_t)gpiod_edge_event_get_timestamp_ns(
				event),
			.active = gpiod_edge_event_get_event_type(event) ==
				GPIOD_EDGE_EVENT_RISING_EDGE,
		};
	}
	return count;
}
