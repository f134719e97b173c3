#include "app/scene/hud/hud_name.h"

#include "app/scene/hud/font.h"

#include <ctype.h>
#include <stdio.h>

bool hud_is_readable(const char *name)
{
	int known = 0, unknown = 0;
	uint32_t code;

	while ((code = font_next_code(&name)) != 0) {
		if (font_find_glyph(&font_default, code) == FONT_UNKNOWN) {
			unknown++;
		} else {
			known += code != ' ';
		}
	}
	return known > 0 && known >= unknown;
}

/* Returns the part of a name behind its namespaces. */
static const char *skip_namespaces(const char *name)
{
	const char *own = name;

	for (const char *at = name; *at && *at != ' '; at++) {
		bool ends = (*at == ':' || *at == '|') && at > name;

		if (ends && (isalpha((unsigned char)at[1]) || at[1] & 0x80)) {
			own = at + 1;
		}
	}
	return own;
}

const char *hud_name(const char *name, const char *kind, int number,
	char out[HUD_NAME_BYTES])
{
	name = skip_namespaces(name);
	if (hud_is_readable(name)) {
		return name;
	}
	snprintf(out, HUD_NAME_BYTES, "%s %d", kind, number);
	return out;
}
