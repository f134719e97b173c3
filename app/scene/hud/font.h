/*
 * A font as pictures of its glyphs, baked when limber is built.
 *
 * All sizes share one atlas of coverage (0..255), which goes into one GL_ALPHA
 * texture; beside the glyphs it holds a solid patch and discs, so that panels
 * and bars are drawn from the same texture as their text. The data is made by
 * toolchain/font/bake.c and is constant. Distances are pixels, y runs down.
 */
#ifndef APP_SCENE_HUD_FONT_H
#define APP_SCENE_HUD_FONT_H

#include <stdint.h>

enum {
	FONT_DISC_RADIUS_MAX = 12,
	FONT_UNKNOWN = 0, /* the glyph shown for what the font lacks: a box */
};

struct font_glyph {
	uint16_t s, t;         /* top left texel in the atlas */
	uint8_t width, height; /* texels; 0 for a space */
	int8_t left;           /* from the pen to the left edge */
	int8_t top;            /* from the baseline up to the top edge */
	uint8_t advance;       /* to the next pen position; digits have equal */
};

struct font_face {
	uint8_t size;        /* pixels to the em */
	uint8_t ascent;      /* from the top of a line down to its baseline */
	uint8_t line_height; /* from a line to the next */
	uint8_t cap_height;  /* of a flat capital letter */
	const struct font_glyph *glyph; /* [glyph_count] of the font */
};

struct font {
	const char *name;
	int width, height; /* of the atlas; powers of two up to 512 */
	const uint8_t *alpha;
	int glyph_count;
	const uint16_t *code; /* [glyph_count] Unicode, ascending; 0 first */
	int face_count;
	const struct font_face *face; /* smallest first */
	uint16_t solid_s, solid_t;    /* the middle of the solid patch */
	/* Top left texels of discs, 2 * radius wide and high; [0] unused. */
	uint16_t disc[FONT_DISC_RADIUS_MAX + 1][2];
};

/* The baked font. */
extern const struct font font_default;

/* The glyph's number in every face's table; FONT_UNKNOWN if there is none. */
int font_find_glyph(const struct font *font, uint32_t code);

/*
 * Decodes one character of UTF-8 and moves *text behind it; 0 at the end.
 * What is no UTF-8 gives U+FFFD for each byte.
 */
uint32_t font_next_code(const char **text);

#endif
