/*
 * Runs whose colours are made beforehand, as a row of RGBA8888: mixtures of two
 * levels of a texture; and what any texture environments make of up to two
 * textures. The row is then drawn as a texture by a span function for the rest
 * of the state.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_MADE_H
#define PLATFORM_GL_SOFT_STAGES_MADE_H

#include "platform/gl/soft/span/spans.h"

struct texture_input;

/* Whether a texture's minifying filter mixes two levels. */
bool soft_mixes_levels(const struct texture_input *input);

/* Once a draw call whose runs are made: after all else of struct soft_spans. */
void soft_prepare_made(struct draw *draw);

/* Where a listed run's texels are in the base, and how they run. */
struct soft_made_at soft_find_made_at(
	const struct draw *draw, int unit, const struct soft_row *row);

/* A texture's levels for a level of detail with 8 bits of fraction. */
void soft_set_made_levels(struct draw *draw, int unit, int lod);

/* The second texture's texels of the runs under way, for the span functions. */
void soft_read_second(struct draw *draw, uint32_t *texel);

/*
 * blend_row.c: blends a run's colours, RGBA8888 drawn beside the picture, with
 * the picture: GL ES 1.1 section 4.1.6. Those are blended whose depth before
 * differs from that after they were drawn.
 */
void soft_blend_row(const struct draw *draw, const struct soft_row *row,
	const uint8_t *color, const uint16_t *before, const uint16_t *after);

#endif
