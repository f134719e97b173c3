/*
 * Blends a run's colours, drawn beside the picture, with the picture: GL ES 1.1
 * section 4.1.6.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H
#define PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H

#include "platform/gl/soft/span/run.h"

/*
 * Colours are RGBA8888. Those are blended whose depth before differs from that
 * after the run was drawn beside the picture.
 */
void soft_blend_row(const struct soft_run *run, const uint32_t *color,
	const uint16_t *before, const uint16_t *after);

#endif
