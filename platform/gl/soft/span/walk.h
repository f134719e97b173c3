/* What the walk over a triangle's rows calls. */
#ifndef PLATFORM_GL_SOFT_SPAN_WALK_H
#define PLATFORM_GL_SOFT_SPAN_WALK_H

#include "platform/gl/soft/span/spans.h"

struct texture_input;

/*
 * begin.c: what of a triangle's runs is the same for all; which of colours,
 * alpha and fog move, as bits. Red, green and blue do so together.
 */
uint32_t soft_begin_walk(struct draw *draw);
/* And the steps of what runs linearly, of which soft_begin_walk() told. */
void soft_begin_steps(struct draw *draw, uint32_t moving);

/* level.c: the level and filter for a level of detail. */
void soft_set_level(struct draw *draw, int lod);

/* view.c: a level by a filter, which soft_use_view() gives a run to read. */
struct soft_view soft_find_view(
	const struct texture_input *input, int number, bool linear);
void soft_use_view(const struct soft_view *view, struct soft_run *run);

/* level.c: a window of few texels, if the triangle has few; else the level's. */
void soft_set_window(struct draw *draw);

#endif
