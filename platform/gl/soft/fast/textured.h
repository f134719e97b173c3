/*
 * What small textured triangles of a draw call share, so that setting one up
 * looks nothing else up. fill_texture.c makes it, and sets triangles up in C;
 * arm/textured.S draws the same ones.
 */
#ifndef PLATFORM_GL_SOFT_FAST_TEXTURED_H
#define PLATFORM_GL_SOFT_FAST_TEXTURED_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "platform/gl/soft/soft.h"

struct setup;
struct tint_band;

/* A level as struct tint_band has it; offsets are known to arm/textured.S. */
struct textured_level {
	uint32_t texel_mask, next, texel_shift;
	const uint8_t *texels; /* 12: NULL where it is larger than 256 */
	uint32_t stride_bytes;
	/* from 16.16 of the base's texels to 8 bits of its own */
	int32_t s_down, t_down;
	uint32_t unused;
};

struct textured;

/*
 * Draws a triangle that is up to 32 pixels wide and high and inside of the box
 * with a pixel to spare at the sides; or returns false and draws nothing, where
 * it has to go another way. The base is up to 256 texels wide and high.
 */
typedef bool (*textured_function)(
	const struct textured *textured, const struct setup *setup);

/* Offsets are known to arm/textured.S. */
struct textured {
	uintptr_t depth;                      /* 0: of column and row 0 */
	uintptr_t stride_bytes;               /* 4 */
	const int32_t *inverse;               /* 8: draw->inverse_q31 */
	const uint16_t *reciprocals;          /* 12: soft_reciprocal_table */
	void (*tint)(struct tint_band *band); /* 16: the rows of tints */
	uint32_t perspective;                 /* 20 */
	/* 24: as struct limits has it where w hardly differs */
	int32_t texel_limit;
	int32_t s_shift, t_shift;           /* 28: 8 less the base's log2 */
	int32_t last_level;                 /* 36: of those to choose from */
	uint32_t red_blue_mask, green_mask; /* 40: as struct tint_band */
	uint32_t round;                     /* 48 */
	uintptr_t pixels;                   /* 52 */
	uint32_t half_texel; /* 56: taken off where four are mixed */
	int32_t near_limit; /* 60: that of small ones where w differs more, or 0 */
	struct textured_level level[SOFT_LEVELS]; /* 64 */
	/* those of soft_bands; NULL where C sets triangles up */
	textured_function gray_triangle, tint_triangle;
};

#endif
