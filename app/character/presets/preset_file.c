#include "app/character/presets/preset_file.h"

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

int preset_file_load(
	struct preset_file *file, const char *path, const struct log *log)
{
	struct model_file text;
	int error = model_file_read(path, NULL, log, &text);
	int count;

	if (error) {
		return error;
	}
	count = procedural_presets_parse(
		(const char *)text.data, path, log, file->preset, PRESETS_MAX);
	model_file_release(&text);
	if (count < 0) {
		file->count = 0;
		return count;
	}
	file->count = count;
	return 0;
}

int preset_file_find(struct preset_file *file, const struct log *log)
{
	if (file_find_asset(preset_file_asset, log, file->path,
		    sizeof(file->path)) == 0) {
		int error = preset_file_load(file, file->path, log);

		if (error) {
			return error;
		}
	} else {
		file->path[0] = '\0';
		file->count = 0;
	}
	if (file->count == 0) {
		file->preset[0] = procedural_preset_default();
		file->preset[0].unit = 0.01f;
		file->count = 1;
	}
	return 0;
}

/* Returns the beginning of the next line. */
static const char *after_line(const char *text)
{
	text += strcspn(text, "\n");
	return text + (*text == '\n');
}

/* Returns true if the name follows the line's blanks and brackets, and then end. */
static bool names(const char *line, const char *name, char end)
{
	const char *at = line + strspn(line, " \t[");
	size_t length = strlen(name);

	if (strncmp(at, name, length) != 0) {
		return false;
	}
	at += length;
	return at[strspn(at, " \t")] == end;
}

static char first_of(const char *line)
{
	return line[strspn(line, " \t\r")];
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

/* Returns the index of the key that the line sets, or PROCEDURAL_FIELDS. */
static int find_key(const char *line)
{
	int key = 0;

	while (key < PROCEDURAL_FIELDS &&
		!names(line, procedural_fields[key].key, '=')) {
		key++;
	}
	return key;
}

static void write_line(FILE *out, const char *line,
	const struct procedural_preset *preset, bool written[PROCEDURAL_FIELDS])
{
	int key = find_key(line);
	size_t setting = strcspn(line, ";#\n");
	int rest = (int)(strcspn(line, "\n") - setting);

	if (key == PROCEDURAL_FIELDS) {
		fprintf(out, "%.*s", (int)strcspn(line, "\n"), line);
	} else {
		written[key] = true;
		write_values(out, preset, key);
		fprintf(out, rest > 0 ? " %.*s" : "%.*s", rest, line + setting);
	}
	fputc('\n', out);
}

/* Returns the heading of the preset's section, or the text's end. */
static const char *find_section(const char *text, const char *name)
{
	while (*text && !(first_of(text) == '[' && names(text, name, ']'))) {
		text = after_line(text);
	}
	return text;
}

/* Returns the end of the section's last setting; later comments are not its. */
static const char *find_end(const char *section)
{
	const char *end = section;

	for (const char *line = section; *line && first_of(line) != '[';
		line = after_line(line)) {
		if (strchr(";#\n", first_of(line)) == NULL) {
			end = after_line(line);
		}
	}
	return end;
}

static void rewrite(
	FILE *out, const char *text, const struct procedural_preset *preset)
{
	bool written[PROCEDURAL_FIELDS] = {false};
	const char *section = find_section(text, preset->name);
	const char *first = after_line(section), *end = find_end(first);

	fprintf(out, "%.*s", (int)(first - text), text);
	if (first > text && first[-1] != '\n') {
		fputc('\n', out);
	}
	if (!*section) {
		fprintf(out, "\n[%s]\n", preset->name);
	}
	for (const char *line = first; line < end; line = after_line(line)) {
		write_line(out, line, preset, written);
	}
	write_rest(out, preset, written);
	fputs(end, out);
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
	error = output_file_edit(NULL, path, log, &file);
	if (!error) {
		rewrite(output_file_stream(file), (const char *)text.data,
			preset);
		error = output_file_commit(file);
	}
	model_file_release(&text);
	return error;
}
