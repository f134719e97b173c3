#include "app/character/text/ini_lines.h"

#include <stdbool.h>
#include <string.h>

/* Returns NULL or why the line is not valid. */
static const char *find_mistake(const char *line, const char *separators)
{
	const char *end;

	if (*line != '[') {
		return strchr(";#\r\n", *line) || strpbrk(line, separators)
			? NULL
			: INI_LINES_INVALID;
	}
	end = strchr(line, ']');
	if (!end) {
		return "a ] is missing";
	}
	end += 1 + strspn(end + 1, " \t\r\n");
	return *end == '\0' || *end == ';'
		? NULL
		: "a section ends with its ]: begin a line below, or a comment with ;";
}

/* Whether a file begins as editors of Windows may save it. */
static bool is_utf_16(const char *line)
{
	return strncmp(line, "\xFF\xFE", 2) == 0 ||
		strncmp(line, "\xFE\xFF", 2) == 0;
}

char *ini_lines_next(struct ini_lines *lines, char *line, int size)
{
	const char *mistake;
	size_t length, blank;

	lines->refusal[0] = '\0';
	if (!fgets(line, size, lines->file)) {
		return NULL;
	}
	lines->number++;
	if (lines->number == 1 && is_utf_16(line)) {
		snprintf(lines->refusal, sizeof(lines->refusal),
			"this text is in UTF-16: save the file as UTF-8");
		return NULL;
	}
	length = strlen(line);
	/* A line with zero bytes seems to have no end, too. */
	if ((length == 0 || line[length - 1] != '\n') && !feof(lines->file)) {
		snprintf(lines->refusal, sizeof(lines->refusal),
			"this line has more than %d characters or is no text: make it shorter",
			size - 2);
		return NULL;
	}
	if (lines->number > lines->most) {
		snprintf(lines->refusal, sizeof(lines->refusal),
			"the file has more than %d lines", lines->most);
		return NULL;
	}
	blank = lines->number == 1 && strncmp(line, "\xEF\xBB\xBF", 3) == 0 ? 3
									    : 0;
	blank += strspn(line + blank, " \t");
	memmove(line, line + blank, length + 1 - blank);
	mistake = find_mistake(line, lines->separators);
	if (mistake) {
		snprintf(lines->refusal, sizeof(lines->refusal), "%s", mistake);
		return NULL;
	}
	return line;
}
