/* The functions of libgpiod 1.x that the driver calls. */
#include "tests/gpiod/fake.h"

#include "tests/support/test.h"

#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

/* Each opening of a chip is a handle of its own, which owns its lines. */
struct handle {
	struct fake_chip *chip;
};

static struct fake_chip *fake(struct gpiod_chip *chip)
{
	return ((struct handle *)chip)->chip;
}

static struct fake_line *fake_line(struct gpiod_line *line)
{
	return (struct fake_line *)line;
}

struct gpiod_chip *gpiod_chip_open(const char *path)
{
	struct fake_chip *chip = fake_chip_open(path);
	struct handle *handle = chip ? malloc(sizeof(*handle)) : NULL;

	if (handle) {
		handle->chip = chip;
	}
	return (struct gpiod_chip *)handle;
}

void gpiod_chip_close(struct gpiod_chip *chip)
{
	for (int i = 0; i < FAKE_LINES; i++) {
		const struct fake_line *line = &fake(chip)->line[i];

		assert_false(line->requested && line->owner == chip);
	}
	fake_chip_close(fake(chip));
	free(chip);
}

const char *gpiod_chip_label(struct gpiod_chip *chip)
{
	return fake(chip)->label;
}

const char *gpiod_chip_name(struct gpiod_chip *chip)
{
	return fake(chip)->name;
}

unsigned int gpiod_chip_num_lines(struct gpiod_chip *chip)
{
	return fake(chip)->lines;
}

struct gpiod_line *gpiod_chip_get_line(
	struct gpiod_chip *chip, unsigned int offset)
{
	struct fake_line *line = fake_chip_line(fake(chip), offset);

	if (line && !line->requested) {
		line->owner = chip;
	}
	return (struct gpiod_line *)line;
}

struct gpiod_line *gpiod_chip_find_line(
	struct gpiod_chip *chip, const char *name)
{
	int offset = fake_chip_find(fake(chip), name);

	return offset < 0 ? NULL
			  : gpiod_chip_get_line(chip, (unsigned int)offset);
}

unsigned int gpiod_line_offset(struct gpiod_line *line)
{
	return fake_line_offset(fake_line(line));
}

int gpiod_line_update(struct gpiod_line *line)
{
	(void)line;
	return 0;
}

bool gpiod_line_is_used(struct gpiod_line *line)
{
	return fake_line(line)->holder || fake_line(line)->requested;
}

const char *gpiod_line_name(struct gpiod_line *line)
{
	return fake_line(line)->name;
}

const char *gpiod_line_consumer(struct gpiod_line *line)
{
	return fake_line(line)->requested ? fake_line(line)->consumer
					  : fake_line(line)->holder;
}

static enum fake_bias bias_of(int flags)
{
	if (flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_UP) {
		return FAKE_PULL_UP;
	}
	if (flags & GPIOD_LINE_REQUEST_FLAG_BIAS_PULL_DOWN) {
		return FAKE_PULL_DOWN;
	}
	return flags & GPIOD_LINE_REQUEST_FLAG_BIAS_DISABLE ? FAKE_NO_PULL
							    : FAKE_AS_IS;
}

int gpiod_line_request(struct gpiod_line *line,
	const struct gpiod_line_request_config *config, int default_value)
{
	if (fake_line_request(fake_line(line), config->consumer) < 0) {
		return -1;
	}
	fake_line(line)->both_edges =
		config->request_type == GPIOD_LINE_REQUEST_EVENT_BOTH_EDGES;
	fake_line(line)->input = fake_line(line)->both_edges;
	fake_line(line)->active_low =
		config->flags & GPIOD_LINE_REQUEST_FLAG_ACTIVE_LOW;
	fake_line(line)->bias = bias_of(config->flags);
	return fake_line(line)->input
		? 0
		: fake_line_drive(fake_line(line), default_value);
}

int gpiod_line_set_value(struct gpiod_line *line, int value)
{
	return fake_line_drive(fake_line(line), value);
}

void gpiod_line_release(struct gpiod_line *line)
{
	fake_line_release(fake_line(line));
}

int gpiod_line_event_get_fd(struct gpiod_line *line)
{
	return fake_line(line)->pipe[0];
}

int gpiod_line_get_value(struct gpiod_line *line)
{
	return fake_line_value(fake_line(line));
}

int gpiod_line_event_read_multiple(struct gpiod_line *line,
	struct gpiod_line_event *events, unsigned int num_events)
{
	struct fake_edge edges[FAKE_EDGES];
	int count = fake_line_read(fake_line(line), edges,
		num_events < FAKE_EDGES ? (int)num_events : FAKE_EDGES);

	for (int i = 0; i < count; i++) {
		events[i].ts.tv_sec = edges[i].stamp_ns / 1000000000;
		events[i].ts.tv_nsec = (long)(edges[i].stamp_ns % 1000000000);
		events[i].event_type = edges[i].rising
			? GPIOD_LINE_EVENT_RISING_EDGE
			: GPIOD_LINE_EVENT_FALLING_EDGE;
	}
	return count;
}
