/*
 * Texture environments on rows of fragments, stage by stage: GL ES 1.1 section
 * 3.7.12. Colours are RGBA8888 words. What the results are is defined by
 * tests/support/soft/combine.c, a fragment at a time.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_COMBINE_ROWS_H
#define PLATFORM_GL_SOFT_STAGES_COMBINE_ROWS_H

#include "platform/gl/soft/span/run.h"

struct texture_input;

/* Whether texels of a base format have an alpha of their own. */
bool soft_base_has_alpha(GLenum format);

/* A function of GL_COMBINE and its arguments. */
struct soft_combiner {
	GLenum function;
	GLenum source[3], operand[3];
	int doublings; /* of the result: 0 to 2 */
};

/* What one texture's environment does, of whatever mode. */
struct soft_environment {
	struct soft_combiner rgb, alpha;
	bool alike;        /* rgb does for alpha what alpha does */
	bool alpha_wanted; /* else the result's alpha is any */
	uint32_t constant; /* the environment's colour */
};

/*
 * The mode of an environment; of GL_COMBINE one that does the same to texels of
 * the base format. The first unit's previous colour is the primary one.
 */
GLenum soft_find_mode(const struct texenv *env, GLenum format, bool first);

/* For a texture that is used. */
void soft_find_environment(
	const struct texture_input *input, struct soft_environment *out);

/* Whether a texture multiplies the colour, or takes its place. */
bool soft_is_simple_environment(const struct texture_input *input);

/*
 * Whether it adds GL_CONSTANT or GL_TEXTURE to the previous colour, and keeps
 * its alpha.
 */
bool soft_adds(const struct texture_input *input, GLenum source);

/* Colours, of which previous has those of the stage before; it may be color. */
void soft_combine_row(const struct soft_environment *environment,
	const uint32_t *texel, const uint32_t *primary,
	const uint32_t *previous, uint32_t *color, uint32_t count);

#endif
