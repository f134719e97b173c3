/* The table of paths, and the choice of one for a draw call. */
#include "platform/gl/soft/raster/raster.h"

/* Which way triangles of a draw call go: one of fast/, or the template's. */
struct path {
	/* It takes a key of which the bits of mask are these. */
	uint32_t mask, bits;
	fill_function fill;
	void (*begin)(struct draw *draw); /* once a draw call, or NULL */
	bool one_color; /* no vertex is shaded: all of a call has one colour */
	bool divides;   /* of struct draw */
	bool rectangles;
};

enum {
	/* What no path has a stage for. */
	OTHERS = KEY_565 | KEY_COLOR_MASKED | KEY_TEXTURES | KEY_FOG |
		KEY_ALPHA_TEST | KEY_BLENDED_OTHER | KEY_ADDED,
	FLAT = OTHERS | KEY_LIT | KEY_COLOR_ARRAY | KEY_TEXTURE |
		KEY_DEPTH_TEST | KEY_STENCIL,
	GLYPHS = KEY_TEXTURE | KEY_TEXTURE_ALPHA | KEY_MODULATE | KEY_NEAREST |
		KEY_BLENDED,
	/* Opaque, tested LESS. */
	SMALL = OTHERS | KEY_BLENDED | KEY_STENCIL | KEY_BY_TRIANGLE |
		KEY_DEPTH_LESS,
	TILES = KEY_TEXTURE | KEY_TEXTURE_TILES | KEY_MODULATE | KEY_REPEAT |
		KEY_LINEAR | KEY_MIPMAPS,
	TEXELS = KEY_TEXTURE | KEY_TEXTURE_565 | KEY_MODULATE,
};

/* The first that takes a key; the last one takes every key. */
static const struct path path[] = {
	{
		.mask = FLAT | KEY_STENCIL_ONCE,
		.bits = KEY_565 | KEY_STENCIL | KEY_STENCIL_ONCE,
		.fill = soft_fill_flat,
		.begin = soft_fill_flat_begin,
		.one_color = true,
	},
	{
		.mask = OTHERS | GLYPHS | KEY_LIT | KEY_PERSPECTIVE |
			KEY_DEPTH_TEST | KEY_STENCIL,
		.bits = KEY_565 | GLYPHS,
		.fill = soft_rows_fill,
		.rectangles = true,
	},
	{
		.mask = SMALL | KEY_TEXTURE,
		.bits = KEY_565 | KEY_DEPTH_LESS,
		.fill = soft_fill_narrow,
	},
	{
		.mask = SMALL | TEXELS | KEY_NEAREST,
		.bits = KEY_565 | KEY_DEPTH_LESS | TEXELS | KEY_NEAREST,
		.fill = soft_fill_textured,
		.begin = soft_fill_textured_begin,
	},
	{
		.mask = (SMALL & ~KEY_ADDED) | TEXELS | KEY_LINEAR,
		.bits = KEY_565 | KEY_DEPTH_LESS | TEXELS | KEY_LINEAR,
		.fill = soft_fill_textured,
		.begin = soft_fill_textured_begin,
	},
	{
		.mask = OTHERS | TILES | KEY_STENCIL | KEY_DEPTH_ALWAYS,
		.bits = KEY_565 | TILES | KEY_DEPTH_ALWAYS,
		.fill = soft_fill_luminance,
		.divides = true,
	},
	{
		.fill = soft_rows_fill,
	},
};

void soft_choose_path(struct draw *draw)
{
	const struct path *chosen = path;

	draw->key = soft_find_key(draw);
	if (draw->soft->fill || draw->smooth || draw->thin_lines) {
		chosen = &path[ARRAY_COUNT(path) - 1];
	}
	while ((draw->key & chosen->mask) != chosen->bits) {
		chosen++;
	}
	draw->fill = draw->soft->fill ? draw->soft->fill : chosen->fill;
	draw->divides = chosen->divides;
	draw->rectangles = chosen->rectangles;
	if (chosen->one_color) {
		draw->attributes = 0;
	}
	if (chosen->begin) {
		chosen->begin(draw);
	}
}
