/*
 * Buttons on GPIO lines: reads the edges that the kernel has time-stamped. The
 * chips may come and go at any time, such as those of a USB adapter.
 */
#include <errno.h>
#include <poll.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/name_list.h"
#include "platform/buttons/button_batch.h"
#include "platform/buttons/buttons.h"
#include "platform/buttons/device_access.h"
#include "platform/buttons/event_time.h"
#include "platform/buttons/gpiod/gpio_line_spec.h"
#include "platform/buttons/gpiod/gpiod_survey.h"

enum {
	CHIPS_MAX = 32,
	DEVICES_MAX = 128, /* /dev/gpiochip0 to 127; numbers may have gaps */
	LINES_MAX = BUTTON_HOLDERS_MAX,
	RETRY_MS = 1000 /* between two looks at levels and at missing lines */
};

struct button_line {
	struct gpio_line_spec spec;
	/*
	 * A line has its own handle of its chip, which it closes when it is
	 * lost: the chip gets its former number again only if nobody holds it.
	 */
	struct gpio_chip *chip;
	struct gpio_line *line; /* NULL: missing */
	bool active;            /* as in the last event */
};

/* All chips of the machine, while lines are looked for. */
struct chip_list {
	struct gpio_chip *chip[CHIPS_MAX];
	int count;
	char denied[32]; /* the last one that may not be opened, or "" */
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

static void open_chips(struct chip_list *chips)
{
	*chips = (struct chip_list){.count = 0};
	for (int i = 0; i < DEVICES_MAX && chips->count < CHIPS_MAX; i++) {
		char path[32];
		int error;

		snprintf(path, sizeof(path), "/dev/gpiochip%d", i);
		error = gpio_chip_open(path, &chips->chip[chips->count]);
		if (!error) {
			chips->count++;
		} else if (error == -EACCES || error == -EPERM) {
			memcpy(chips->denied, path, sizeof(chips->denied));
		}
	}
}

static void close_chips(struct chip_list *chips)
{
	while (chips->count > 0) {
		gpio_chip_close(chips->chip[--chips->count]);
	}
}

static void say_missing_chips(
	const struct chip_list *chips, const struct log *log)
{
	if (chips->denied[0]) {
		device_access_report_denied(log, chips->denied);
	} else if (chips->count == 0) {
		log_warning(log,
			"/dev/gpiochip*: no GPIO chip on this machine yet: its buttons work when there is one");
	}
}

static bool chip_is_called(const struct gpio_chip *chip, const char *name)
{
	return strcmp(gpio_chip_label(chip), name) == 0 ||
		strcmp(gpio_chip_name(chip), name) == 0;
}

static void say_no_chip(const struct chip_list *chips,
	const struct gpio_line_spec *spec, const struct log *log)
{
	struct name_list labels = {""};

	for (int i = 0; i < chips->count; i++) {
		name_list_add(&labels, gpio_chip_label(chips->chip[i]));
	}
	log_warning(log, "gpiod:%s: no chip is labelled %s: choose one of %s",
		button_name(spec->button), spec->chip, labels.text);
}

/* The line's offset on this chip, or -1. */
static int offset_on(struct gpio_chip *chip, const struct gpio_line_spec *spec)
{
	if (spec->name[0]) {
		return gpio_chip_find(chip, spec->name);
	}
	return spec->offset < gpio_chip_line_count(chip) ? (int)spec->offset
							 : -1;
}

static void say_no_line(const struct gpio_line_spec *spec, const struct log *log)
{
	if (spec->name[0]) {
		log_warning(log,
			"gpiod:%s: %s%s has no line named %s: gpioinfo lists the names",
			button_name(spec->button),
			spec->chip[0] ? "chip " : "this machine", spec->chip,
			spec->name);
	} else {
		log_warning(log,
			"gpiod:%s: chip %s has no line %u: choose a lower number",
			button_name(spec->button), spec->chip, spec->offset);
	}
}

/* Finds the chip and the offset of a line; NULL after logging a warning. */
static struct gpio_chip *find_line(const struct chip_list *chips,
	const struct gpio_line_spec *spec, const struct log *log,
	unsigned int *offset)
{
	bool chip_found = !spec->chip[0];

	for (int i = 0; i < chips->count; i++) {
		struct gpio_chip *chip = chips->chip[i];
		int found;

		if (spec->chip[0] && !chip_is_called(chip, spec->chip)) {
			continue;
		}
		chip_found = true;
		found = offset_on(chip, spec);
		if (found >= 0) {
			*offset = (unsigned int)found;
			return chip;
		}
	}
	if (chip_found) {
		say_no_line(spec, log);
	} else {
		say_no_chip(chips, spec, log);
	}
	return NULL;
}

static void say_refused(const struct gpio_line_spec *spec,
	struct gpio_chip *chip, unsigned int offset, int error,
	const struct log *log)
{
	if (error == -EBUSY) {
		struct gpio_line_info line = {.used = false};

		(void)gpio_line_get_info(chip, offset, &line);
		log_warning(log,
			"gpiod:%s: line %u of %s is taken by %s: free it or choose another line",
			button_name(spec->button), offset, gpio_chip_label(chip),
			line.consumer[0] ? line.consumer : "a driver");
	} else {
		log_warning(log, "gpiod:%s: line %u of %s cannot be read: %s%s",
			button_name(spec->button), offset,
			gpio_chip_label(chip), strerror(-error),
			spec->settings.bias == GPIO_BIAS_AS_IS
				? ""
				: ": kernels before 5.5 need it without pull-up, pull-down and no-pull");
	}
}

/* Opens the line's own handle of a chip and requests it. 0 or -errno. */
static int request_line(
	struct button_line *line, struct gpio_chip *chip, unsigned int offset)
{
	const struct gpio_line_spec *spec = &line->spec;
	char path[GPIO_NAME_BYTES], consumer[32];
	int error;

