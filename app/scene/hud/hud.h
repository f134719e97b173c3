/*
 * Text, bars and panels over a picture: the head-up display.
 *
 * A frame is hud_begin(), anything to show, hud_end(), which draws all of it
 * in the order it was given, with one draw call. Positions are whole pixels
 * from the top left corner of the picture, y runs down. The hud owns its
 * vertices and its texture; nothing is allocated after hud_init(), and what no
 * longer fits is left out. Labels stacked in a corner are hud_group.h.
 */
#ifndef APP_SCENE_HUD_HUD_H
#define APP_SCENE_HUD_HUD_H

#include "app/scene/hud/font.h"
#include "platform/base/log.h"
#include "platform/gl/gl.h"

enum {
	HUD_QUADS_MAX = 1024, /* a letter is one, a bar or panel up to 14 */
	HUD_CORNERS = 4
};

/* sRGB; a is how much of the picture is covered. */
struct hud_color {
	uint8_t r, g, b, a;
};

extern const struct hud_color hud_color_text;  /* values */
extern const struct hud_color hud_color_dim;   /* labels */
extern const struct hud_color hud_color_panel; /* backdrop of text */

/* Accents that tell parts apart, for bars. */
extern const struct hud_color hud_color_blue;
extern const struct hud_color hud_color_green;
extern const struct hud_color hud_color_amber;
extern const struct hud_color hud_color_rose;
extern const struct hud_color hud_color_violet;

struct hud_vertex {
	int16_t x, y;      /* pixels until hud_end() */
	int16_t z, unused; /* 0; of three shorts drivers are quickest */
	float s, t;        /* texels until hud_end() */
	struct hud_color color;
};

struct hud {
	const struct font *font;
	GLuint texture;

	int width, height;            /* of the picture */
	const struct font_face *face; /* as suits the picture's height */
	int scale;                    /* pixels to a texel of the face */
	int stacked_px[HUD_CORNERS];  /* room taken by groups of a corner */

	int quad_count;
	struct hud_vertex vertex[HUD_QUADS_MAX * 4];
	uint16_t index[HUD_QUADS_MAX * 6];
};

/*
 * A hud with the default font, whose atlas becomes a texture of the current
 * context. 0, or -ENOMEM after a sentence. Release with hud_finish().
 */
int hud_init(struct hud *hud, const struct gl *gl, const struct log *log);

/* Releases the texture; a hud of zeros is fine. */
void hud_finish(struct hud *hud, const struct gl *gl);

/* Begins a frame of a picture of this size, at most 8192 a side. */
void hud_begin(struct hud *hud, int width, int height);

/*
 * Draws the frame on the current target. Lighting, culling and alpha test are
 * off afterwards, as are blending and textures; the depth test is on, the
 * matrix mode model-view, all three matrices are the identity, and of the
 * arrays those of vertices and colours are enabled. Expects texture unit 0 to
 * be current, stencil test and fog to be off, and the viewport to be the
 * picture. Nothing is left to draw a second time.
 */
void hud_end(struct hud *hud, const struct gl *gl);

/* One em of the text in pixels: what a layout that suits the picture counts. */
int hud_em(const struct hud *hud);

/* From the top of one line to the top of the next, pixels. */
int hud_line_height(const struct hud *hud);

/* How wide UTF-8 text is, pixels; the widths of two pieces add up. */
int hud_text_width(const struct hud *hud, const char *text);

/*
 * UTF-8 text in one line whose top left corner is x, y. A box stands for what
 * the font lacks. Returns the x behind it.
 */
int hud_text(struct hud *hud, int x, int y, struct hud_color color,
	const char *text);

/* The same, cut to a width with an ellipsis if it would be wider. */
int hud_text_cut(struct hud *hud, int x, int y, int width,
	struct hud_color color, const char *text);

/* A plain rectangle. */
void hud_rectangle(
	struct hud *hud, int x, int y, int w, int h, struct hud_color color);

/* A rectangle with round corners; a radius beyond half a side is cut to it. */
void hud_panel(struct hud *hud, int x, int y, int w, int h, int radius,
	struct hud_color color);

/*
 * A rounded bar of which a share, clamped to 0..1, is filled from the left.
 * Any share above 0 shows.
 */
void hud_bar(struct hud *hud, int x, int y, int w, int h, float share,
	struct hud_color color);

/* Moves what was given since quad_count was first_quad. */
void hud_move(struct hud *hud, int first_quad, int x, int y);

#endif
