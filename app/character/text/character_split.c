#include "app/character/text/character_split.h"

#include <errno.h>
#include <string.h>

static const char blanks[] = " \t\r\n";

static char *copy(struct arena *arena, const char *from, size_t length)
{
	char *text = ARENA_ARRAY(arena, char, length + 1);

	if (text) {
		memcpy(text, from, length);
	}
	return text;
}

int character_split(const char *value, struct arena *arena,
	struct character_word word[CHARACTER_WORDS_MAX])
{
	int count = 0;

	for (value += strspn(value, blanks); *value;
		value += strspn(value, blanks)) {
		bool quoted = *value == '"';
		size_t length;

		if (count == CHARACTER_WORDS_MAX) {
			return -EFBIG;
		}
		value += quoted;
		length = quoted         ? strcspn(value, "\"")
			: *value == ',' ? 1
					: strcspn(value, " \t\r\n,\"");
		if (quoted && !value[length]) {
			return -EINVAL;
		}
		word[count].quoted = quoted;
		word[count].text = copy(arena, value, length);
		if (!word[count++].text) {
			return -ENOMEM;
		}
		value += length + quoted;
	}
	return count;
}
