#include "platform/buttons/gpiod/gpio_line_spec.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/compiler.h"

enum {
	TEXT_BYTES = 256
};

static bool read_number(const char *text, unsigned long most, unsigned int *out)
{
	char *end;
	unsigned long value;

	if (*text < '0' || *text > '9') {
		return false;
	}
	errno = 0;
	value = strtoul(text, &end, 10);
	if (errno || *end || value > most) {
		return false;
	}
	*out = (unsigned int)value;
	return true;
}

/* True when the word is an option; *good is false when its value is wrong. */
static bool read_option(
	const char *word, struct gpio_line_spec *spec, bool *good)
{
	static const struct {
		const char *name;
		enum gpio_bias bias;
	} biases[] = {
		{"pull-up", GPIO_BIAS_PULL_UP},
		{"pull-down", GPIO_BIAS_PULL_DOWN},
		{"no-pull", GPIO_BIAS_NONE},
	};
	static const char debounce[] = "debounce=";
	unsigned int value = 0;

	*good = true;
	for (size_t i = 0; i < ARRAY_COUNT(biases); i++) {
		if (strcmp(word, biases[i].name) == 0) {
			spec->settings.bias = biases[i].bias;
			return true;
		}
	}
	if (strcmp(word, "active-low") == 0 || strcmp(word, "active-high") == 0) {
		spec->settings.active_low = word[7] == 'l';
		return true;
	}
	if (strncmp(word, debounce, sizeof(debounce) - 1) != 0) {
		return false;
	}
	*good = read_number(word + sizeof(debounce) - 1, GPIO_DEBOUNCE_MAX_MS,
			&value) &&
		value > 0;
	spec->debounce_ms = (int)value;
	return true;
}

static bool copy_name(char *name, const char *word)
{
	size_t length = strlen(word);

	if (length >= GPIO_NAME_BYTES) {
		return false;
	}
	memcpy(name, word, length + 1);
	return true;
}

/* Reads the words before the options: CHIP OFFSET, CHIP NAME or NAME. Returns
 * NULL, or what is wrong with them. */
static const char *read_line_name(
	struct gpio_line_spec *spec, const char *const *word, int count)
{
	static const char too_long[] = "a name may have at most 63 characters";
	const char *line;

	if (count == 0) {
		return "the line is missing: give CHIP/LINE or a line's name";
	}
	if (count > 2) {
		return "give CHIP/LINE or a line's name, then any of active-low, active-high, pull-up, pull-down, no-pull and debounce=MS";
	}
	line = word[count - 1];
	if (count == 2 && !copy_name(spec->chip, word[0])) {
		return too_long;
	}
	if (read_number(line, 65535, &spec->offset)) {
		return count == 2
			? NULL
			: "a number needs its chip: give CHIP/LINE with the chip's label";
	}
	return copy_name(spec->name, line) ? NULL : too_long;
}

static const char *read_words(struct gpio_line_spec *spec, char *text)
{
	const char *space = strpbrk(text, " \t") ? " \t" : "/";
	const char *name[3];
	int names = 0;
	char *rest = text;

	for (char *word = strtok_r(text, space, &rest); word;
		word = strtok_r(NULL, space, &rest)) {
		bool good;

		if (read_option(word, spec, &good)) {
			if (!good) {
				return "give debounce=MS with MS from 1 to 1000";
			}
		} else if (names < 3) {
			name[names++] = word;
		}
	}
	return read_line_name(spec, name, names);
}

int gpio_line_spec_parse(
	const char *text, struct gpio_line_spec *out, const struct log *log)
{
	char copy[TEXT_BYTES];
	const char *wrong = NULL;
	char *equals;

	*out = (struct gpio_line_spec){.button = BUTTON_COUNT};
	if (strlen(text) >= sizeof(copy)) {
		log_error(log,
			"gpiod:%.20s...: a line may have at most %d characters",
			text, TEXT_BYTES - 1);
		return -EINVAL;
	}
	memcpy(copy, text, strlen(text) + 1);
	equals = strchr(copy, '=');
	if (!equals) {
		wrong = "give BUTTON=CHIP/LINE";
	} else {
		*equals = '\0';
		out->button = button_from_name(copy);
		wrong = out->button == BUTTON_COUNT
			? "no such button: choose UP, DOWN, LEFT, RIGHT, ENTER, F6, F8, F9 or F10"
			: read_words(out, equals + 1);
	}
	if (wrong) {
		log_error(log, "gpiod:%s: %s", text, wrong);
		return -EINVAL;
	}
	return 0;
}

int gpio_line_spec_parse_output(
	const char *text, struct gpio_line_spec *out, const struct log *log)
{
	char copy[TEXT_BYTES];
	const char *wrong;

	*out = (struct gpio_line_spec){.button = BUTTON_COUNT};
	if (strlen(text) >= sizeof(copy)) {
		log_error(log, "%.20s...: a line may have at most %d characters",
			text, TEXT_BYTES - 1);
		return -EINVAL;
	}
	memcpy(copy, text, strlen(text) + 1);
	wrong = read_words(out, copy);
	if (wrong) {
		log_error(log, "%s: %s", text, wrong);
		return -EINVAL;
	}
	out->settings.output = true;
	return 0;
}
