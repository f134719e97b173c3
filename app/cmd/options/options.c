#include "app/cmd/options/options_table.h"

#include <errno.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

struct options options_default(void)
{
	struct options options = {
		.width = 480,
		.height = 640,
		.clock = clock_real(),
		.rate_hz = 60.0,
		.bound_px = 0.5f,
		.report = "text",
		.speed = 1.0f,
		.runs = 15,
		.repeat = CLIP_LOOP,
		.interpolation = CLIP_AUTO,
	};

	for (int i = 0; i < BUTTON_COUNT; i++) {
		options.action[i] = (enum button)i;
	}
	return options;
}

static int distance(const char *a, const char *b)
{
	int row[32];
	int columns = (int)strlen(b);

	if (columns > 31 || strlen(a) > 31) {
		return 99;
	}
	for (int j = 0; j <= columns; j++) {
		row[j] = j;
	}
	for (int i = 1; a[i - 1]; i++) {
		int diagonal = row[0];

		row[0] = i;
		for (int j = 1; j <= columns; j++) {
			int best = diagonal + (a[i - 1] != b[j - 1]);

			diagonal = row[j];
			best = row[j] + 1 < best ? row[j] + 1 : best;
			best = row[j - 1] + 1 < best ? row[j - 1] + 1 : best;
			row[j] = best;
		}
	}
	return row[columns];
}

const char *options_closest(const char *word, const char *const *candidates)
{
	const char *closest = NULL;
	int best = strlen(word) < 4 ? 2 : 3;

	for (; *candidates; candidates++) {
		int d = distance(word, *candidates);

		if (d < best) {
			best = d;
			closest = *candidates;
		}
	}
	return closest;
}

static bool is_named(
	const struct option_entry *entry, const char *word, size_t length)
{
	if (length == 2 && word[0] == '-') {
		return entry->letter && word[1] == entry->letter;
	}
	return length > 2 && strncmp(word, "--", 2) == 0 &&
		strlen(entry->name) == length - 2 &&
		strncmp(word + 2, entry->name, length - 2) == 0;
}

/* The command's own, else another command's of that name, or NULL. */
static const struct option_entry *find_entry(
	const char *word, size_t length, enum command_bit command)
{
	const struct option_entry *found = NULL;

	for (size_t i = 0; option_entries[i].name; i++) {
		const struct option_entry *entry = &option_entries[i];

		if (!is_named(entry, word, length)) {
			continue;
		}
		if (entry->commands & (int)command) {
			return entry;
		}
		found = found ? found : entry;
	}
	return found;
}

static int say_unknown(const char *word, size_t length,
	enum command_bit command, const struct log *log)
{
	const char *names[OPTIONS_MAX];
	const char *closest;
	char bare[32];
	int count = 0;

	for (size_t i = 0; option_entries[i].name; i++) {
		if (option_entries[i].commands & (int)command) {
			names[count++] = option_entries[i].name;
		}
	}
	names[count] = NULL;
	snprintf(bare, sizeof(bare), "%.*s", (int)(length > 31 ? 31 : length),
		word);
	closest = options_closest(bare + strspn(bare, "-"), names);
	if (closest) {
		log_error(log, "%.*s: no such option: did you mean --%s?",
			(int)length, word, closest);
	} else {
		log_error(log, "%.*s: no such option: --help lists them",
			(int)length, word);
	}
	return -EINVAL;
}

/* True when the value, NULL for a switch, is good. */
static bool set_entry(const struct option_entry *entry, struct options *options,
	const char *value)
{
	char *member = (char *)options + entry->member;

	if (entry->set) {
		return entry->set(options, value);
	}
	if (!entry->value) {
		*(bool *)member = true;
		return true;
	}
	*(const char **)member = value;
	return value[0] != '\0';
}

