/*
 * Texture environments (GL ES 1.1 section 3.7.12) on rows of fragments. Colours
 * are RGBA8888 words. tests/support/soft/combine.c defines the results: it is
 * the reference, which computes a fragment at a time.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_COMBINE_ROWS_H
#define PLATFORM_GL_SOFT_STAGES_COMBINE_ROWS_H

#include "platform/gl/soft/span/spans.h"

struct texture_input;

/* Whether a base format, such as GL_RGBA, has alpha. */
bool soft_base_has_alpha(GLenum format);

/*
 * An environment's mode; GL_MODULATE or GL_REPLACE where GL_COMBINE has the same
 * effect on texels of the base format. first: the previous colour is the primary.
 */
GLenum soft_find_mode(const struct texenv *env, GLenum format, bool first);

/* Fills out for a texture that is used. */
void soft_find_environment(
	const struct texture_input *input, struct soft_environment *out);

/* Whether an environment multiplies the colour by the texel, or replaces it. */
bool soft_is_simple_environment(const struct texture_input *input);

/*
 * Whether an environment adds source, GL_CONSTANT or GL_TEXTURE, to the
 * previous colour, and keeps that colour's alpha.
 */
bool soft_adds(const struct texture_input *input, GLenum source);

/* Sets count colours; previous has the stage's before, and may be color. */
void soft_combine_row(const struct soft_environment *environment,
	const uint32_t *texel, const uint32_t *primary,
	const uint32_t *previous, uint32_t *color, uint32_t count);

#endif
