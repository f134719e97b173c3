/*
 * The stage of span functions (template.h) for a second texture, whose texels
 * multiply those of the first one, or are added to the colour.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_SECOND_H
#define PLATFORM_GL_SOFT_STAGES_SECOND_H

#include "platform/gl/soft/span/stages.h"
#include "platform/gl/soft/stages/bytes.h"

/* Fraction bits of a second texel's channel, besides its 5, 6 and 5 bits. */
static ALWAYS_INLINE int soft_second_fraction(
	struct soft_kind kind, enum soft_channel channel)
{
	return kind.joined              ? (kind.linear ? 18 : 0)
		: channel == SOFT_GREEN ? 5
					: 6;
}

/* A second texel's channel, shifted to so many fraction bits. */
static ALWAYS_INLINE soft_word soft_second_channel(struct soft_kind kind,
	const struct soft_texel *second, enum soft_channel channel, int fraction)
{
	const int up = fraction - soft_second_fraction(kind, channel);

	return up >= 0 ? second->channel[channel] << up
		       : second->channel[channel] >> -up;
}

/* Splits a word of soft_run.second into channels. */
static ALWAYS_INLINE void soft_split_second(
	soft_word word, struct soft_texel *out)
{
	out->channel[0] = word >> 21; /* the lowest bit belongs to green */
	out->channel[1] = word << 10 >> 21;
	out->channel[2] = word << 21 >> 21;
}

/* Multiplies a texel of RGBA8888 by a second one's bytes. */
static ALWAYS_INLINE void soft_multiply_texel(
	struct soft_kind kind, soft_word second, struct soft_texel *texel)
{
	soft_split_texel(
		kind, soft_multiply_bytes(soft_join(texel), second), texel);
}

/* Multiplies channels by a second texel's, which have 11 bits. */
static ALWAYS_INLINE void soft_scale_texel(struct soft_kind kind,
	const struct soft_texel *second, struct soft_texel *texel)
{
	const soft_word red = soft_second_channel(kind, second, SOFT_RED, 6);
	const soft_word green = soft_second_channel(kind, second, SOFT_GREEN, 5);
	const soft_word blue = soft_second_channel(kind, second, SOFT_BLUE, 6);
	soft_word *c = texel->channel;

	if (kind.format == TEXEL_8888) {
		c[0] = texel->lanes.red_blue & 0xFFFF;
		c[1] = texel->lanes.green_alpha & 0xFFFF;
		c[2] = texel->lanes.red_blue >> 16;
	}
	if (soft_is_aligned(kind)) {
		c[0] = WORD_TIMES_BOTTOM(c[0], red);
		c[1] = WORD_TIMES_BOTTOM(c[1], green);
		c[2] = WORD_TIMES_BOTTOM(c[2], blue);
	} else {
		c[0] *= red;
		c[1] *= green;
		c[2] *= blue;
	}
}

static ALWAYS_INLINE void soft_add_second(struct soft_kind kind,
	const struct soft_texel *second, struct soft_color *color)
{
	for (enum soft_channel i = SOFT_RED; i < SOFT_ALPHA; i++) {
		color->channel[i] += (soft_int)soft_second_channel(
			kind, second, i, soft_fraction(kind, i));
	}
}

#endif
