/*
 * A draw call's state as a set of bits. Each path of fast/ says by a mask and a
 * value of these bits which states it draws; see paths.c.
 */
#ifndef PLATFORM_GL_SOFT_VERTEX_KEY_H
#define PLATFORM_GL_SOFT_VERTEX_KEY_H

#include <stdint.h>

struct draw;

enum {
	/* the picture and what is written */
	KEY_565 = 1 << 0,
	KEY_COLOR_MASKED = 1 << 1, /* red, green or blue is not written */
	/* vertices */
	KEY_LIT = 1 << 2,
	KEY_COLOR_ARRAY = 1 << 3,
	KEY_PERSPECTIVE = 1 << 4,
	/* two-sided lighting or polygon offset, which depend on the triangle */
	KEY_BY_TRIANGLE = 1 << 5,
	/* fragments */
	KEY_ALPHA_TEST = 1 << 6,
	KEY_FOG = 1 << 7,
	KEY_BLENDED = 1 << 8,
	KEY_BLENDED_OTHER = 1 << 9, /* not SRC_ALPHA, ONE_MINUS_SRC_ALPHA */
	KEY_DEPTH_TEST = 1 << 10,
	KEY_DEPTH_LESS = 1 << 11,   /* tested LESS, and written */
	KEY_DEPTH_ALWAYS = 1 << 12, /* not tested, or ALWAYS */
	KEY_STENCIL = 1 << 13,
	KEY_STENCIL_ONCE = 1 << 14, /* EQUAL, as fill_flat.c can draw it */
	KEY_ADDED = 1 << 15,        /* a colour is added to all fragments */
	/* the first texture */
	KEY_TEXTURE = 1 << 16,
	KEY_TEXTURE_565 = 1 << 17,
	KEY_TEXTURE_ALPHA = 1 << 18,
	KEY_TEXTURE_TILES = 1 << 19, /* luminance; see tiles.h */
	KEY_MODULATE = 1 << 21,
	KEY_REPEAT = 1 << 23,
	KEY_NEAREST = 1 << 24,
	KEY_LINEAR = 1 << 25,   /* bilinear, levels not mixed */
	KEY_MIPMAPS = 1 << 26,  /* KEY_LINEAR, in the nearest mipmap level */
	KEY_TEXTURES = 1 << 27, /* the second texture is used */
};

/* The key of a draw call whose textures, fragments and shading are prepared. */
uint32_t soft_find_key(const struct draw *draw);

#endif
