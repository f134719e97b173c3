/*
 * Luminance textures, rearranged for luminance.c: a quad of four texels for
 * each texel, and patches: rectangles in which all texels are equal.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TILES_H
#define PLATFORM_GL_SOFT_FAST_TILES_H

#include <stdint.h>

struct level;

/*
 * A quad is the four texels that a bilinear filter reads, in 127ths: a texel, and
 * those right of it, below and below right, from the low byte up; the texture
 * repeats. With QUAD_PATCH set, all four texels are equal, as in all quads of the
 * patch: bits 0 to 6 are their luminance, bits 8 to 13 the patch's number.
 */
#define QUAD_PATCH 0x80000000u

enum {
	TILE_SIDE_MAX = 128,
	PATCHES_MOST = 63, /* the largest rectangles; numbered from 1 on */
	FINE_SIDE_MAX = 64,
	FINE_PATCH = 255, /* in fine: the quad belongs to a patch */
	/*
	 * Largest difference of two neighbouring pixels, of 255, in 16.16, that
	 * are drawn as one: each is off by less than a step of red or blue.
	 */
	BY_TWO_MOST = 20 << 16,
	/* the width of a place of fine, in 16.16 texels */
	FINE_PLACE = 1 << 14,
};

static inline uint32_t quad_luminance(uint32_t patch_quad)
{
	return patch_quad & 127;
}

/*
 * Filters a quad without QUAD_PATCH bilinearly: across and down are weights of
 * 256; the result is in halves of 127ths, rounded down. Both rows are mixed in
 * one word; the final sum cancels what the lower half borrows from the upper.
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
 * A rectangle of quads: [0] is the last coordinate before it and [1] the last
 * one inside of it, where 2^32 is the whole texture.
 */
struct patch {
	uint32_t s[2], t[2];
};

/*
 * A level's quads, [side][side], and its patches. The side is the level's
 * longer one: along the other one quads repeat, as the texture does. Levels up
 * to FINE_SIDE_MAX also have fine, [4 * side][4 * side]: filtered values at 4 x
 * 4 places of each quad, in halves of 127ths, or FINE_PATCH inside of a patch.
 */
struct tiles {
	int side_log2;
	struct patch patch[PATCHES_MOST + 1];
	uint8_t *fine; /* in the same allocation behind quad, or NULL */
	/* least and largest luminance, in halves of 127ths */
	uint8_t low, high;
	uint32_t by_two_most; /* largest step, 16.16, to draw two pixels as one */
	uint32_t quad[];
};

/*
 * Allocates level->tiles, which level owns, if it is luminance of 2 to 128
 * texels a side; else, or without memory, level->tiles stays NULL.
 */
void soft_tiles_make(struct level *level);

/* Makes level->tiles again, unless NULL, after texels have changed. */
void soft_tiles_update(struct level *level);

#endif
