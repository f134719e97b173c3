/*
 * The soft driver's reference: triangles in any state, a fragment at a time and
 * a stage after the other, for tests to compare the driver's pixels with. It
 * takes the driver's planes, and its arithmetic of texels and depths, so that
 * coverage, depth, stencil and alpha tests are the same.
 */
#ifndef TESTS_SUPPORT_SOFT_REFERENCE_H
#define TESTS_SUPPORT_SOFT_REFERENCE_H

#include "platform/gl/soft/vertex/draw.h"

enum {
	REFERENCE_PIXELS = SOFT_RUN_PIXELS, /* of a span, at most */
};

/* A context's triangles are drawn by the reference, or by the driver again. */
void reference_use(struct soft *soft, bool on);

/* walk.c: what reference_use() sets. */
void reference_fill(struct draw *draw, struct setup *setup);

/* fragment.c: fragments of a row, all inside of draw->box. */
void reference_draw_span(struct draw *draw, const struct span *span);

/* texel.c: colours of texels for a span's fragments, for a picture of bytes. */
void reference_sample(const struct texture_input *input,
	const struct span *span, int unit, bool wide, uint8_t (*out)[4]);

/* combine.c: what the environment makes of the fragments' colours. */
void reference_combine(const struct texture_input *input, int count,
	const uint8_t (*texel)[4], const uint8_t (*primary)[4],
	uint8_t (*color)[4]);

#endif
