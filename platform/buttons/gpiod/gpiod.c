/*
 * Buttons on GPIO lines: reads the edges that the kernel has time-stamped. The
 * chips may come and go at any time, such as those of a USB adapter.
 */
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/buttons/button_batch.h"
#include "platform/buttons/buttons.h"
#include "platform/buttons/event_time.h"
#include "platform/buttons/gpiod/gpio_held.h"
#include "platform/buttons/gpiod/gpiod_survey.h"

enum {
	LINES_MAX = BUTTON_HOLDERS_MAX
};

struct button_line {
	struct gpio_held held;
	char who[16]; /* of held */
	bool active;  /* as in the last event */
};

struct button_source {
	struct log log;
	struct button_line line[LINES_MAX];
	struct pollfd fd[LINES_MAX]; /* -1 for a line that is missing */
	int line_count;
	bool polled; /* polled_ms is set */
	int64_t polled_ms, retry_ms;
	struct button_batch batch;
};

/* A button that is held now counts from its next press. */
static void use_line(struct button_source *source, int index)
{
	struct button_line *line = &source->line[index];

	line->active = gpio_line_level(line->held.line) == 1;
	source->fd[index].fd = gpio_line_fd(line->held.line);
}

static void close_line(struct button_source *source, int index)
{
	gpio_held_close(&source->line[index].held);
	source->fd[index].fd = -1;
}

static bool is_any_missing(const struct button_source *source)
{
	for (int i = 0; i < source->line_count; i++) {
		if (!source->line[i].held.line) {
			return true;
		}
	}
	return false;
}

static void retry(struct button_source *source)
{
	struct gpio_chips chips;

	gpio_chips_open(&chips);
	for (int i = 0; i < source->line_count; i++) {
		struct gpio_held *held = &source->line[i].held;

		if (!held->line && gpio_held_retry(held, &chips, &source->log)) {
			use_line(source, i);
		}
	}
	gpio_chips_close(&chips);
}

/* Reads all items into specs. Returns their number, or -EINVAL after logging. */
static int read_specs(const char *argument, struct gpio_line_spec *specs,
	const struct log *log)
{
	int count = 0;

	while (argument && *argument) {
		size_t length = strcspn(argument, ",");
		char item[512];
		int error;

		if (count == LINES_MAX || length >= sizeof(item)) {
			log_error(log,
				"gpiod: give at most %d lines of at most %zu characters",
				LINES_MAX, sizeof(item) - 1);
			return -EINVAL;
		}
		memcpy(item, argument, length);
		item[length] = '\0';
		error = gpio_line_spec_parse(item, &specs[count], log);
		if (error) {
			return error;
		}
		count++;
		argument += length + (argument[length] == ',');
	}
	if (count == 0) {
		log_error(log,
			"gpiod: the lines are missing: give gpiod:BUTTON=CHIP/LINE,...");
		return -EINVAL;
	}
	return count;
}

static void gpiod_destroy(struct button_source *source)
{
	if (!source) {
		return;
	}
	for (int i = 0; i < source->line_count; i++) {
		close_line(source, i);
	}
	free(source);
}

static int gpiod_check(const char *argument, const struct log *log)
{
	struct gpio_line_spec specs[LINES_MAX];
	int count = read_specs(argument, specs, log);

	return count < 0 ? count : 0;
}

static void open_lines(struct button_source *source,
	const struct gpio_line_spec *specs, const struct log *log)
{
	struct gpio_chips chips;

	gpio_chips_open(&chips);
	gpio_chips_report_missing(
		&chips, "/dev/gpiochip*", "its buttons work", log);
	for (int i = 0; i < source->line_count; i++) {
		struct button_line *line = &source->line[i];
		const char *name = button_name(specs[i].button);

		snprintf(line->who, sizeof(line->who), "gpiod:%s", name);
		line->held = gpio_held_none(&specs[i], line->who, name);
		source->fd[i] = (struct pollfd){.fd = -1, .events = POLLIN};
		if (chips.count > 0 && gpio_held_open(&line->held, &chips, log)) {
			use_line(source, i);
		}
	}
	gpio_chips_close(&chips);
}

static int gpiod_create(
	const char *argument, const struct log *log, struct button_source **out)
{
	struct gpio_line_spec specs[LINES_MAX];
	int count = read_specs(argument, specs, log);
	struct button_source *source;

	if (count < 0) {
		return count;
	}
	source = calloc(1, sizeof(*source));
	if (!source) {
		log_error(log, "gpiod: out of memory");
		return -ENOMEM;
	}
	source->log = *log;
	source->line_count = count;
	open_lines(source, specs, log);
	*out = source;
	return 0;
}

