#include "app/anim/procedural/procedural.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>

const struct procedural_field procedural_fields[PROCEDURAL_FIELDS] = {
	{"speed", offsetof(struct procedural_preset, speed), 1},
	{"amplitude", offsetof(struct procedural_preset, amplitude), 1},
	{"attenuation", offsetof(struct procedural_preset, attenuation), 1},
	{"translation", offsetof(struct procedural_preset, translation), 3},
	{"rotation", offsetof(struct procedural_preset, rotation), 3},
	{"modifier", offsetof(struct procedural_preset, modifier), 1},
	{"unit", offsetof(struct procedural_preset, unit), 1},
};

/* A part of the text, without blanks around it. */
struct piece {
	const char *at;
	size_t length;
};

static bool is_blank(char c)
{
	return c == ' ' || c == '\t' || c == '\r';
}

static struct piece trim(const char *at, const char *end)
{
	while (at < end && is_blank(*at)) {
		at++;
	}
	while (end > at && is_blank(end[-1])) {
		end--;
	}
	return (struct piece){at, (size_t)(end - at)};
}

static bool equals(struct piece piece, const char *text)
{
	return piece.length == strlen(text) &&
		memcmp(piece.at, text, piece.length) == 0;
}

/*
 * Reads exactly count numbers. Returns false if there are more, fewer, or one
 * is not within -1e6..1e6.
 */
static bool read_numbers(struct piece piece, float *out, int count)
{
	const char *at = piece.at;
	const char *end = piece.at + piece.length;

	for (int i = 0; i < count; i++) {
		char *after;

		out[i] = strtof(at, &after);
		/*
		 * strtof skips blanks and line ends, so it may have read a
		 * number from the next line.
		 */
		if (after == at || after > end ||
			!(out[i] > -1e6f && out[i] < 1e6f)) {
			return false;
		}
		at = after;
	}
	return at == end;
}

/* Returns NULL, or the text of an error. */
static const char *set_field(
	struct procedural_preset *preset, struct piece key, struct piece value)
{
	for (int i = 0; i < PROCEDURAL_FIELDS; i++) {
		const struct procedural_field *field = &procedural_fields[i];

		if (!equals(key, field->key)) {
			continue;
		}
		if (read_numbers(value, (float *)((char *)preset + field->offset),
			    field->count)) {
			return NULL;
		}
		return field->count == 1 ? "this key takes one number"
					 : "this key takes three numbers";
	}
	return "unknown key; the keys are speed, amplitude, attenuation, translation, rotation, modifier and unit";
}

static const char *begin_preset(
	struct procedural_preset *preset, struct piece line)
{
	struct piece name = {line.at, 0};

	if (line.length < 2 || line.at[line.length - 1] != ']') {
		return "a section must look like [name]";
	}
	name = trim(line.at + 1, line.at + line.length - 1);
	if (name.length == 0 || name.length >= sizeof(preset->name)) {
		return "a name must have 1 to 31 characters";
	}
	*preset = procedural_preset_default();
	memset(preset->name, 0, sizeof(preset->name));
	memcpy(preset->name, name.at, name.length);
	return NULL;
}

/* Returns the line that begins at text, without its comment. */
static struct piece cut_line(const char *text)
{
	size_t length = strcspn(text, "\n");
	size_t setting = strcspn(text, ";#\n");

	return trim(text, text + (setting < length ? setting : length));
}

static const char *read_setting(
	struct procedural_preset *preset, struct piece line)
{
	const char *equal = memchr(line.at, '=', line.length);
	const char *end = line.at + line.length;

	if (!preset) {
		return "a setting must follow a [name]";
	}
	if (!equal) {
		return "a setting must look like key = value";
	}
	return set_field(preset, trim(line.at, equal), trim(equal + 1, end));
}

int procedural_presets_parse(const char *text, const char *path,
	const struct log *log, struct procedural_preset *preset, int capacity)
{
	int count = 0;

	for (int number = 1; *text; number++) {
		struct piece line = cut_line(text);
		const char *wrong = NULL;

		if (line.length && *line.at == '[') {
			if (count == capacity) {
				log_error(log,
					"%s:%d: a file can have at most %d presets",
					path, number, capacity);
				return -ENOSPC;
			}
			wrong = begin_preset(&preset[count++], line);
		} else if (line.length) {
			wrong = read_setting(
				count ? &preset[count - 1] : NULL, line);
		}
		if (wrong) {
			log_error(log, "%s:%d: %s", path, number, wrong);
			return -EINVAL;
		}
		text += strcspn(text, "\n");
		text += *text == '\n';
	}
	return count;
}
