/*
 * The lines of a file in INI format, checked before libinih reads them: it
 * would skip lines that are not valid, leave out words behind a section's name,
 * and take an indented line for a continuation of the one above.
 */
#ifndef LIMBER_CHARACTER_INI_LINES_H
#define LIMBER_CHARACTER_INI_LINES_H

#include <stdio.h>

#define INI_LINES_INVALID \
	"this line is not valid: write [SECTION], KEY = VALUE or ; COMMENT"

struct ini_lines {
	FILE *file;             /* the caller's */
	const char *separators; /* one of them follows a key: "=" or "=:" */
	int most;   /* lines of the file: a pipe or a device may never end */
	int number; /* of the last line, from 1 */
	char refusal[96]; /* why that line was refused; or empty */
};

/*
 * Reads the next line without its indentation and without a byte order mark,
 * with which some editors begin a file. Returns line, of size bytes, or NULL at
 * the end of the file, if it cannot be read, or if the line is refused.
 */
char *ini_lines_next(struct ini_lines *lines, char *line, int size);

#endif