/* One option and its value; *at moves over a value that is its own word. */
static int parse_option(struct options *options, enum command_bit command,
	int argc, char **argv, int *at, const struct log *log)
{
	const char *word = argv[*at];
	const char *equals = strchr(word, '=');
	size_t length = equals ? (size_t)(equals - word) : strlen(word);
	const struct option_entry *entry = find_entry(word, length, command);
	const char *value = equals ? equals + 1 : NULL;

	if (!entry) {
		return say_unknown(word, length, command, log);
	}
	if (!(entry->commands & (int)command)) {
		log_error(log,
			"--%s: not an option of this command: --help "
			"lists its own",
			entry->name);
		return -EINVAL;
	}
	if (entry->value && !value) {
		if (*at + 1 >= argc) {
			log_error(log, "--%s: its value is missing: want %s",
				entry->name, entry->expected);
			return -EINVAL;
		}
		value = argv[++*at];
	}
	if (!entry->value && value) {
		log_error(log, "--%s: takes no value", entry->name);
		return -EINVAL;
	}
	if (!set_entry(entry, options, value)) {
		log_error(log, "--%s %s: want %s", entry->name, value,
			entry->expected);
		return -EINVAL;
	}
	return 0;
}

int options_parse(struct options *options, enum command_bit command, int argc,
	char **argv, const struct log *log)
{
	bool only_words = false;

	for (int i = 0; i < argc; i++) {
		if (!only_words && strcmp(argv[i], "--") == 0) {
			only_words = true;
		} else if (!only_words && argv[i][0] == '-' && argv[i][1]) {
			int error = parse_option(
				options, command, argc, argv, &i, log);

			if (error) {
				return error;
			}
		} else if (options->model_path) {
			log_error(log,
				"%s: one model at a time, and %s came "
				"first",
				argv[i], options->model_path);
			return -EINVAL;
		} else {
			options->model_path = argv[i];
		}
	}
	return 0;
}

/* The entry of that name, the command's own before another's, or NULL. */
static const struct option_entry *find_named(
	enum command_bit command, const char *name)
{
	const struct option_entry *found = NULL;

	for (size_t i = 0; option_entries[i].name; i++) {
		if (strcmp(option_entries[i].name, name) == 0 &&
			(!found || (option_entries[i].commands & (int)command))) {
			found = &option_entries[i];
		}
	}
	return found;
}

bool options_takes(enum command_bit command, const char *name)
{
	const struct option_entry *entry = find_named(command, name);

	return entry && (entry->commands & (int)command);
}

int options_names(enum command_bit command, const char **names, int room)
{
	int count = 0;

	for (size_t i = 0; option_entries[i].name && count < room; i++) {
		if (option_entries[i].commands & (int)command) {
			names[count++] = option_entries[i].name;
		}
	}
	return count;
}

int options_set(struct options *options, enum command_bit command,
	const char *name, const char *value, const struct log *log)
{
	const struct option_entry *entry = find_named(command, name);
	struct options tried = *options;
	bool good;

	if (!entry) {
		log_error(log, "%s: no such option", name);
		return -EINVAL;
	}
	if (entry->value) {
		good = set_entry(entry, &tried, value);
	} else {
		good = strcmp(value, "yes") == 0 || strcmp(value, "no") == 0;
		if (good && value[0] == 'y') {
			good = set_entry(entry, &tried, NULL);
		}
	}
	if (!good) {
		log_error(log, "%s = %s: want %s", name, value,
			entry->value ? entry->expected : "yes or no");
		return -EINVAL;
	}
	if (entry->commands & (int)command) {
		*options = tried;
	}
	return 0;
}

void options_list(FILE *out, enum command_bit command)
{
	for (size_t i = 0; option_entries[i].name; i++) {
		const struct option_entry *entry = &option_entries[i];
		char left[32];

		if (!(entry->commands & (int)command)) {
			continue;
		}
		snprintf(left, sizeof(left), "%s%c%s--%s %s",
			entry->letter ? "-" : " ",
			entry->letter ? entry->letter : ' ',
			entry->letter ? ", " : "  ", entry->name,
			entry->value ? entry->value : "");
		fprintf(out, "  %-24s %s\n", left, entry->summary);
	}
}
