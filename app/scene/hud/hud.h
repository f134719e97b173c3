/*
 * The head-up display: text, bars and panels on top of the picture.
 *
 * A frame calls hud_begin(), the functions that add elements, and hud_end(),
 * which draws all elements in the order they were added, with one draw call.
 * Positions are whole pixels from the picture's top left corner; y points down.
 * The hud owns its vertices and its texture and allocates nothing after
 * hud_init(). Elements beyond HUD_QUADS_MAX are dropped. hud_group.h stacks
 * labels in a corner.
 */
#ifndef APP_SCENE_HUD_HUD_H
#define APP_SCENE_HUD_HUD_H

#include "app/scene/hud/font.h"
#include "platform/base/log.h"
#include "platform/gl/gl.h"

enum {
	/* a glyph takes one, a panel up to 7, a bar up to 14 */
	HUD_QUADS_MAX = 1024,
	HUD_CORNERS = 4
};

/* sRGB with alpha. */
struct hud_color {
	uint8_t r, g, b, a;
};

extern const struct hud_color hud_color_text;  /* values */
extern const struct hud_color hud_color_dim;   /* labels */
extern const struct hud_color hud_color_panel; /* panels behind text */

/* Accents for bars and marks. */
extern const struct hud_color hud_color_blue;
extern const struct hud_color hud_color_green;
extern const struct hud_color hud_color_amber;
extern const struct hud_color hud_color_rose;
extern const struct hud_color hud_color_violet;

struct hud_vertex {
	int16_t x, y;      /* in pixels until hud_end() */
	int16_t z, unused; /* 0; drivers are fastest with three shorts */
	float s, t;        /* in texels until hud_end() */
	struct hud_color color;
};

struct hud {
	const struct font *font;
	GLuint texture;

	int width, height;            /* of the picture */
	const struct font_face *face; /* chosen by the picture's height */
	int scale;                    /* pixels a texel of the face */
	/* height that the groups of each corner take */
	int stacked_px[HUD_CORNERS];

	int quad_count;
	struct hud_vertex vertex[HUD_QUADS_MAX * 4];
	uint16_t index[HUD_QUADS_MAX * 6];
};

/*
 * Initializes a hud with the default font and uploads the font's atlas as a
 * texture. Returns 0, or -ENOMEM after logging an error. Release it with
 * hud_finish().
 */
int hud_init(struct hud *hud, const struct gl *gl, const struct log *log);

/*
 * Returns the face for pictures of this height, and stores in *scale how many
 * pixels each of its texels covers.
 */
const struct font_face *hud_face_for(
	const struct font *font, int height, int *scale);

/* Deletes the texture. A hud whose bytes are all zero is allowed. */
void hud_finish(struct hud *hud, const struct gl *gl);

/* Begins a frame of a picture of this size, at most 8192 a side. */
void hud_begin(struct hud *hud, int width, int height);

/*
 * Draws the frame's elements and removes them. Expects texture unit 0 to be
 * current, stencil test and fog to be off, and the viewport to be the picture.
 * Afterwards lighting, culling, alpha test, blending and textures are off, the
 * depth test is on, the matrix mode is model-view, all three matrices are the
 * identity, and only the vertex and colour arrays are enabled.
 */
void hud_end(struct hud *hud, const struct gl *gl);

/* Returns the font's em in pixels, the unit for lengths in a layout. */
int hud_em(const struct hud *hud);

/* Returns the pixels from the top of one line to the top of the next. */
int hud_line_height(const struct hud *hud);

/*
 * Returns the width of UTF-8 text in pixels. The widths of two pieces add up to
 * the width of the whole.
 */
int hud_text_width(const struct hud *hud, const char *text);

/*
 * Adds one line of UTF-8 text whose top left corner is x, y, and returns the x
 * where it ends. Characters that the font lacks are drawn as a box.
 */
int hud_text(struct hud *hud, int x, int y, struct hud_color color,
	const char *text);

/* Does the same, but cuts wider text to the width and ends it in an ellipsis. */
int hud_text_cut(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text);

/*
 * Does the same, but of wider text without blanks it leaves out the middle, if
 * there is room for some letters on both sides of it: names of bones and clips
 * often begin alike and differ at their ends. Of two words it leaves out the
 * end of the first, if the second one is short.
 */
int hud_text_shorten(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text);

/* Adds a rectangle. */
void hud_rectangle(
	struct hud *hud, int x, int y, int w, int h, struct hud_color color);

/* Adds a rectangle with rounded corners; the radius is at most half a side. */
void hud_panel(struct hud *hud, int x, int y, int w, int h, int radius,
	struct hud_color color);

/*
 * Adds a rounded bar that is filled from the left. The fraction is clamped to
 * 0..1; any fraction above 0 is visible.
 */
void hud_bar(struct hud *hud, int x, int y, int w, int h, float fraction,
	struct hud_color color);

/* Moves all quads from number first_quad on by x, y. */
void hud_move(struct hud *hud, int first_quad, int x, int y);

#endif
