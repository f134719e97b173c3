/*
 * Luminance textures as luminance.c wants them: quads of texels, and patches
 * where they are the same.
 */
#ifndef PLATFORM_GL_SOFT_TILES_H
#define PLATFORM_GL_SOFT_TILES_H

#include <stdint.h>

struct level;

/*
 * A quad is a texel with those right of it, below and below right, from the low
 * byte up, as the texture repeats: the four around a pixel, in 127ths. Or, with
 * QUAD_PATCH set, one of a patch: its texels are the same, as are those of all
 * quads of the patch.
 */
#define QUAD_PATCH 0x80000000u

enum {
	TILE_SIDE_MAX = 128,
	PATCHES_MOST = 63, /* larger ones first; their numbers begin at 1 */
};

static inline uint32_t quad_luminance(uint32_t patch_quad)
{
	return patch_quad & 127;
}

static inline uint32_t quad_patch(uint32_t patch_quad)
{
	return patch_quad >> 8 & 63;
}

/*
 * A rectangle of quads, by coordinates of upper left texels, where 2^32 are all
 * of the texture: the last one before it and the last one inside of it.
 */
struct patch {
	uint32_t s[2], t[2];
};

/* Of a level; row by row. */
struct tiles {
	struct patch patch[PATCHES_MOST + 1];
	uint32_t quad[];
};

/*
 * Makes those of a level of luminance that is small enough, which owns them; of
 * others, and without memory, it makes none.
 */
void tiles_make(struct level *level);

/* Makes them again from changed texels, if there are any. */
void tiles_update(struct level *level);

#endif
