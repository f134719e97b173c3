/*
 * The soft driver's reference: draws triangles in any state, a fragment at a time
 * and one stage of GL after the other, for tests to compare the driver's pixels
 * with. It uses the driver's plane equations and its arithmetic of texels and
 * depths, so that coverage, depth, stencil and alpha tests are the same.
 */
#ifndef TESTS_SUPPORT_SOFT_REFERENCE_H
#define TESTS_SUPPORT_SOFT_REFERENCE_H

#include "platform/gl/soft/vertex/draw.h"

enum {
	REFERENCE_PIXELS = SOFT_RUN_PIXELS, /* the most fragments of a span */
};

/* Fragments of a row: values of the first one, and their step a pixel. */
struct span {
	int x, y, count;
	uint32_t value[PLANES];
	int32_t step[PLANES];
	int lod[SOFT_UNITS]; /* level of detail, 8 bits of fraction */
};

/* a * b / 255 of two bytes, rounded to the nearest. */
static inline int scale_byte(int a, int b)
{
	int product = a * b + 128;

	return (product + (product >> 8)) >> 8;
}

/* Makes the reference draw a context's triangles or, if !on, the driver again. */
void reference_use(struct soft *soft, bool on);

/* walk.c: draws a triangle. reference_use() makes the driver call it. */
void reference_fill(struct draw *draw, struct setup *setup);

/* fragment.c: draws the fragments of a span, which lie inside of draw->box. */
void reference_draw_span(struct draw *draw, const struct span *span);

/*
 * texel.c: samples a unit's texture for a span's fragments into out[span->count].
 * wide rounds mixed 8-bit channels to nearest, as for pictures of RGBA8888.
 */
void reference_sample(const struct texture_input *input,
	const struct span *span, int unit, bool wide, uint8_t (*out)[4]);

/*
 * combine.c: applies a unit's texture environment to color[count]. primary has
 * the fragments' colours before the first unit.
 */
void reference_combine(const struct texture_input *input, int count,
	const uint8_t (*texel)[4], const uint8_t (*primary)[4],
	uint8_t (*color)[4]);

#endif
