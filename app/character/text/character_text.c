#include "app/character/text/character_text.h"

#include "app/character/text/character_split.h"
#include "app/character/text/ini_lines.h"
#include "platform/base/file.h"
#include "platform/base/memory_budget.h"

#include <errno.h>
#include <ini.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
	HEADING_BYTES = 50 /* libinih's limit of a section's name */
};

struct reader {
	struct character_text *text;
	struct character_section *section;
	struct ini_lines lines;
	const char *path;
	int error;
	bool may_include;
	const struct log *log;
};

static int read_file(struct character_text *text, FILE *file, const char *path,
	bool may_include, const struct log *log);

static int fail(const struct reader *reader, const char *sentence)
{
	log_error(reader->log, "%s:%d: %s", reader->path, reader->lines.number,
		sentence);
	return -EINVAL;
}

static int fail_memory(const struct reader *reader)
{
	return memory_budget_fail(
		reader->text->arena->budget, reader->path, reader->log);
}

static struct character_section *find_section(const struct character_text *text,
	const char *kind, const char *name, const char *other)
{
	struct character_section *section = text->first;

	while (section &&
		(strcmp(section->kind, kind) != 0 ||
			strcmp(section->name, name) != 0 ||
			strcmp(section->other, other) != 0)) {
		section = section->next;
	}
	return section;
}

/* Appends a section; word is its kind and two names, which may be empty. */
static int add_section(struct reader *reader, const char *heading,
	const struct character_word word[3])
{
	struct character_text *text = reader->text;
	struct character_section *section =
		ARENA_NEW(text->arena, struct character_section);

	if (!section) {
		return fail_memory(reader);
	}
	*section = (struct character_section){
		.file = reader->path,
		.number = reader->lines.number,
		.heading = arena_strdup(text->arena, heading),
		.kind = word[0].text,
		.name = word[1].text,
		.other = word[2].text,
	};
	if (!section->heading) {
		return fail_memory(reader);
	}
	if (text->last) {
		text->last->next = section;
	} else {
		text->first = section;
	}
	text->last = reader->section = section;
	return 0;
}

/* Begins the section "[KIND NAME OTHER]", or goes on with it. */
static int begin_section(struct reader *reader, const char *line)
{
	struct character_text *text = reader->text;
	struct character_word word[CHARACTER_WORDS_MAX];
	size_t length = strcspn(line + 1, "]");
	char heading[HEADING_BYTES];
	int count;

	if (length >= HEADING_BYTES) {
		return fail(reader,
			"the name of this section has more than 49 characters: make it shorter");
	}
	memcpy(heading, line + 1, length);
	heading[length] = '\0';
	count = character_split(heading, text->arena, word);
	if (count == -ENOMEM) {
		return fail_memory(reader);
	}
	if (count < 1 || count > 3) {
		return fail(reader,
			"this is no section: write [KIND], [KIND NAME] or [KIND NAME OTHER], with names of several words in quotes");
	}
	for (int i = count; i < 3; i++) {
		word[i].text = "";
	}
	reader->section =
		find_section(text, word[0].text, word[1].text, word[2].text);
	return reader->section ? 0 : add_section(reader, heading, word);
}

/* Includes a file that lies in the folder of the one that names it. */
static int include(struct reader *reader, const char *name)
{
	char path[PATH_MAX];
	FILE *file;
	int error;

	if (!reader->may_include) {
		return fail(
			reader, "include: a file is needed to include another");
	}
	if (!character_text_path_near(reader->path, name, path, sizeof(path))) {
		return fail(reader,
			"include: give the name of a file in the same folder, without a path, such as biped.character");
	}
	if (reader->text->file_count == CHARACTER_FILES_MAX) {
		log_error(reader->log,
			"%s:%d: include: a character may have at most %d files, and none may include itself",
			reader->path, reader->lines.number, CHARACTER_FILES_MAX);
		return -EINVAL;
	}
	file = file_open(path);
	if (!file) {
		error = -errno;
		log_error(reader->log, "%s:%d: include: %s cannot be read: %s%s",
			reader->path, reader->lines.number, path,
			strerror(-error), file_open_advice(-error));
		return error;
	}
	error = read_file(reader->text, file, path, true, reader->log);
	fclose(file);
	return error;
}

/* Appends a line to the section. */
static int append_line(struct reader *reader, const char *key,
	const struct character_word *word, int count)
{
	struct arena *arena = reader->text->arena;
	struct character_section *section = reader->section;
	struct character_line *line = ARENA_NEW(arena, struct character_line);

	if (!line) {
		return fail_memory(reader);
	}
	*line = (struct character_line){
		.file = reader->path,
		.number = reader->lines.number,
		.section = section->heading,
		.key = arena_strdup(arena, key),
		.word_count = count,
		.word = ARENA_ARRAY(arena, struct character_word, (size_t)count),
	};
	if (!line->key || !line->word) {
		return fail_memory(reader);
	}
	memcpy(line->word, word, (size_t)count * sizeof(*word));
	if (section->last) {
		section->last->next = line;
	} else {
		section->first = line;
	}
	section->last = line;
	return 0;
}

