#include "app/demo/preset_file.h"

#include "app/model/model_file.h"
#include "platform/base/file.h"
#include "platform/base/output_file.h"

#include <stdio.h>
#include <string.h>

const char preset_file_asset[] = "presets.ini";

const struct preset_field preset_fields[PRESET_FIELDS] = {
	{"speed", "speed", 0, 1.0f, 0.0f, 200.0f},
	{"amplitude", "amplitude", 0, 0.02f, 0.0f, 4.0f},
	{"attenuation", "attenuation", 0, 0.05f, -2.0f, 2.0f},
	{"modifier", "modifier", 0, 0.1f, 0.0f, 4.0f},
	{"shift x", "translation", 0, 0.1f, -20.0f, 20.0f},
	{"shift y", "translation", 1, 0.1f, -20.0f, 20.0f},
	{"shift z", "translation", 2, 0.1f, -20.0f, 20.0f},
	{"turn x", "rotation", 0, 0.02f, -3.0f, 3.0f},
	{"turn y", "rotation", 1, 0.02f, -3.0f, 3.0f},
	{"turn z", "rotation", 2, 0.02f, -3.0f, 3.0f},
};

float *preset_value(
	struct procedural_preset *preset, const struct preset_field *field)
{
	for (int i = 0; i < PROCEDURAL_FIELDS; i++) {
		if (strcmp(procedural_fields[i].key, field->key) == 0) {
			char *at = (char *)preset + procedural_fields[i].offset;

			return (float *)at + field->element;
		}
	}
	return NULL;
}

int preset_file_read(struct preset_file *file, const struct log *log)
{
	struct model_file text;
	int count;

	file->preset[0] = procedural_preset_default();
	file->preset[0].unit = 0.01f;
	file->count = 1;
	file->path[0] = '\0';
	if (file_find_asset(preset_file_asset, log, file->path,
		    sizeof(file->path)) != 0) {
		file->path[0] = '\0';
		return 0;
	}
	count = model_file_read(file->path, NULL, log, &text);
	if (count < 0) {
		return count;
	}
	count = procedural_presets_parse((const char *)text.data, file->path,
		log, file->preset, PRESETS_MAX);
	model_file_release(&text);
	file->count = count > 0 ? count : file->count;
	return count < 0 ? count : 0;
}

struct line {
	const char *at;
	size_t length;       /* without the newline */
	const char *comment; /* or the line's end */
	bool section;        /* begins a section */
};

static struct line read_line(const char *text)
{
	struct line line = {.at = text, .length = strcspn(text, "\n")};
	size_t blank = strspn(text, " \t");

	line.comment = text + strcspn(text, ";#\n");
	line.section = text[blank] == '[';
	return line;
}

static bool names(const struct line *line, const char *word)
{
	const char *at = line->at + strspn(line->at, " \t[");
	size_t length = strlen(word);

	return strncmp(at, word, length) == 0 &&
		strchr(" \t=]", at[length]) != NULL && at[length] != '\0';
}

static const float *values_of(const struct procedural_preset *preset, int key)
{
	return (const float *)(const void *)((const char *)preset +
		procedural_fields[key].offset);
}

static void write_values(
	FILE *out, const struct procedural_preset *preset, int key)
{
	const float *value = values_of(preset, key);

	fprintf(out, "%s =", procedural_fields[key].key);
	for (int i = 0; i < procedural_fields[key].count; i++) {
		fprintf(out, " %.6g", (double)value[i]);
	}
}

/* Writes the values that the section lacks and that are not the default. */
static void write_rest(FILE *out, const struct procedural_preset *preset,
	const bool written[PROCEDURAL_FIELDS])
{
	const struct procedural_preset plain = procedural_preset_default();

	for (int key = 0; key < PROCEDURAL_FIELDS; key++) {
		size_t size =
			(size_t)procedural_fields[key].count * sizeof(float);

		if (!written[key] &&
			memcmp(values_of(preset, key), values_of(&plain, key),
				size) != 0) {
			write_values(out, preset, key);
			fputc('\n', out);
		}
	}
}

/* The index of the key that the line sets, else PROCEDURAL_FIELDS. */
static int find_key(const struct line *line)
{
	int key = 0;

	while (key < PROCEDURAL_FIELDS &&
		!names(line, procedural_fields[key].key)) {
		key++;
	}
	return key;
}

static void write_line(FILE *out, const struct line *line,
	const struct procedural_preset *preset, bool written[PROCEDURAL_FIELDS])
{
	int key = find_key(line);

	if (key == PROCEDURAL_FIELDS) {
		fprintf(out, "%.*s\n", (int)line->length, line->at);
		return;
	}
	written[key] = true;
	write_values(out, preset, key);
	if (line->comment < line->at + line->length) {
		fprintf(out, " %.*s",
			(int)(line->at + line->length - line->comment),
			line->comment);
	}
	fputc('\n', out);
}

/* Blank lines and comments before a section belong to that section. */
static bool ends_section(const char *text)
{
	while (*text) {
		struct line line = read_line(text);
		size_t blank = strspn(text, " \t\r");

		if (line.section) {
			return true;
		}
		if (blank < line.length && strchr(";#", text[blank]) == NULL) {
			return false;
		}
		text += line.length + (text[line.length] == '\n');
	}
	return true;
}

static void rewrite(
	FILE *out, const char *text, const struct procedural_preset *preset)
{
	bool written[PROCEDURAL_FIELDS] = {false};
	bool within = false, found = false;

	while (*text) {
		struct line line = read_line(text);

		if (within && ends_section(text)) {
			write_rest(out, preset, written);
			within = false;
		}
		if (line.section && !found && names(&line, preset->name)) {
			within = found = true;
		}
		if (within) {
			write_line(out, &line, preset, written);
		} else {
			fprintf(out, "%.*s\n", (int)line.length, line.at);
		}
		text += line.length + (text[line.length] == '\n');
	}
	if (!found) {
		fprintf(out, "\n[%s]\n", preset->name);
	}
	if (within || !found) {
		write_rest(out, preset, written);
	}
}

int preset_file_save(const char *path, const struct procedural_preset *preset,
	const struct log *log)
{
	struct model_file text;
	struct output_file *file;
	int error = model_file_read(path, NULL, log, &text);

	if (error) {
		return error;
	}
	error = output_file_create(path, log, &file);
	if (!error) {
		rewrite(output_file_stream(file), (const char *)text.data,
			preset);
		error = output_file_commit(file);
	}
	model_file_release(&text);
	return error;
}
