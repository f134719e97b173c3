#include "app/cmd/options/config.h"

#include "app/character/text/ini_lines.h"
#include "app/cmd/options/config_buttons.h"
#include "platform/base/compiler.h"
#include "platform/base/file.h"
#include "platform/base/name_list.h"

#include <errno.h>
#include <ini.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
	SPEC_BYTES = 2 * CONFIG_LIST_BYTES + 2048,
	KEYS_MAX = 64,
	LINES_MAX = 100000
};

/* Each key but "model" and "labels" sets the option of the same name. */
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
	{"watchdog", {"watchdog", "failsafe", "user"}},
	{"math", {"math", "kernel", "influences", "lod"}},
};

/* [options] refuses these, which make no sense in a file or have a section. */
static const char *const not_in_options[] = {
	"help", "version", "config", "output", "demo", "buttons", NULL};

static const char *const section_names[] = {"start", "display", "buttons",
	"actions", "camera", "watchdog", "math", "options", NULL};

struct reader {
	const char *path;
	struct ini_lines lines;
	int error;
	struct config *config;
	struct options *options;
	enum command_bit command;
	struct config_buttons buttons;
	const struct log *outer;
	struct log log; /* puts FILE:LINE before each sentence */
};

/* Copies the name that the user gave. Returns the result of config_find(). */
static int take_name(
	const char *given, char *path, size_t size, const struct log *log)
{
	if (strlen(given) >= size) {
		log_error(log,
			"%.40s...: this name of a configuration file has more than %zu characters: give a shorter one with --config or LIMBER_CONFIG",
			given, size - 1);
		return -ENAMETOOLONG;
	}
	strcpy(path, given);
	return strcmp(given, "none") != 0;
}

int config_find(const char *given, bool search, char *path, size_t size,
	const struct log *log)
{
	const char *home = getenv("XDG_CONFIG_HOME");
	const char *below = "";
	int length;

	given = given ? given : getenv("LIMBER_CONFIG");
	if (given && *given) {
		return take_name(given, path, size, log);
	}
	if (!search) {
		return 0;
	}
	if (!home || !*home) {
		home = getenv("HOME");
		below = "/.config";
	}
	length = snprintf(
		path, size, "%s%s/limber/limber.conf", home ? home : "", below);
	if (home && length >= 0 && (size_t)length < size && file_exists(path)) {
		return 1;
	}
	length = snprintf(path, size, "/etc/limber.conf");
	return length >= 0 && (size_t)length < size && file_exists(path);
}

static void log_with_line(void *user, enum log_level level, const char *sentence)
{
	const struct reader *reader = user;

	log_write(reader->outer, level, "%s:%d: %s", reader->path,
		reader->lines.number, sentence);
}

/* Logs that there is no such section, key or button. Returns -EINVAL. */
static int refuse_unknown(struct reader *reader, const char *what,
	const char *name, const char *const *names)
{
	struct name_list list = {""};
	char hint[sizeof(list) + 32];

	for (int i = 0; names[i]; i++) {
		name_list_add(&list, names[i]);
	}
	snprintf(hint, sizeof(hint), "use one such as %s", list.text);
	options_log_unknown(&reader->log,
		&(struct options_unknown){"", name, what, "", hint}, names);
	return -EINVAL;
}

static int refuse_line(struct reader *reader, const char *why)
{
	log_error(&reader->log, "%s", why);
	return -EINVAL;
}

static bool is_one_of(const char *word, const char *const *names)
{
	while (*names && strcmp(word, *names) != 0) {
		names++;
	}
	return *names;
}

/* "F9 = UP" gives F9 the action that UP has in each demo. */
static int set_action(struct reader *reader, const char *key, const char *value)
{
	enum button button = button_from_name(key);
	enum button action = button_from_name(value);

	if (button == BUTTON_COUNT) {
		const char *const *names = config_buttons_keys;

		return refuse_unknown(reader, "button", key, names);
	}
	if (action == BUTTON_COUNT && strcmp(value, "none") != 0) {
		log_error(&reader->log,
			"%s = %s: give the button whose action %s shall have, or none",
			key, value, key);
		return -EINVAL;
	}
	reader->options->input.action[button] = action;
	return 0;
}

static int set_labels(struct reader *reader, const char *value)
{
	if (strcmp(value, "yes") != 0 && strcmp(value, "no") != 0) {
		log_error(&reader->log, "labels = %s: give yes or no", value);
		return -EINVAL;
	}
	reader->options->show.no_labels = value[0] == 'n';
	return 0;
}

static int set_option(struct reader *reader, const char *key, const char *value)
{
	char *kept = arena_strdup(&reader->config->arena, value);

	if (!kept) {
		log_error(&reader->log, "%s: there is not enough memory", key);
		return -ENOMEM;
	}
	if (strcmp(key, "model") == 0) {
		reader->options->model_path = kept;
		return *kept ? 0
			     : refuse_line(reader,
				       "model = : give the name of a file");
	}
	if (strcmp(key, "labels") == 0) {
		return set_labels(reader, value);
	}
	return options_set(
		reader->options, reader->command, key, kept, &reader->log);
}

