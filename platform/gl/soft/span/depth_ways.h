/* Runs whose depth test is not what span functions do by themselves. */
#ifndef PLATFORM_GL_SOFT_SPAN_DEPTH_WAYS_H
#define PLATFORM_GL_SOFT_SPAN_DEPTH_WAYS_H

#include "platform/gl/soft/span/run.h"

struct soft_spans;

/*
 * Sets the functions that draw runs anywhere in the texture, and inside of the
 * window.
 */
void soft_set_functions(
	struct soft_spans *spans, const soft_span_function function[2]);

#endif
