/*
 * One fragment through the stages that a span function has no constants for:
 * texture environments, fog, alpha test and any blend function.
 */
#ifndef PLATFORM_GL_SOFT_SPAN_ANY_H
#define PLATFORM_GL_SOFT_SPAN_ANY_H

#include "platform/gl/soft/span/run.h"

/*
 * color is the vertices' colour (alpha_q7 its alpha in 8.7) and becomes the
 * fragment's; texel and the picture are RGBA, fog is 1.15. False where the
 * alpha test fails; else *color is what the picture gets.
 */
bool soft_finish_any(const struct soft_fragment_stages *stages,
	const uint8_t texel[4], uint32_t alpha_q7, uint32_t fog,
	const uint8_t picture[4], uint8_t color[4]);

#endif