/* [options] holds the options that have no section of their own. */
static int set_other(struct reader *reader, const char *key, const char *value)
{
	const char *names[KEYS_MAX];
	int count = options_names(FOR_PLAY, names, KEYS_MAX - 1);
	int kept = 0;

	for (int i = 0; i < count; i++) {
		if (!is_one_of(names[i], not_in_options)) {
			names[kept++] = names[i];
		}
	}
	names[kept] = NULL;
	if (is_one_of(key, not_in_options)) {
		log_error(&reader->log,
			"%s: this key does not belong in [options]: remove it or move it to its section",
			key);
		return -EINVAL;
	}
	if (!is_one_of(key, names)) {
		return refuse_unknown(reader, "key", key, names);
	}
	return set_option(reader, key, value);
}

/* The section to which a key belongs. */
static const char *section_of(const char *key)
{
	if (is_one_of(key, config_buttons_keys)) {
		return "buttons";
	}
	for (size_t i = 0; i < ARRAY_COUNT(sections); i++) {
		if (is_one_of(key, sections[i].keys)) {
			return sections[i].section;
		}
	}
	return "options";
}

static int set(struct reader *reader, const char *section, const char *key,
	const char *value)
{
	if (strcmp(section, "buttons") == 0) {
		return is_one_of(key, config_buttons_keys)
			? config_buttons_set(
				  &reader->buttons, key, value, &reader->log)
			: refuse_unknown(
				  reader, "key", key, config_buttons_keys);
	}
	if (strcmp(section, "actions") == 0) {
		return set_action(reader, key, value);
	}
	if (strcmp(section, "options") == 0) {
		return set_other(reader, key, value);
	}
	for (size_t i = 0; i < ARRAY_COUNT(sections); i++) {
		if (strcmp(section, sections[i].section) == 0) {
			return is_one_of(key, sections[i].keys)
				? set_option(reader, key, value)
				: refuse_unknown(
					  reader, "key", key, sections[i].keys);
		}
	}
	if (!*section) {
		log_error(&reader->log,
			"%s: this key comes before any [section]: write [%s] above it",
			key, section_of(key));
		return -EINVAL;
	}
	return refuse_unknown(reader, "section", section, section_names);
}

static int take(
	void *user, const char *section, const char *key, const char *value)
{
	struct reader *reader = user;

	if (!reader->error) {
		reader->error = set(reader, section, key, value);
	}
	return !reader->error;
}

static char *next_line(char *line, int size, void *user)
{
	struct reader *reader = user;

	if (reader->error || ini_lines_next(&reader->lines, line, size)) {
		return reader->error ? NULL : line;
	}
	if (*reader->lines.refusal) {
		reader->error = refuse_line(reader, reader->lines.refusal);
	}
	return NULL;
}

static int read_lines(struct reader *reader)
{
	int line = ini_parse_stream(next_line, reader, take, reader);

	if (reader->error) {
		return reader->error;
	}
	if (ferror(reader->lines.file)) {
		log_error(reader->outer, "%s: cannot be read", reader->path);
		return -EIO;
	}
	if (line) {
		reader->lines.number = line > 0 ? line : 0;
		return refuse_line(reader, INI_LINES_INVALID);
	}
	return 0;
}

static int take_buttons(struct reader *reader)
{
	char spec[SPEC_BYTES];
	int error = config_buttons_spec(
		&reader->buttons, spec, sizeof(spec), &reader->log);

	if (error || !spec[0] || !options_takes(reader->command, "buttons")) {
		return error;
	}
	reader->options->input.buttons =
		arena_strdup(&reader->config->arena, spec);
	if (!reader->options->input.buttons) {
		log_error(reader->outer, "%s: there is not enough memory",
			reader->path);
		return -ENOMEM;
	}
	return 0;
}

int config_read(struct config *config, FILE *file, const char *path,
	enum command_bit command, struct options *options, const struct log *log)
{
	struct reader reader = {
		.path = path,
		.lines = {.file = file, .separators = "=:", .most = LINES_MAX},
		.config = config,
		.options = options,
		.command = command,
		.outer = log,
		.log = {.write = log_with_line, .threshold = log->threshold},
	};
	int error;

	reader.log.user = &reader;
	error = read_lines(&reader);
	return error ? error : take_buttons(&reader);
}

int config_load(struct config *config, const char *path,
	enum command_bit command, struct options *options, const struct log *log)
{
	FILE *file = file_open_logged(path, log);
	int error;

	if (!file) {
		return -errno;
	}
	error = config_read(config, file, path, command, options, log);
	fclose(file);
	return error;
}

void config_release(struct config *config)
{
	arena_release(&config->arena);
}
