/*
 * Buttons from a file with lines "TIME_MS BUTTON down|up". A # begins a
 * comment.
 */
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "platform/base/file.h"
#include "platform/buttons/buttons.h"

enum {
	LINE_BYTES = 512,
	LINES_MAX = 1000000 /* a pipe or a device may never end */
};

/* A hundred days, so that sums of times cannot overflow. */
#define TIME_MAX_MS INT64_C(8640000000)

struct button_source {
	struct button_event *event;
	int count, capacity;
	int next; /* the first event that has not been pushed */
};

/* The current line of the file, for messages. */
struct position {
	const char *path;
	int line;
	const struct log *log;
};

static void script_destroy(struct button_source *script)
{
	if (script) {
		free(script->event);
		free(script);
	}
}

static int append(struct button_source *script, struct button_event event,
	const struct position *at)
{
	if (script->count == script->capacity) {
		int capacity = script->capacity ? 2 * script->capacity : 64;
		struct button_event *grown = realloc(
			script->event, (size_t)capacity * sizeof(*grown));

		if (!grown) {
			log_error(at->log, "%s: out of memory", at->path);
			return -ENOMEM;
		}
		script->event = grown;
		script->capacity = capacity;
	}
	script->event[script->count++] = event;
	return 0;
}

static int read_time(const char *word, int64_t earliest_ms, int64_t *out,
	const struct position *at)
{
	char *end;
	long long value;

	errno = 0;
	value = strtoll(word, &end, 10);
	if (*end || end == word || errno || value < 0 || value > TIME_MAX_MS) {
		log_error(at->log,
			"%s:%d: \"%s\" is no time: give milliseconds as a whole number from 0 on",
			at->path, at->line, word);
		return -EINVAL;
	}
	if (value < earliest_ms) {
		log_error(at->log,
			"%s:%d: time %lld is before %lld of an earlier line: put the lines in order of time",
			at->path, at->line, value, (long long)earliest_ms);
		return -EINVAL;
	}
	*out = value;
	return 0;
}

static int read_button(
	const char *word, enum button *out, const struct position *at)
{
	*out = button_from_name(word);
	if (*out == BUTTON_COUNT) {
		log_error(at->log,
			"%s:%d: \"%s\" is no button: choose UP, DOWN, LEFT, RIGHT, ENTER, F6, F8, F9 or F10",
			at->path, at->line, word);
		return -EINVAL;
	}
	return 0;
}

static int read_state(const char *word, bool *out, const struct position *at)
{
	*out = strcmp(word, "down") == 0;
	if (!*out && strcmp(word, "up") != 0) {
		log_error(at->log, "%s:%d: \"%s\" is neither down nor up",
			at->path, at->line, word);
		return -EINVAL;
	}
	return 0;
}

static int read_line(
	struct button_source *script, char *line, const struct position *at)
{
	static const char space[] = " \t\r\n";
	int64_t earliest_ms =
		script->count ? script->event[script->count - 1].time_ms : 0;
	struct button_event event = {0};
	char *word[4];
	char *rest = line;
	int error;

	line[strcspn(line, "#")] = '\0';
	for (int i = 0; i < 4; i++) {
		word[i] = strtok_r(i ? NULL : line, space, &rest);
	}
	if (!word[0]) {
		return 0;
	}
	if (!word[2] || word[3]) {
		log_error(at->log,
			"%s:%d: a line must have the form TIME_MS BUTTON down|up",
			at->path, at->line);
		return -EINVAL;
	}
	error = read_time(word[0], earliest_ms, &event.time_ms, at);
	error = error ? error : read_button(word[1], &event.button, at);
	error = error ? error : read_state(word[2], &event.down, at);
	return error ? error : append(script, event, at);
}

/* Checks that a line has an end. One with zero bytes seems to have none. */
static int check_line(const char *line, FILE *file, const struct position *at)
{
	size_t length = strlen(line);

	if (at->line > LINES_MAX) {
		log_error(at->log, "%s: it has more than %d lines", at->path,
			LINES_MAX);
		return -EFBIG;
	}
	if ((length == 0 || line[length - 1] != '\n') && !feof(file)) {
		log_error(at->log,
			"%s:%d: this line has more than %d characters or is no text",
			at->path, at->line, LINE_BYTES - 2);
		return -EINVAL;
	}
	return 0;
}

static int read_file(
	struct button_source *script, FILE *file, struct position *at)
{
	char line[LINE_BYTES];
	int error = 0;

	while (!error && fgets(line, sizeof(line), file)) {
		at->line++;
		error = check_line(line, file, at);
		error = error ? error : read_line(script, line, at);
	}
	if (!error && ferror(file)) {
		error = -errno;
		log_error(at->log, "%s: cannot be read: %s", at->path,
			strerror(-error));
	}
	return error;
}

static int script_create(
	const char *argument, const struct log *log, struct button_source **out)
{
	struct position at = {.path = argument, .log = log};
	struct button_source *script = NULL;
	FILE *file;
	int error;

	if (!argument || !argument[0]) {
		log_error(log,
			"--buttons script: the file is missing: give script:FILE");
		return -EINVAL;
	}
	file = file_open_logged(argument, log);
	if (!file) {
		return -errno;
	}
	script = calloc(1, sizeof(*script));
	if (script) {
		error = read_file(script, file, &at);
	} else {
		error = -ENOMEM;
		log_error(log, "%s: out of memory", argument);
	}
	fclose(file);
	if (error) {
		script_destroy(script);
		return error;
	}
	*out = script;
	return 0;
}

static void script_poll(struct button_source *script, int64_t now_ms,
	struct button_queue *queue)
{
	while (script->next < script->count &&
		script->event[script->next].time_ms <= now_ms) {
		button_queue_push(queue, script->event[script->next++]);
	}
}

const struct button_driver button_driver_script = {
	.name = "script",
	.summary = "script:FILE, lines of TIME_MS BUTTON down|up",
	.exact = true,
	.create = script_create,
	.poll = script_poll,
	.destroy = script_destroy,
};
