#include "app/scene/hud/hud_name.h"

#include "app/scene/hud/font.h"

#include <stdbool.h>
#include <stdio.h>

static bool is_readable(const char *name)
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

const char *hud_name(const char *name, const char *kind, int number,
	char out[HUD_NAME_BYTES])
{
	if (is_readable(name)) {
		return name;
	}
	snprintf(out, HUD_NAME_BYTES, "%s %d", kind, number);
	return out;
}
