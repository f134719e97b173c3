/*
 * Luminance textures as luminance.c wants them: quads of texels, and patches
 * where they are the same.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TILES_H
#define PLATFORM_GL_SOFT_FAST_TILES_H

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
	FINE_SIDE_MAX = 64,
	FINE_PATCH = 255,
	/*
	 * What a pixel and the next may differ by, of 255, in 16.16. From the
	 * middle between them either is less than a step of red or blue off.
	 */
	BY_TWO_MOST = 20 << 16,
	/* A place of fine is as wide, in 16.16 of texels. */
	FINE_PLACE = 1 << 14,
};

static inline uint32_t quad_luminance(uint32_t patch_quad)
{
	return patch_quad & 127;
}

/*
 * The mean, in halves of 127ths, cut, of a quad that is none of a patch; places
 * between its texels in 256ths. Both rows are mixed at once; what one borrows
 * from the other the sum gives back.
 */
static inline uint32_t quad_mix(uint32_t quad, uint32_t across, uint32_t down)
{
	uint32_t left = quad & 0xFF00FF, right = quad >> 8 & 0xFF00FF;
	uint32_t rows = left * 256 + (right - left) * across;

	return ((rows & 0xFFFF) * (256 - down) + (rows >> 16) * down) >> 15;
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

/*
 * Of a level; row by row. Of smaller ones the mean of four texels is there for
 * each of 4 x 4 places between them as well, in halves of 127ths, or FINE_PATCH
 * inside of a patch.
 */
struct tiles {
	struct patch patch[PATCHES_MOST + 1];
	uint8_t *fine; /* behind the quads, or NULL */
	/* the least and the most of all means, in halves of 127ths */
	uint8_t low, high;
	uint32_t by_two_most; /* steps up to which two pixels are drawn as one */
	uint32_t quad[];
};

/*
 * Makes those of a level of luminance that is small enough, which owns them; of
 * others, and without memory, it makes none.
 */
void soft_tiles_make(struct level *level);

/* Makes them again from changed texels, if there are any. */
void soft_tiles_update(struct level *level);

#endif
