#include "app/cmd/options/options_table.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

struct options options_default(void)
{
	struct options options = {
		.common.memory_bytes = MODEL_MEMORY_BYTES,
		.motion.speed = 1.0f,
		.motion.repeat = CLIP_LOOP,
		.motion.interpolation = CLIP_AUTO,
		.screen.size = {.width = 480, .height = 640},
		.show.clock = clock_real(),
		.compare = {.fps = 60.0,
			.error_px = 0.5f,
			.board = board_profile_find(NULL),
			.format = "text"},
		.bench.runs = 15,
	};

	for (int i = 0; i < BUTTON_COUNT; i++) {
		options.input.action[i] = (enum button)i;
	}
	return options;
}

/* The Levenshtein distance, ignoring case; INT_MAX beyond 31 characters. */
static int distance(const char *a, const char *b)
{
	int row[32];
	int columns = (int)strlen(b);

	if (columns > 31 || strlen(a) > 31) {
		return INT_MAX;
	}
	for (int j = 0; j <= columns; j++) {
		row[j] = j;
	}
	for (int i = 1; a[i - 1]; i++) {
		int diagonal = row[0];

		row[0] = i;
		for (int j = 1; j <= columns; j++) {
			int best = diagonal +
				(tolower((unsigned char)a[i - 1]) !=
					tolower((unsigned char)b[j - 1]));

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

void options_log_unknown(const struct log *log,
	const struct options_unknown *unknown, const char *const *names)
{
	const char *word = unknown->word;
	const char *closest = options_closest(word + strspn(word, "-"), names);

	if (closest) {
		log_error(log, "%s%s: there is no such %s: did you mean %s%s?",
			unknown->option, word, unknown->what, unknown->prefix,
			closest);
	} else {
		log_error(log, "%s%s: there is no such %s: %s", unknown->option,
			word, unknown->what, unknown->hint);
	}
}

/*
 * Finds an option by its letter or, if that is 0, by its name of length bytes.
 * Prefers an option of this command to one of other commands. Returns NULL if
 * there is none.
 */
static const struct option_entry *find_entry(
	enum command_bit command, char letter, const char *name, size_t length)
{
	const struct option_entry *found = NULL;

	for (size_t i = 0; option_entries[i].name; i++) {
		const struct option_entry *entry = &option_entries[i];
		bool named = letter ? entry->letter == letter
				    : strlen(entry->name) == length &&
				strncmp(entry->name, name, length) == 0;

		if (named && (!found || (entry->commands & (int)command))) {
			found = entry;
		}
	}
	return found;
}

static int refuse_unknown(const char *word, size_t length,
	enum command_bit command, const struct log *log)
{
	const char *names[OPTIONS_MAX];
	char bare[64];
	int count = options_names(command, names, OPTIONS_MAX - 1);

	names[count] = NULL;
	snprintf(bare, sizeof(bare), "%.*s", (int)length, word);
	options_log_unknown(log,
		&(struct options_unknown){
			"", bare, "option", "--", "--help lists the options"},
		names);
	return -EINVAL;
}

static bool set_int(
	const struct option_entry *entry, const char *value, int *out)
{
	char *end;
	long number;

	errno = 0;
	number = strtol(value, &end, 10);
	if (errno || end == value || *end || (double)number < entry->low ||
		(double)number > entry->high) {
		return false;
	}
	*out = (int)number;
	return true;
}

static bool set_double(
	const struct option_entry *entry, const char *value, double *out)
{
	char *end;

	*out = strtod(value, &end);
	return end != value && !*end && *out >= entry->low &&
		*out <= entry->high;
}

static bool set_float(
	const struct option_entry *entry, const char *value, float *out)
{
	double number;
	bool valid = set_double(entry, value, &number);

	*out = (float)number;
	return valid;
}

/*
 * Stores the value, which a switch ignores. Returns whether the value is valid.
 */
static bool set_entry(const struct option_entry *entry, struct options *options,
	const char *value)
{
	void *member = (char *)options + entry->member;

	switch (entry->kind) {
	case OPTION_SWITCH:
		*(bool *)member = true;
		return true;
	case OPTION_INT:
		return set_int(entry, value, member);
	case OPTION_FLOAT:
		return set_float(entry, value, member);
	case OPTION_DOUBLE:
		return set_double(entry, value, member);
	case OPTION_PARSED:
		return entry->set(options, value);
	default:
		*(const char **)member = value;
		/* Linux opens no file with a longer name. */
		return value[0] != '\0' && strlen(value) < PATH_MAX;
	}
}

/* Sets a switch by "yes" or "no"; returns false for other values. */
static bool set_switch(const struct option_entry *entry,
	struct options *options, const char *value)
{
	bool *member = (bool *)((char *)options + entry->member);

	*member = strcmp(value, "yes") == 0;
	return *member || strcmp(value, "no") == 0;
}

static const struct option_entry *find_word(
	enum command_bit command, const char *word, size_t length)
{
	return word[1] == '-'
		? find_entry(command, 0, word + 2, length - 2)
		: find_entry(command, length == 2 ? word[1] : '?', NULL, 0);
}

/* Whether the word after an option is its value and not the next option. */
static bool is_value(enum command_bit command, const char *word)
{
	return word[0] != '-' || !word[1] ||
		!find_word(command, word, strlen(word));
}

/*
 * Reads the option at argv[*at]; moves *at to its value if argv[*at + 1] is it.
 */
static int parse_option(struct options *options, enum command_bit command,
	int argc, char **argv, int *at, const struct log *log)
{
	const char *word = argv[*at];
	const char *equals = strchr(word, '=');
	size_t length = equals ? (size_t)(equals - word) : strlen(word);
	const struct option_entry *entry = find_word(command, word, length);
	const char *value = equals ? equals + 1 : NULL;

	if (!entry) {
		return refuse_unknown(word, length, command, log);
	}
	if (!(entry->commands & (int)command)) {
		log_error(log,
			"%.*s: this is not an option of this command: --help lists its options",
			(int)length, word);
		return -EINVAL;
	}
	if (entry->value && !value && *at + 1 < argc &&
		is_value(command, argv[*at + 1])) {
		value = argv[++*at];
	}
	if (entry->value && !value) {
		log_error(log, "--%s: its value is missing: give %s",
			entry->name, entry->expected);
		return -EINVAL;
	}
	if (!entry->value && value) {
		log_error(log, "--%s: this option takes no value: leave out %s",
			entry->name, equals);
		return -EINVAL;
	}
	if (!set_entry(entry, options, value)) {
		log_error(log, "--%s %s: give %s", entry->name, value,
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
				"%s: limber takes one model: leave out this one or %s",
				argv[i], options->model_path);
			return -EINVAL;
		} else if (!argv[i][0]) {
			log_error(log,
				"MODEL: its name is empty: give the name of a file");
			return -EINVAL;
		} else {
			options->model_path = argv[i];
		}
	}
	return 0;
}

bool options_takes(enum command_bit command, const char *name)
{
	const struct option_entry *entry =
		find_entry(command, 0, name, strlen(name));

	return entry && (entry->commands & (int)command);
}

int options_names(enum command_bit command, const char **names, int capacity)
{
	int count = 0;

	for (size_t i = 0; option_entries[i].name && count < capacity; i++) {
		if (option_entries[i].commands & (int)command) {
			names[count++] = option_entries[i].name;
		}
	}
	return count;
}

int options_set(struct options *options, enum command_bit command,
	const char *name, const char *value, const struct log *log)
{
	const struct option_entry *entry =
		find_entry(command, 0, name, strlen(name));
	struct options tried = *options;
	bool good;

	if (!entry) {
		log_error(log,
			"%s: there is no such option: limber play --help lists the options",
			name);
		return -EINVAL;
	}
	if (entry->value) {
		good = set_entry(entry, &tried, value);
	} else {
		good = set_switch(entry, &tried, value);
	}
	if (!good) {
		log_error(log, "%s = %s: give %s", name, value,
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