_Static_assert(LINES_MAX *(GPIO_EDGES_MAX + 2) <= BUTTON_BATCH_CAPACITY,
	"a batch holds all edges that the kernel buffers");

static void add_edge(
	struct button_source *source, int line, int64_t time_ms, bool active)
{
	source->line[line].active = active;
	button_batch_add(&source->batch,
		(struct button_event){
			.time_ms = time_ms,
			.button = source->line[line].held.spec.button,
			.down = active,
			.holder = (uint8_t)line,
		});
}

static void lose_line(
	struct button_source *source, int index, int64_t now_ms, int error)
{
	struct button_line *line = &source->line[index];

	gpio_held_lose(&line->held, error, &source->log);
	source->fd[index].fd = -1;
	source->retry_ms = now_ms + GPIO_RETRY_MS;
	if (line->active) {
		add_edge(source, index, now_ms, false);
	}
}

/*
 * Reads the waiting edges of one line, then its level: the kernel's buffer may
 * have overflowed, or the controller may have missed a short pulse.
 */
static void read_line(struct button_source *source, int index,
	const struct event_clocks *clocks, int64_t now_ms)
{
	struct button_line *line = &source->line[index];
	struct gpio_edge edges[GPIO_EDGES_MAX];
	int count = source->fd[index].revents & POLLIN
		? gpio_line_read(line->held.line, edges)
		: -ENODEV;
	int level;

	if (count == -EAGAIN || count == -EINTR) {
		return;
	}
	if (count <= 0) {
		lose_line(source, index, now_ms, count ? count : -ENODEV);
		return;
	}
	for (int i = 0; i < count; i++) {
		int64_t time_ms = event_time_ms(clocks, edges[i].stamp_ns,
			source->polled_ms + 1, now_ms);

		add_edge(source, index, time_ms, edges[i].active);
	}
	level = gpio_line_level(line->held.line);
	if (level >= 0 && (level == 1) != line->active) {
		add_edge(source, index, now_ms, level == 1);
	}
}

/*
 * Reads the level of each line: before Linux 6.2, poll() does not tell that a
 * chip is gone, and the last edge may be one that the controller has missed.
 */
static void check_levels(struct button_source *source, int64_t now_ms)
{
	for (int i = 0; i < source->line_count; i++) {
		struct button_line *line = &source->line[i];
		int level =
			line->held.line ? gpio_line_level(line->held.line) : 0;

		if (level < 0) {
			lose_line(source, i, now_ms, level);
		} else if (line->held.line && (level == 1) != line->active) {
			add_edge(source, i, now_ms, level == 1);
		}
	}
}

static void begin_polling(struct button_source *source, int64_t now_ms,
	struct button_queue *queue)
{
	source->polled = true;
	source->polled_ms = now_ms;
	source->retry_ms = now_ms + GPIO_RETRY_MS;
	for (int i = 0; i < source->line_count; i++) {
		const struct gpio_line_spec *spec = &source->line[i].held.spec;

		if (spec->debounce_ms > 0) {
			queue->debounce_ms[spec->button] = spec->debounce_ms;
		}
	}
}

static void gpiod_poll(struct button_source *source, int64_t now_ms,
	struct button_queue *queue)
{
	if (!source->polled) {
		begin_polling(source, now_ms, queue);
	}
	if (source->line_count > 0 &&
		poll(source->fd, (nfds_t)source->line_count, 0) > 0) {
		struct event_clocks clocks = event_clocks_now();

		for (int i = 0; i < source->line_count; i++) {
			if (source->fd[i].revents) {
				read_line(source, i, &clocks, now_ms);
			}
		}
	}
	if (now_ms >= source->retry_ms) {
		check_levels(source, now_ms);
		source->retry_ms = now_ms + GPIO_RETRY_MS;
		if (is_any_missing(source)) {
			retry(source);
		}
	}
	button_batch_push(&source->batch, queue);
	source->polled_ms = now_ms;
}

const struct button_driver button_driver_gpiod = {
	.name = "gpiod",
	.summary = "gpiod:BUTTON=CHIP/LINE,..., buttons on GPIO lines",
	.check = gpiod_check,
	.create = gpiod_create,
	.poll = gpiod_poll,
	.destroy = gpiod_destroy,
	.survey = gpiod_survey,
};
