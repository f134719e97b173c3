/*
 * The words of a value.
 */
#ifndef APP_CHARACTER_TEXT_CHARACTER_SPLIT_H
#define APP_CHARACTER_TEXT_CHARACTER_SPLIT_H

#include "app/character/text/character_text.h"

/*
 * Divides a value at blanks and commas; a comma is a word of its own. Text in
 * double quotes is one word. Copies the words into the arena. Returns their
 * number, -EINVAL for a quotation mark without its second one, -EFBIG for more
 * than CHARACTER_WORDS_MAX words, or -ENOMEM.
 */
int character_split(const char *value, struct arena *arena,
	struct character_word word[CHARACTER_WORDS_MAX]);

#endif