static int read_line(struct reader *reader, const char *key, const char *value)
{
	struct character_text *text = reader->text;
	struct character_word word[CHARACTER_WORDS_MAX];
	int count = character_split(value, text->arena, word);

	if (count < 0) {
		return count == -ENOMEM
			? fail_memory(reader)
			: fail(reader,
				  count == -EFBIG
					  ? "this line has more than 64 words: divide it"
					  : "a quotation mark is missing at the end of a name");
	}
	if (strcmp(key, "include") == 0 &&
		(!reader->section ||
			strcmp(reader->section->kind, "character") == 0)) {
		/* A name with blanks may stand in quotes. */
		return include(reader,
			count == 1 && word[0].quoted ? word[0].text : value);
	}
	if (!reader->section) {
		return fail(reader,
			"this line comes before any [section]: write its section above it");
	}
	if (++text->line_count > CHARACTER_LINES_MAX) {
		return fail(reader, "the character has more than 8000 lines");
	}
	return append_line(reader, key, word, count);
}

static int take(
	void *user, const char *section, const char *key, const char *value)
{
	struct reader *reader = user;

	/* next_line() begins sections, also those without lines */
	(void)section;
	if (!reader->error) {
		reader->error = read_line(reader, key, value);
	}
	return !reader->error;
}

/* Reads a line for libinih. A heading begins a section. */
static char *next_line(char *line, int size, void *user)
{
	struct reader *reader = user;

	if (reader->error) {
		return NULL;
	}
	if (!ini_lines_next(&reader->lines, line, size)) {
		reader->error = *reader->lines.refusal
			? fail(reader, reader->lines.refusal)
			: 0;
		return NULL;
	}
	reader->error = *line == '[' ? begin_section(reader, line) : 0;
	return reader->error ? NULL : line;
}

static int read_file(struct character_text *text, FILE *file, const char *path,
	bool may_include, const struct log *log)
{
	struct reader reader = {.text = text,
		.lines = {.file = file,
			.separators = "=",
			.most = CHARACTER_LINES_MAX},
		.path = arena_strdup(text->arena, path),
		.may_include = may_include,
		.log = log};
	int line;

	if (!reader.path) {
		reader.path = path;
		return fail_memory(&reader);
	}
	text->file[text->file_count++] = reader.path;
	line = ini_parse_stream(next_line, &reader, take, &reader);
	if (reader.error) {
		return reader.error;
	}
	if (ferror(file)) {
		log_error(log, "%s: cannot be read", path);
		return -EIO;
	}
	if (line) {
		reader.lines.number = line;
		return fail(&reader, INI_LINES_INVALID);
	}
	return 0;
}

int character_text_load(struct character_text *text, struct arena *arena,
	const char *path, const struct log *log)
{
	FILE *file = file_open_logged(path, log);
	int error;

	*text = (struct character_text){.arena = arena, .is_file = true};
	if (!file) {
		return -errno;
	}
	error = read_file(text, file, path, true, log);
	fclose(file);
	return error;
}

int character_text_read(struct character_text *text, struct arena *arena,
	FILE *file, const char *path, bool may_include, const struct log *log)
{
	*text = (struct character_text){.arena = arena};
	return read_file(text, file, path, may_include, log);
}

const struct character_section *character_text_find(
	const struct character_section *section, const char *kind)
{
	while (section && strcmp(section->kind, kind) != 0) {
		section = section->next;
	}
	return section;
}

int character_text_count(const struct character_text *text, const char *kind)
{
	const struct character_section *section =
		character_text_find(text->first, kind);
	int count = 0;

	for (; section; section = character_text_find(section->next, kind)) {
		count++;
	}
	return count;
}

bool character_text_path_near(
	const char *file, const char *name, char *path, size_t size)
{
	const char *slash = strrchr(file, '/');
	int folder = slash ? (int)(slash - file) + 1 : 0;
	int length = snprintf(path, size, "%.*s%s", folder, file, name);

	return *name && !strpbrk(name, "/\\") && name[0] != '.' &&
		(size_t)length < size;
}

bool character_text_path_beside(const char *model_path, char *path, size_t size)
{
	const char *slash = strrchr(model_path, '/');
	const char *dot = strrchr(slash ? slash : model_path, '.');
	int stem = dot ? (int)(dot - model_path) : (int)strlen(model_path);
	int length = snprintf(path, size, "%.*s.character", stem, model_path);

	return (size_t)length < size;
}
