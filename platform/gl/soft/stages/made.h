/*
 * Made runs: their texels or colours are computed first, as a row of RGBA8888,
 * because they need two mipmap levels, or two textures, or other environments
 * than span functions have. A span function then draws the row as a texture, in
 * the rest of the state.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_MADE_H
#define PLATFORM_GL_SOFT_STAGES_MADE_H

#include "platform/gl/soft/span/spans.h"

/* Prepares made runs, once a draw call, after all else of struct soft_spans. */
void soft_prepare_made(struct draw *draw);

/* A listed run's texture coordinates in a unit, where nothing is divided. */
struct soft_made_at soft_find_made_at(
	const struct draw *draw, int unit, const struct soft_row *row);

/* Sets texel and run.second to the second texture's texels of the run's rows. */
void soft_read_second(struct draw *draw, uint32_t *texel);

/*
 * coverage.c: multiplies a run's alpha by the coverage. Removes uncovered pixels
 * from both ends of the run, maybe all; returns how many from the left end.
 */
uint32_t soft_cover(
	const struct draw *draw, struct soft_row *run, uint32_t *color);

/*
 * blend_row.c: blends a run's colours, RGBA8888, with the picture: GL ES 1.1
 * section 4.1.6. Only pixels are blended that were drawn: those whose depth
 * before and after drawing is not the same.
 */
void soft_blend_row(const struct draw *draw, const struct soft_row *row,
	const uint8_t *color, const uint16_t *before, const uint16_t *after);

#endif
