#include "app/cmd/options/config_buttons.h"

#include "platform/buttons/buttons.h"

#include <errno.h>
#include <stdio.h>
#include <string.h>

const char *const config_buttons_keys[] = {"UP", "DOWN", "LEFT", "RIGHT",
	"ENTER", "F6", "F8", "F9", "F10", "keyboard", "sources", NULL};

static const char space[] = " \t";

static int append(char *list, size_t size, const char *button,
	const char *words, size_t length, const struct log *log)
{
	size_t used = strlen(list);
	int added = snprintf(list + used, size - used, ",%s=%.*s", button,
		(int)length, words);

	if (added < 0 || (size_t)added >= size - used) {
		list[used] = '\0';
		log_error(log, "%s: there are too many buttons: remove some",
			button);
		return -EINVAL;
	}
	return 0;
}

/*
 * Lets the button driver check one GPIO line or key; it refuses one that is cut
 * here, too.
 */
static int check(const char *driver, const char *item, const struct log *log)
{
	char spec[600];

	snprintf(spec, sizeof(spec), "%s:%s", driver, item);
	return buttons_check(spec, log);
}

/* Adds a binding of length bytes: "gpio CHIP LINE..." or "key NAME". */
static int add_binding(struct config_buttons *buttons, const char *button,
	const char *binding, size_t length, const struct log *log)
{
	bool gpio = strncmp(binding, "gpio", 4) == 0;
	bool key = strncmp(binding, "key", 3) == 0;
	size_t word = strcspn(binding, " \t,");
	char *list = gpio ? buttons->lines : buttons->keys;
	size_t before = strlen(list);
	const char *rest = binding + word + strspn(binding + word, space);
	int error;

	if ((!gpio || word != 4) && (!key || word != 3)) {
		log_error(log,
			"%s = %.*s: give gpio CHIP LINE or key NAME, or several separated by commas",
			button, (int)length, binding);
		return -EINVAL;
	}
	length = rest < binding + length ? length - (size_t)(rest - binding) : 0;
	while (length > 0 && strchr(space, rest[length - 1])) {
		length--;
	}
	error = append(list, CONFIG_LIST_BYTES, button, rest, length, log);
	return error ? error
		     : check(gpio ? "gpiod" : "evdev", list + before + 1, log);
}

static int add_bindings(struct config_buttons *buttons, const char *button,
	const char *value, const struct log *log)
{
	int error;

	do {
		size_t length;

		value += strspn(value, space);
		length = strcspn(value, ",");
		error = add_binding(buttons, button, value, length, log);
		value += length;
	} while (!error && *value++ == ',');
	return error;
}

static int copy(char *text, size_t size, const char *value, const char *key,
	const struct log *log)
{
	if (strlen(value) >= size) {
		log_error(log,
			"%s: the value has more than %zu characters: make it shorter",
			key, size - 1);
		return -EINVAL;
	}
	strcpy(text, value);
	return 0;
}

/* Part of a device's name. --buttons gives a comma and = meanings of their own. */
static int set_keyboard(struct config_buttons *buttons, const char *value,
	const struct log *log)
{
	if (strpbrk(value, ",=")) {
		log_error(log,
			"keyboard = %s: leave out \",\" and \"=\": part of the name is enough",
			value);
		return -EINVAL;
	}
	buttons->no_keyboard = strcmp(value, "none") == 0;
	buttons->keyboard_given = !buttons->no_keyboard;
	return copy(buttons->keyboard, sizeof(buttons->keyboard),
		strcmp(value, "all") == 0 ? "" : value, "keyboard", log);
}

int config_buttons_set(struct config_buttons *buttons, const char *key,
	const char *value, const struct log *log)
{
	int error;

	if (strcmp(key, "sources") == 0) {
		error = buttons_check(value, log);
		return error ? error
			     : copy(buttons->sources, sizeof(buttons->sources),
				       value, key, log);
	}
	if (strcmp(key, "keyboard") == 0) {
		return set_keyboard(buttons, value, log);
	}
	return add_bindings(buttons, key, value, log);
}

int config_buttons_spec(const struct config_buttons *buttons, char *spec,
	size_t size, const struct log *log)
{
	bool lines = buttons->lines[0];
	bool keys = !buttons->no_keyboard &&
		(buttons->keyboard_given || buttons->keys[0]);
	bool colon = buttons->keyboard[0] || buttons->keys[0];
	int length = snprintf(spec, size, "%s%s%s%s%s%s%s%s%s",
		lines ? "gpiod:" : "", lines ? buttons->lines + 1 : "",
		lines && keys ? "," : "", keys ? "evdev" : "",
		keys && colon ? ":" : "", keys ? buttons->keyboard : "",
		keys ? buttons->keys : "",
		(lines || keys) && buttons->sources[0] ? "," : "",
		buttons->sources);

	if (length < 0 || (size_t)length >= size) {
		log_error(log,
			"[buttons]: there are too many buttons: remove some");
		return -EINVAL;
	}
	return 0;
}