	snprintf(path, sizeof(path), "/dev/%s", gpio_chip_name(chip));
	error = gpio_chip_open(path, &line->chip);
	if (error) {
		return error;
	}
	snprintf(consumer, sizeof(consumer), "limber %s",
		button_name(spec->button));
	error = gpio_line_request(
		line->chip, offset, &spec->settings, consumer, &line->line);
	if (error) {
		gpio_chip_close(line->chip);
		line->chip = NULL;
		line->line = NULL;
	}
	return error;
}

/* A button that is held now counts from its next press. */
static void open_line(struct button_source *source, int index,
	const struct chip_list *chips, const struct log *log)
{
	struct button_line *line = &source->line[index];
	unsigned int offset;
	struct gpio_chip *chip = find_line(chips, &line->spec, log, &offset);
	int error;

	if (!chip) {
		return;
	}
	error = request_line(line, chip, offset);
	if (error) {
		say_refused(&line->spec, chip, offset, error, log);
		return;
	}
	line->active = gpio_line_level(line->line) == 1;
	source->fd[index].fd = gpio_line_fd(line->line);
}

static void close_line(struct button_source *source, int index)
{
	struct button_line *line = &source->line[index];

	gpio_line_release(line->line);
	gpio_chip_close(line->chip);
	line->line = NULL;
	line->chip = NULL;
	source->fd[index].fd = -1;
}

static bool is_any_missing(const struct button_source *source)
{
	for (int i = 0; i < source->line_count; i++) {
		if (!source->line[i].line) {
			return true;
		}
	}
	return false;
}

/* The warnings about missing lines have been logged before. */
static void retry(struct button_source *source)
{
	struct log nowhere = log_to_nowhere();
	struct chip_list chips;

	open_chips(&chips);
	for (int i = 0; i < source->line_count; i++) {
		struct button_line *line = &source->line[i];

		if (line->line) {
			continue;
		}
		open_line(source, i, &chips, &nowhere);
		if (line->line) {
			log_note(&source->log, "gpiod:%s: its GPIO line is back",
				button_name(line->spec.button));
		}
	}
	close_chips(&chips);
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

static int gpiod_create(
	const char *argument, const struct log *log, struct button_source **out)
{
	struct gpio_line_spec specs[LINES_MAX];
	int count = read_specs(argument, specs, log);
	struct button_source *source;
	struct chip_list chips;

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
	open_chips(&chips);
	say_missing_chips(&chips, log);
	for (int i = 0; i < count; i++) {
		source->line[i].spec = specs[i];
		source->fd[i] = (struct pollfd){.fd = -1, .events = POLLIN};
		if (chips.count > 0) {
			open_line(source, i, &chips, log);
		}
	}
	close_chips(&chips);
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
			.button = source->line[line].spec.button,
			.down = active,
			.holder = (uint8_t)line,
		});
}

static void lose_line(
	struct button_source *source, int index, int64_t now_ms, int error)
{
	struct button_line *line = &source->line[index];

	log_warning(&source->log,
		"gpiod:%s: lost its GPIO line: %s: it works again when its chip is back",
		button_name(line->spec.button), strerror(-error));
	close_line(source, index);
	source->retry_ms = now_ms + RETRY_MS;
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
		? gpio_line_read(line->line, edges)
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
	level = gpio_line_level(line->line);
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
		int level = line->line ? gpio_line_level(line->line) : 0;

		if (level < 0) {
			lose_line(source, i, now_ms, level);
		} else if (line->line && (level == 1) != line->active) {
			add_edge(source, i, now_ms, level == 1);
		}
	}
}

static void begin_polling(struct button_source *source, int64_t now_ms,
	struct button_queue *queue)
{
	source->polled = true;
	source->polled_ms = now_ms;
	source->retry_ms = now_ms + RETRY_MS;
	for (int i = 0; i < source->line_count; i++) {
		const struct gpio_line_spec *spec = &source->line[i].spec;

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
		source->retry_ms = now_ms + RETRY_MS;
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
