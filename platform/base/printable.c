#include "platform/base/printable.h"

#include <stdbool.h>
#include <string.h>

/*
 * Whether the character is a line or paragraph separator (U+2028, U+2029) or
 * changes the direction of writing.
 */
static bool is_invisible(const unsigned char *text)
{
	return text[0] == 0xE2 &&
		((text[1] == 0x80 && text[2] >= 0xA8 && text[2] <= 0xAE) ||
			(text[1] == 0x81 && text[2] >= 0xA6 && text[2] <= 0xA9));
}

/*
 * The bytes of the UTF-8 character that text begins with; 0 if it is invalid or
 * must not be printed.
 */
static int character_length(const char *text)
{
	unsigned char first = (unsigned char)text[0];
	int length = first < 0x80 ? 1
		: first >= 0xF0   ? 4
		: first >= 0xE0   ? 3
				  : 2;

	if (first < ' ' || first == 0x7F || (first >= 0x80 && first < 0xC2) ||
		first > 0xF4) {
		return 0;
	}
	/* C1 controls, overlong encodings, surrogates, beyond U+10FFFF. */
	if ((first == 0xC2 && (unsigned char)text[1] < 0xA0) ||
		(first == 0xE0 && (unsigned char)text[1] < 0xA0) ||
		(first == 0xED && (unsigned char)text[1] > 0x9F) ||
		(first == 0xF0 && (unsigned char)text[1] < 0x90) ||
		(first == 0xF4 && (unsigned char)text[1] > 0x8F)) {
		return 0;
	}
	for (int i = 1; i < length; i++) {
		if (((unsigned char)text[i] & 0xC0) != 0x80) {
			return 0;
		}
	}
	return is_invisible((const unsigned char *)text) ? 0 : length;
}

void printable_make(char *text)
{
	while (*text) {
		int length = character_length(text);

		if (length == 0) {
			*text++ = '?';
		}
		text += length;
	}
}

static void put(const char *text, bool in_comment, FILE *out)
{
	char last = '\0';

	while (*text) {
		int length = character_length(text);
		bool ends = in_comment &&
			((last == '*' && *text == '/') ||
				(last == '/' && *text == '*'));

		if (length == 0 || ends) {
			fputc('?', out);
			length = 1;
		} else {
			fwrite(text, 1, (size_t)length, out);
		}
		last = ends ? '?' : *text;
		text += length;
	}
}

void printable_put(const char *text, FILE *out)
{
	put(text, false, out);
}

void printable_put_comment(const char *text, FILE *out)
{
	put(text, true, out);
}
