/*
 * Takes the place of libgpiod behind gpio.h: chips and lines that answer
 * anything within what the library lets through.
 */
#include "platform/buttons/gpiod/gpio.h"
#include "tests/fuzz/fuzz_device_calls.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct gpio_chip {
	char label[32], name[32]; /* as long as the kernel's */
	unsigned int lines;
};

struct gpio_line {
	int fd;
};

/* Text that may have control characters and no end before its last byte. */
static void answer_text(char *text, size_t size)
{
	fuzz_device_spoil(text, size);
	text[size - 1] = '\0';
}

int gpio_chip_open(const char *path, struct gpio_chip **out)
{
	int number = atoi(path + strlen("/dev/gpiochip"));
	int error = number < 3 ? fuzz_device_fault() : ENOENT;
	struct gpio_chip *chip =
		error ? NULL : fuzz_device_object(sizeof(*chip));

	if (!chip) {
		return error ? -error : -ENOMEM;
	}
	snprintf(chip->label, sizeof(chip->label), "chip%d", number);
	snprintf(chip->name, sizeof(chip->name), "gpiochip%d", number);
	answer_text(chip->label, sizeof(chip->label));
	answer_text(chip->name, sizeof(chip->name));
	chip->lines = fuzz_device_byte();
	chip->lines = chip->lines == 255 ? fuzz_device_word() : chip->lines;
	*out = chip;
	return 0;
}

void gpio_chip_close(struct gpio_chip *chip)
{
	fuzz_device_release(chip);
}

const char *gpio_chip_label(const struct gpio_chip *chip)
{
	return chip->label;
}

const char *gpio_chip_name(const struct gpio_chip *chip)
{
	return chip->name;
}

unsigned int gpio_chip_line_count(const struct gpio_chip *chip)
{
	return chip->lines;
}

int gpio_chip_find(struct gpio_chip *chip, const char *name)
{
	(void)chip;
	(void)name;
	return (int)fuzz_device_byte() - 1;
}

int gpio_line_get_info(
	struct gpio_chip *chip, unsigned int offset, struct gpio_line_info *out)
{
	int error = fuzz_device_fault();

	(void)chip;
	(void)offset;
	if (error) {
		return -error;
	}
	memset(out, (int)fuzz_device_byte(), sizeof(*out));
	answer_text(out->name, sizeof(out->name));
	answer_text(out->consumer, sizeof(out->consumer));
	out->used = fuzz_device_byte() % 2;
	return 0;
}

/* The descriptor is real, because the driver polls it: it is always readable. */
int gpio_line_request(struct gpio_chip *chip, unsigned int offset,
	const struct gpio_settings *settings, const char *consumer,
	struct gpio_line **out)
{
	int error = fuzz_device_fault();
	struct gpio_line *line =
		error ? NULL : fuzz_device_object(sizeof(*line));

	(void)chip;
	(void)offset;
	(void)settings;
	(void)consumer;
	if (!line) {
		return error ? -error : -ENOMEM;
	}
	line->fd = open("/dev/zero", O_RDONLY | O_CLOEXEC);
	*out = line;
	return 0;
}

int gpio_line_drive(struct gpio_line *line, bool active)
{
	(void)line;
	(void)active;
	return -fuzz_device_fault();
}

void gpio_line_release(struct gpio_line *line)
{
	if (line) {
		close(line->fd);
		fuzz_device_release(line);
	}
}

int gpio_line_fd(const struct gpio_line *line)
{
	return line->fd;
}

int gpio_line_level(struct gpio_line *line)
{
	int error = fuzz_device_fault();

	(void)line;
	return error ? -error : (int)fuzz_device_byte() % 2;
}

int gpio_line_read(
	struct gpio_line *line, struct gpio_edge edges[GPIO_EDGES_MAX])
{
	int error = fuzz_device_fault();
	int count = (int)fuzz_device_byte() % (GPIO_EDGES_MAX + 1);

	(void)line;
	for (int i = 0; i < count && !error; i++) {
		uint64_t stamp = (uint64_t)fuzz_device_word() << 32;

		edges[i] = (struct gpio_edge){
			.stamp_ns = (int64_t)(stamp | fuzz_device_word()),
			.active = fuzz_device_byte() % 2,
		};
	}
	return error ? -error : count;
}
