#include "app/cmd/options/config.h"

#include "app/cmd/options/config_buttons.h"
#include "platform/base/compiler.h"
#include "platform/base/file.h"

#include <errno.h>
#include <ini.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	SPEC_ROOM = 2 * CONFIG_LIST_ROOM + 2048,
	KEYS_MAX = 64
};

/* Which option a section's key is: the key is its name. */
static const struct {
	const char *section;
	const char *keys[12];
} sections[] = {
	{"start",
		{"demo", "model", "clip", "time", "interpolation", "speed",
			"repeat"}},
	{"display",
		{"display", "size", "format", "gl", "egl-library",
			"gles-library", "fps", "labels"}},
	{"camera", {"camera", "camera-use"}},
	{"watchdog", {"watchdog"}},
	{"math", {"math", "kernel", "influences", "lod"}},
};

/* Options of play that make no sense in a file. */
static const char *const not_in_files[] = {
	"help", "version", "config", "output", "demo", "buttons"};

static const char *const section_names[] = {"start", "display", "buttons",
	"actions", "camera", "watchdog", "math", "options", NULL};

struct reading {
	const char *path;
	FILE *file;
	int line;
	int error;
	struct config *config;
	struct options *options;
	enum command_bit command;
	struct config_buttons buttons;
	const struct log *outer;
	struct log log; /* puts FILE:LINE before what is said */
};

bool config_find(const char *given, bool search, char *path, size_t size)
{
	const char *home = getenv("XDG_CONFIG_HOME");
	const char *below = "";
	int length;

	given = given ? given : getenv("LIMBER_CONFIG");
	if (given && *given) {
		length = snprintf(path, size, "%s", given);
		return strcmp(given, "none") != 0 && length >= 0 &&
			(size_t)length < size;
	}
	if (!search) {
		return false;
	}
	if (!home || !*home) {
		home = getenv("HOME");
		below = "/.config";
	}
	length = snprintf(
		path, size, "%s%s/limber/limber.conf", home ? home : "", below);
	if (home && length >= 0 && (size_t)length < size && file_exists(path)) {
		return true;
	}
	length = snprintf(path, size, "/etc/limber.conf");
	return length >= 0 && (size_t)length < size && file_exists(path);
}

static void say_with_place(
	void *user, enum log_level level, const char *sentence)
{
	const struct reading *reading = user;

	log_write(reading->outer, level, "%s:%d: %s", reading->path,
		reading->line, sentence);
}

/* Says that the word is none of the names. -EINVAL. */
static int say_unknown(struct reading *reading, const char *what,
	const char *word, const char *const *names)
{
	const char *closest = options_closest(word, names);

	if (closest) {
		log_error(&reading->log, "%s: no such %s: did you mean %s?",
			word, what, closest);
	} else {
		log_error(&reading->log, "%s: no such %s: there are %s, %s%s",
			word, what, names[0], names[1],
			names[2] ? " and others" : "");
	}
	return -EINVAL;
}

static bool is_one_of(const char *word, const char *const *names)
{
	while (*names && strcmp(word, *names) != 0) {
		names++;
	}
	return *names;
}

/* "F9 = UP": F9 does what UP does in every demo. */
static int set_action(
	struct reading *reading, const char *key, const char *value)
{
	enum button button = button_from_name(key);
	enum button action = button_from_name(value);

	if (button == BUTTON_COUNT) {
		const char *const *names = config_buttons_keys;

		return say_unknown(reading, "button", key, names);
	}
	if (action == BUTTON_COUNT && strcmp(value, "none") != 0) {
		log_error(&reading->log,
			"%s = %s: want the button whose action it is to do, "
			"or none",
			key, value);
		return -EINVAL;
	}
	reading->options->action[button] = action;
	return 0;
}

static int set_labels(struct reading *reading, const char *value)
{
	if (strcmp(value, "yes") != 0 && strcmp(value, "no") != 0) {
		log_error(&reading->log, "labels = %s: want yes or no", value);
		return -EINVAL;
	}
	reading->options->no_labels = value[0] == 'n';
	return 0;
}

static int set_option(
	struct reading *reading, const char *key, const char *value)
{
	char *kept = arena_strdup(&reading->config->arena, value);

	if (!kept) {
		log_error(&reading->log, "%s: out of memory", key);
		return -ENOMEM;
	}
	if (strcmp(key, "model") == 0) {
		reading->options->model_path = kept;
		return 0;
	}
	if (strcmp(key, "labels") == 0) {
		return set_labels(reading, value);
	}
	return options_set(
		reading->options, reading->command, key, kept, &reading->log);
}

