/* The functions of libgpiod 2.x that the driver calls. */
#include "tests/gpiod/fake.h"

#include "tests/support/test.h"

#include <errno.h>
#include <gpiod.h>
#include <stdlib.h>

struct gpiod_line_settings {
	enum gpiod_line_direction direction;
	enum gpiod_line_edge edge;
	enum gpiod_line_bias bias;
	bool active_low;
};

struct gpiod_line_config {
	unsigned int offset;
	struct gpiod_line_settings settings;
};

struct gpiod_request_config {
	const char *consumer;
};

struct gpiod_edge_event {
	struct fake_edge edge;
};

struct gpiod_edge_event_buffer {
	int capacity, count;
	struct gpiod_edge_event event[FAKE_EDGES];
};

static struct fake_chip *fake(struct gpiod_chip *chip)
{
	return (struct fake_chip *)chip;
}

static struct fake_line *fake_line(struct gpiod_line_request *request)
{
	return (struct fake_line *)request;
}

static void *make(size_t size)
{
	void *made = calloc(1, size);

	assert_non_null(made);
	return made;
}

struct gpiod_chip *gpiod_chip_open(const char *path)
{
	return (struct gpiod_chip *)fake_chip_open(path);
}

void gpiod_chip_close(struct gpiod_chip *chip)
{
	fake_chip_close(fake(chip));
}

/* Allocated as in the library, so that the driver must free it. */
struct gpiod_chip_info *gpiod_chip_get_info(struct gpiod_chip *chip)
{
	struct fake_chip **info = make(sizeof(*info));

	*info = fake(chip);
	return (struct gpiod_chip_info *)info;
}

void gpiod_chip_info_free(struct gpiod_chip_info *info)
{
	free(info);
}

const char *gpiod_chip_info_get_name(struct gpiod_chip_info *info)
{
	return (*(struct fake_chip **)info)->name;
}

const char *gpiod_chip_info_get_label(struct gpiod_chip_info *info)
{
	return (*(struct fake_chip **)info)->label;
}

size_t gpiod_chip_info_get_num_lines(struct gpiod_chip_info *info)
{
	return (*(struct fake_chip **)info)->lines;
}

int gpiod_chip_get_line_offset_from_name(
	struct gpiod_chip *chip, const char *name)
{
	return fake_chip_find(fake(chip), name);
}

struct gpiod_line_info *gpiod_chip_get_line_info(
	struct gpiod_chip *chip, unsigned int offset)
{
	struct fake_line *line = fake_chip_line(fake(chip), offset);
	struct fake_line **info = NULL;

	if (line) {
		info = make(sizeof(*info));
		*info = line;
	}
	return (struct gpiod_line_info *)info;
}

void gpiod_line_info_free(struct gpiod_line_info *info)
{
	free(info);
}

bool gpiod_line_info_is_used(struct gpiod_line_info *info)
{
	const struct fake_line *line = *(struct fake_line **)info;

	return line->holder || line->requested;
}

const char *gpiod_line_info_get_name(struct gpiod_line_info *info)
{
	return (*(struct fake_line **)info)->name;
}

const char *gpiod_line_info_get_consumer(struct gpiod_line_info *info)
{
	const struct fake_line *line = *(struct fake_line **)info;

	return line->requested ? line->consumer : line->holder;
}

struct gpiod_line_settings *gpiod_line_settings_new(void)
{
	return make(sizeof(struct gpiod_line_settings));
}

void gpiod_line_settings_free(struct gpiod_line_settings *settings)
{
	free(settings);
}

int gpiod_line_settings_set_direction(struct gpiod_line_settings *settings,
	enum gpiod_line_direction direction)
{
	settings->direction = direction;
	return 0;
}

int gpiod_line_settings_set_edge_detection(
	struct gpiod_line_settings *settings, enum gpiod_line_edge edge)
{
	settings->edge = edge;
	return 0;
}

int gpiod_line_settings_set_bias(
	struct gpiod_line_settings *settings, enum gpiod_line_bias bias)
{
	settings->bias = bias;
	return 0;
}

void gpiod_line_settings_set_active_low(
	struct gpiod_line_settings *settings, bool active_low)
{
	settings->active_low = active_low;
}

struct gpiod_line_config *gpiod_line_config_new(void)
{
	return make(sizeof(struct gpiod_line_config));
}

void gpiod_line_config_free(struct gpiod_line_config *config)
{
	free(config);
}

