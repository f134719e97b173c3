/*
 * Runs whose texels are made beforehand, as RGBA8888 in a row of their own:
 * mixtures of two levels.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_MADE_H
#define PLATFORM_GL_SOFT_SPAN_MADE_H

#include "platform/gl/soft/span/spans.h"

struct texture_input;

/* Whether a texture's texels are made: its minifying filter mixes two levels. */
bool soft_wants_made(const struct texture_input *input);

/*
 * For a level of detail with 8 bits of fraction, or where the texture is
 * magnified -1.
 */
void soft_set_made_levels(struct draw *draw, int lod);

/* Draws the run whose coordinates are in spans->made_at. */
void soft_draw_made(const struct soft_run *run);

#endif