/* [options] takes what has no section of its own. */
static int set_other(struct reading *reading, const char *key, const char *value)
{
	const char *names[KEYS_MAX];
	int count = options_names(FOR_PLAY, names, KEYS_MAX - 1);
	bool refused = false;

	names[count] = NULL;
	for (size_t i = 0; i < ARRAY_COUNT(not_in_files); i++) {
		refused = refused || strcmp(key, not_in_files[i]) == 0;
	}
	if (refused) {
		log_error(&reading->log,
			"%s: not in [options] of a file: see the sections", key);
		return -EINVAL;
	}
	if (!is_one_of(key, names)) {
		return say_unknown(reading, "key", key, names);
	}
	return set_option(reading, key, value);
}

static int set(struct reading *reading, const char *section, const char *key,
	const char *value)
{
	if (strcmp(section, "buttons") == 0) {
		return is_one_of(key, config_buttons_keys)
			? config_buttons_set(
				  &reading->buttons, key, value, &reading->log)
			: say_unknown(reading, "key", key, config_buttons_keys);
	}
	if (strcmp(section, "actions") == 0) {
		return set_action(reading, key, value);
	}
	if (strcmp(section, "options") == 0) {
		return set_other(reading, key, value);
	}
	for (size_t i = 0; i < ARRAY_COUNT(sections); i++) {
		if (strcmp(section, sections[i].section) == 0) {
			return is_one_of(key, sections[i].keys)
				? set_option(reading, key, value)
				: say_unknown(reading, "key", key,
					  sections[i].keys);
		}
	}
	if (!*section) {
		log_error(&reading->log, "%s: before any [section]", key);
		return -EINVAL;
	}
	return say_unknown(reading, "section", section, section_names);
}

static int take(
	void *user, const char *section, const char *key, const char *value)
{
	struct reading *reading = user;

	if (!reading->error) {
		reading->error = set(reading, section, key, value);
	}
	return !reading->error;
}

/* The library goes on after a line it cannot read: the first is named here. */
static bool is_sound(const char *line)
{
	if (*line == '[') {
		return strchr(line, ']');
	}
	return strchr(";#\r\n", *line) || strpbrk(line, "=:");
}

/* One line. What stands to the right of the edge is no continuation. */
static char *next_line(char *text, int room, void *user)
{
	struct reading *reading = user;
	size_t length, blank;

	if (reading->error || !fgets(text, room, reading->file)) {
		return NULL;
	}
	reading->line++;
	length = strlen(text);
	if (length > 0 && text[length - 1] != '\n' && !feof(reading->file)) {
		log_error(&reading->log, "a line of more than %d characters",
			room - 2);
		reading->error = -EINVAL;
		return NULL;
	}
	blank = strspn(text, " \t");
	memmove(text, text + blank, length + 1 - blank);
	if (!is_sound(text)) {
		log_error(&reading->log,
			"want [SECTION], KEY = VALUE or "
			"; a comment");
		reading->error = -EINVAL;
		return NULL;
	}
	return text;
}

static int read_lines(struct reading *reading)
{
	int line = ini_parse_stream(next_line, reading, take, reading);

	if (reading->error) {
		return reading->error;
	}
	if (ferror(reading->file)) {
		log_error(reading->outer, "%s: cannot be read", reading->path);
		return -EIO;
	}
	if (line) {
		reading->line = line > 0 ? line : 0;
		log_error(&reading->log,
			"want [SECTION], KEY = VALUE or "
			"; a comment");
		return -EINVAL;
	}
	return 0;
}

static int take_buttons(struct reading *reading)
{
	char spec[SPEC_ROOM];
	int error = config_buttons_spec(
		&reading->buttons, spec, sizeof(spec), &reading->log);

	if (error || !spec[0] || !options_takes(reading->command, "buttons")) {
		return error;
	}
	reading->options->buttons = arena_strdup(&reading->config->arena, spec);
	if (!reading->options->buttons) {
		log_error(reading->outer, "%s: out of memory", reading->path);
		return -ENOMEM;
	}
	return 0;
}

int config_read(struct config *config, FILE *file, const char *path,
	enum command_bit command, struct options *options, const struct log *log)
{
	struct reading *reading = calloc(1, sizeof(*reading));
	int error;

	if (!reading) {
		log_error(log, "%s: out of memory", path);
		return -ENOMEM;
	}
	*reading = (struct reading){
		.path = path,
		.file = file,
		.config = config,
		.options = options,
		.command = command,
		.outer = log,
	};
	reading->log = (struct log){
		.write = say_with_place,
		.user = reading,
		.threshold = log->threshold,
	};
	error = read_lines(reading);
	error = error ? error : take_buttons(reading);
	free(reading);
	return error;
}

int config_load(struct config *config, const char *path,
	enum command_bit command, struct options *options, const struct log *log)
{
	FILE *file = fopen(path, "r");
	int error;

	if (!file) {
		error = -errno;
		log_error(log, "%s: cannot be read: %s", path, strerror(-error));
		return error;
	}
	error = config_read(config, file, path, command, options, log);
	fclose(file);
	return error;
}

void config_release(struct config *config)
{
	arena_release(&config->arena);
}