int gpiod_line_config_add_line_settings(struct gpiod_line_config *config,
	const unsigned int *offsets, size_t num_offsets,
	struct gpiod_line_settings *settings)
{
	assert_int_equal(num_offsets, 1);
	config->offset = offsets[0];
	config->settings = *settings;
	return 0;
}

struct gpiod_request_config *gpiod_request_config_new(void)
{
	return make(sizeof(struct gpiod_request_config));
}

void gpiod_request_config_free(struct gpiod_request_config *config)
{
	free(config);
}

void gpiod_request_config_set_consumer(
	struct gpiod_request_config *config, const char *consumer)
{
	config->consumer = consumer;
}

static enum fake_bias bias_of(enum gpiod_line_bias bias)
{
	switch (bias) {
	case GPIOD_LINE_BIAS_PULL_UP:
		return FAKE_PULL_UP;
	case GPIOD_LINE_BIAS_PULL_DOWN:
		return FAKE_PULL_DOWN;
	case GPIOD_LINE_BIAS_DISABLED:
		return FAKE_NO_PULL;
	default:
		return FAKE_AS_IS;
	}
}

struct gpiod_line_request *gpiod_chip_request_lines(struct gpiod_chip *chip,
	struct gpiod_request_config *req_cfg, struct gpiod_line_config *line_cfg)
{
	struct fake_line *line = fake_chip_line(fake(chip), line_cfg->offset);

	if (!line || fake_line_request(line, req_cfg->consumer) < 0) {
		return NULL;
	}
	line->input = line_cfg->settings.direction == GPIOD_LINE_DIRECTION_INPUT;
	line->both_edges = line_cfg->settings.edge == GPIOD_LINE_EDGE_BOTH;
	line->active_low = line_cfg->settings.active_low;
	line->bias = bias_of(line_cfg->settings.bias);
	if (!line->input) {
		fake_line_drive(line, false);
	}
	return (struct gpiod_line_request *)line;
}

void gpiod_line_request_release(struct gpiod_line_request *request)
{
	fake_line_release(fake_line(request));
}

int gpiod_line_request_get_fd(struct gpiod_line_request *request)
{
	return fake_line(request)->pipe[0];
}

enum gpiod_line_value gpiod_line_request_get_value(
	struct gpiod_line_request *request, unsigned int offset)
{
	(void)offset;
	return (enum gpiod_line_value)fake_line_value(fake_line(request));
}

int gpiod_line_request_set_value(struct gpiod_line_request *request,
	unsigned int offset, enum gpiod_line_value value)
{
	(void)offset;
	return fake_line_drive(
		fake_line(request), value == GPIOD_LINE_VALUE_ACTIVE);
}

struct gpiod_edge_event_buffer *gpiod_edge_event_buffer_new(size_t capacity)
{
	struct gpiod_edge_event_buffer *buffer = make(sizeof(*buffer));

	buffer->capacity = capacity < FAKE_EDGES ? (int)capacity : FAKE_EDGES;
	return buffer;
}

void gpiod_edge_event_buffer_free(struct gpiod_edge_event_buffer *buffer)
{
	free(buffer);
}

struct gpiod_edge_event *gpiod_edge_event_buffer_get_event(
	struct gpiod_edge_event_buffer *buffer, unsigned long index)
{
	assert_true(index < (unsigned long)buffer->count);
	return &buffer->event[index];
}

int gpiod_line_request_read_edge_events(struct gpiod_line_request *request,
	struct gpiod_edge_event_buffer *buffer, size_t max_events)
{
	struct fake_edge edges[FAKE_EDGES];
	int capacity = max_events < (size_t)buffer->capacity ? (int)max_events
							     : buffer->capacity;

	buffer->count = fake_line_read(fake_line(request), edges, capacity);
	for (int i = 0; i < buffer->count; i++) {
		buffer->event[i].edge = edges[i];
	}
	return buffer->count;
}

enum gpiod_edge_event_type gpiod_edge_event_get_event_type(
	struct gpiod_edge_event *event)
{
	return event->edge.rising ? GPIOD_EDGE_EVENT_RISING_EDGE
				  : GPIOD_EDGE_EVENT_FALLING_EDGE;
}

uint64_t gpiod_edge_event_get_timestamp_ns(struct gpiod_edge_event *event)
{
	return (uint64_t)event->edge.stamp_ns;
}
