/*
 * Blends a run's colours, drawn beside the picture, with the picture: GL ES 1.1
 * section 4.1.6.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H
#define PLATFORM_GL_SOFT_STAGES_BLEND_ROW_H

#include "platform/gl/soft/span/run.h"

/*
 * The run's colours are RGBA8888. Those are blended whose depth before differs
 * from that after they were drawn.
 */
void soft_blend_row(const struct draw *draw, const struct soft_row *row,
	const uint8_t *color, const uint16_t *before, const uint16_t *after);

#endif
