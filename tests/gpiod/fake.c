#include "tests/gpiod/fake.h"

#include "tests/support/test.h"

#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

/* The library's functions have no context parameter. */
static struct fake_gpio *machine;

void fake_gpio_begin(struct fake_gpio *gpio)
{
	*gpio = (struct fake_gpio){
		.chip = {{.name = "gpiochip0",
				 .label = "53fa4000.gpio",
				 .lines = FAKE_LINES},
			{.name = "gpiochip1",
				.label = "53fcc000.gpio",
				.lines = FAKE_LINES},
			{.name = "gpiochip2",
				.label = "53fd0000.gpio",
				.lines = FAKE_LINES}},
	};
	machine = gpio;
}

void fake_gpio_end(struct fake_gpio *gpio)
{
	for (int i = 0; i < FAKE_CHIPS; i++) {
		assert_int_equal(gpio->chip[i].opened, 0);
		for (int j = 0; j < FAKE_LINES; j++) {
			assert_false(gpio->chip[i].line[j].requested);
		}
	}
	machine = NULL;
}

static void set(struct fake_line *line, bool high, int age_us, clockid_t clock)
{
	struct timespec now;
	struct fake_edge edge;

	if (line->high == high) {
		return;
	}
	line->high = high;
	if (!line->requested) {
		return;
	}
	assert_int_equal(clock_gettime(clock, &now), 0);
	edge.stamp_ns = (int64_t)now.tv_sec * 1000000000 + now.tv_nsec -
		(int64_t)age_us * 1000;
	edge.rising = high != line->active_low;
	if (line->edges == FAKE_EDGES) {
		return;
	}
	line->edge[line->edges++] = edge;
	assert_int_equal(write(line->pipe[1], "e", 1), 1);
}

void fake_gpio_set(struct fake_line *line, bool high, int age_us)
{
	set(line, high, age_us, CLOCK_MONOTONIC);
}

void fake_gpio_set_real_time(struct fake_line *line, bool high, int age_us)
{
	set(line, high, age_us, CLOCK_REALTIME);
}

void fake_gpio_lose(struct fake_line *line)
{
	line->gone = true;
	assert_int_equal(write(line->pipe[1], "x", 1), 1);
}

struct fake_chip *fake_chip_open(const char *path)
{
	assert_non_null(machine);
	errno = ENOENT;
	if (strncmp(path, "/dev/", 5) != 0) {
		return NULL;
	}
	for (int i = 0; i < FAKE_CHIPS; i++) {
		struct fake_chip *chip = &machine->chip[i];

		if (chip->name && strcmp(chip->name, path + 5) == 0) {
			errno = chip->error;
			chip->opened += !chip->error;
			return chip->error ? NULL : chip;
		}
	}
	return NULL;
}

void fake_chip_close(struct fake_chip *chip)
{
	assert_true(chip->opened > 0);
	chip->opened--;
}

struct fake_line *fake_chip_line(struct fake_chip *chip, unsigned int offset)
{
	errno = EINVAL;
	return offset < chip->lines ? &chip->line[offset] : NULL;
}

int fake_chip_find(const struct fake_chip *chip, const char *name)
{
	for (unsigned int i = 0; i < chip->lines; i++) {
		if (chip->line[i].name && strcmp(chip->line[i].name, name) == 0) {
			return (int)i;
		}
	}
	errno = ENOENT;
	return -1;
}

unsigned int fake_line_offset(const struct fake_line *line)
{
	for (int i = 0; i < FAKE_CHIPS; i++) {
		for (unsigned int j = 0; j < FAKE_LINES; j++) {
			if (&machine->chip[i].line[j] == line) {
				return j;
			}
		}
	}
	fail();
	return 0;
}

int fake_line_request(struct fake_line *line, const char *consumer)
{
	if (line->holder || line->requested) {
		errno = EBUSY;
		return -1;
	}
	if (line->error || line->gone) {
		errno = line->gone ? ENODEV : line->error;
		return -1;
	}
	assert_int_equal(pipe(line->pipe), 0);
	line->requested = true;
	assert_true(strlen(consumer) < sizeof(line->consumer));
	strcpy(line->consumer, consumer);
	return 0;
}

void fake_line_release(struct fake_line *line)
{
	assert_true(line->requested);
	line->requested = false;
	line->edges = 0;
	close(line->pipe[0]);
	close(line->pipe[1]);
}

int fake_line_value(const struct fake_line *line)
{
	errno = ENODEV;
	return line->gone ? -1 : line->high != line->active_low;
}

int fake_line_drive(struct fake_line *line, bool active)
{
	bool high = active != line->active_low;

	errno = EPERM;
	if (!line->requested || line->input || line->gone) {
		return -1;
	}
	line->changes += line->high != high;
	line->high = high;
	return 0;
}

int fake_line_read(struct fake_line *line, struct fake_edge *edges, int capacity)
{
	char bytes[FAKE_EDGES];
	int count = line->edges < capacity ? line->edges : capacity;

	if (line->gone || line->read_error) {
		errno = line->gone ? ENODEV : line->read_error;
		line->read_error = 0;
		return -1;
	}
	/* A driver that does not poll first would wait here for ever. */
	assert_true(count > 0);
	assert_int_equal(read(line->pipe[0], bytes, (size_t)count), count);
	memcpy(edges, line->edge, (size_t)count * sizeof(*edges));
	line->edges -= count;
	memmove(line->edge, line->edge + count,
		(size_t)line->edges * sizeof(*edges));
	return count;
}
