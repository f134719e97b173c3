/*
 * Blends a run's colours, drawn beside the picture, with the picture: GL ES 1.1
 * section 4.1.6.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H
#define PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H

#include "platform/gl/soft/span/run.h"

/* Colours are RGBA8888; those whose drawn is 1 are blended. */
void soft_blend_row(const struct soft_run *run, const uint32_t *color,
	const uint16_t *drawn);

#endif
