/*
 * A bitmap font, baked from a typeface when limber is built.
 *
 * All sizes share one atlas of coverage (0..255), which becomes one GL_ALPHA
 * texture. The atlas also holds a solid patch and discs, so that panels and
 * bars use the same texture as text. toolchain/font/bake.c writes the data,
 * which is constant. Distances are in pixels; y points down.
 */
#ifndef APP_SCENE_HUD_FONT_H
#define APP_SCENE_HUD_FONT_H

#include <stdint.h>

enum {
	FONT_DISC_RADIUS_MAX = 12,
	FONT_UNKNOWN = 0, /* the glyph for characters that the font lacks */
};

struct font_glyph {
	uint16_t s, t;         /* top left texel in the atlas */
	uint8_t width, height; /* texels; 0 for a space */
	int8_t left;           /* from the pen to the left edge */
	int8_t top;            /* from the baseline up to the top edge */
	uint8_t advance;       /* to the next pen position; equal for digits */
};

struct font_face {
	uint8_t size;        /* pixels of an em */
	uint8_t ascent;      /* from the top of a line down to its baseline */
	uint8_t line_height; /* from one line to the next */
	uint8_t cap_height;  /* height of a flat capital letter */
	const struct font_glyph *glyph; /* [font.glyph_count] */
};

struct font {
	const char *name;
	int width, height; /* of the atlas; powers of two up to 512 */
	const uint8_t *alpha;
	int glyph_count;
	const uint16_t *code; /* [glyph_count], Unicode, ascending; 0 first */
	int face_count;
	const struct font_face *face; /* smallest first */
	uint16_t solid_s, solid_t;    /* the middle of the solid patch */
	/* Top left texels of discs, 2 * radius wide and high; [0] unused. */
	uint16_t disc[FONT_DISC_RADIUS_MAX + 1][2];
};

/* The baked font. */
extern const struct font font_default;

/* Returns a character's index in the faces' glyph tables, or FONT_UNKNOWN. */
int font_find_glyph(const struct font *font, uint32_t code);

/*
 * Decodes one character of UTF-8 and moves *text past it. Returns 0 at the end
 * and U+FFFD for each byte that is not valid UTF-8.
 */
uint32_t font_next_code(const char **text);

#endif
