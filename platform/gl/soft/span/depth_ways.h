/* Runs whose depth test is not what span functions do by themselves. */
#ifndef PLATFORM_GL_SOFT_SPAN_DEPTH_WAYS_H
#define PLATFORM_GL_SOFT_SPAN_DEPTH_WAYS_H

#include "platform/gl/soft/span/run.h"

struct draw;

/* draw->spans.run, which begins at column x of row y. */
void soft_draw_tested(
	struct draw *draw, soft_span_function function, int x, int y);

#endif
