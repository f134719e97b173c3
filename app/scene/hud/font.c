#include "app/scene/hud/font.h"

enum {
	REPLACEMENT = 0xFFFD
};

int font_find_glyph(const struct font *font, uint32_t code)
{
	int low = 1, high = font->glyph_count - 1;
	/* Most codes follow one another. */
	const uint32_t near = high > 0 ? code - font->code[1] + 1 : 0;

	if (near >= 1 && near <= (uint32_t)high && font->code[near] == code) {
		return (int)near;
	}
	while (low <= high) {
		int middle = (low + high) / 2;

		if (font->code[middle] == code) {
			return middle;
		}
		if (font->code[middle] < code) {
			low = middle + 1;
		} else {
			high = middle - 1;
		}
	}
	return FONT_UNKNOWN;
}

/* How many bytes follow a first byte; -1 if it cannot be a first byte. */
static int continuation_count(uint8_t first)
{
	return first < 0x80                      ? 0
		: first >= 0xC2 && first <= 0xDF ? 1
		: first >= 0xE0 && first <= 0xEF ? 2
		: first >= 0xF0 && first <= 0xF4 ? 3
						 : -1;
}

uint32_t font_next_code(const char **text)
{
	/* Smaller codes would be overlong encodings. */
	static const uint32_t min_code[] = {0, 0x80, 0x800, 0x10000};
	const uint8_t *at = (const uint8_t *)*text;
	int more = continuation_count(*at);
	uint32_t code;

	if (*at == 0) {
		return 0;
	}
	++*text;
	if (more < 0) {
		return REPLACEMENT;
	}
	code = more ? *at & (0x3Fu >> more) : *at;
	for (int i = 1; i <= more; i++) {
		if ((at[i] & 0xC0) != 0x80) {
			return REPLACEMENT;
		}
		code = code << 6 | (at[i] & 0x3F);
	}
	if (code < min_code[more] || code > 0x10FFFF ||
		(code >= 0xD800 && code <= 0xDFFF)) {
		return REPLACEMENT;
	}
	*text += more;
	return code;
}
