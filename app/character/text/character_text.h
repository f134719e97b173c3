/*
 * A character file as lines of words.
 *
 * A character file is an INI text: sections "[KIND NAME]" or "[KIND NAME
 * OTHER]", each with lines "KEY = VALUE". This module divides it into words
 * and follows includes. It knows no kinds and no keys: app/character/build
 * gives the words their meaning.
 */
#ifndef APP_CHARACTER_TEXT_CHARACTER_TEXT_H
#define APP_CHARACTER_TEXT_CHARACTER_TEXT_H

#include "platform/base/arena.h"
#include "platform/base/log.h"

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum {
	CHARACTER_LINES_MAX = 8000, /* in all files of a character */
	CHARACTER_WORDS_MAX = 64,   /* in a line */
	CHARACTER_FILES_MAX = 8     /* a file and those that it includes */
};

/* A word, or a comma by itself. In quotes a word may contain anything. */
struct character_word {
	const char *text;
	bool quoted;
};

/* One line "KEY = VALUE". */
struct character_line {
	const char *file;
	int number; /* from 1 */
	const char *section;
	const char *key;
	int word_count;
	struct character_word *word;
	struct character_line *next; /* in the section, or NULL */
};

/* The sections of one kind and name are one section. */
struct character_section {
	const char *file;
	int number;          /* of the line that begins it for the first time */
	const char *heading; /* as in the file, without brackets */
	const char *kind, *name, *other; /* "" where there is none */
	struct character_line *first, *last;
	struct character_section *next; /* in the order of the file, or NULL */
};

struct character_text {
	struct arena *arena; /* not owned; has all strings and lines */
	struct character_section *first, *last;
	int line_count;
	/* read from a path and not from a stream, so it may name other files */
	bool is_file;
	int file_count;
	/* paths; the first is that of the caller */
	const char *file[CHARACTER_FILES_MAX];
};

/*
 * Reads a character file from a stream; path stands in messages, and files
 * that it includes are looked for beside it if may_include is true. Returns 0,
 * or -errno after one error that names file and line.
 */
int character_text_read(struct character_text *text, struct arena *arena,
	FILE *file, const char *path, bool may_include, const struct log *log);

/* The same for the file at path. */
int character_text_load(struct character_text *text, struct arena *arena,
	const char *path, const struct log *log);

/* The first section of that kind from section on, or NULL. */
const struct character_section *character_text_find(
	const struct character_section *section, const char *kind);

/* The number of sections of that kind. */
int character_text_count(const struct character_text *text, const char *kind);

/*
 * Writes the path of a file in the folder of another one. Returns false if the
 * name is not that of a file in this folder, or if the path is too long.
 */
bool character_text_path_near(
	const char *file, const char *name, char *path, size_t size);

/*
 * Writes the path of the character file that lies beside a model,
 * "DIR/robot.character" for "DIR/robot.glb". False if it is too long.
 */
bool character_text_path_beside(const char *model_path, char *path, size_t size);

#endif
