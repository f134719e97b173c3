/* The paths of triangles: a table, from which each draw call takes one. */
#include "platform/gl/soft/raster/raster.h"

/* A path of a draw call's triangles: one of fast/, or span functions. */
struct path {
	/* the path draws states with (key & mask) == bits */
	uint32_t mask, bits;
	fill_function fill;
	void (*begin)(struct draw *draw); /* once a draw call, or NULL */
	bool one_color; /* the call has one colour: no vertex is shaded */
	bool divides;   /* for struct draw, as is the next one */
	bool rectangles;
};

enum {
	/* states that most paths cannot draw, and the picture's format */
	OTHERS = KEY_565 | KEY_COLOR_MASKED | KEY_TEXTURES | KEY_FOG |
		KEY_ALPHA_TEST | KEY_BLENDED_OTHER | KEY_ADDED,
	FLAT = OTHERS | KEY_LIT | KEY_COLOR_ARRAY | KEY_TEXTURE |
		KEY_DEPTH_TEST | KEY_STENCIL,
	GLYPHS = KEY_TEXTURE | KEY_TEXTURE_ALPHA | KEY_MODULATE | KEY_NEAREST |
		KEY_BLENDED,
	/* opaque, depth test LESS */
	SMALL = OTHERS | KEY_BLENDED | KEY_STENCIL | KEY_BY_TRIANGLE |
		KEY_DEPTH_LESS,
	TILES = KEY_TEXTURE | KEY_TEXTURE_TILES | KEY_MODULATE | KEY_REPEAT |
		KEY_LINEAR | KEY_MIPMAPS,
	TEXELS = KEY_TEXTURE | KEY_TEXTURE_565 | KEY_MODULATE,
};

/* The first path that matches the key is taken; the last one always matches. */
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
