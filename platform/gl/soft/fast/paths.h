/* Which way triangles of a draw call go: one of fast/, or the template's. */
#ifndef PLATFORM_GL_SOFT_FAST_PATHS_H
#define PLATFORM_GL_SOFT_FAST_PATHS_H

#include "platform/gl/soft/vertex/draw.h"

struct soft_path {
	/* It takes a key of which the bits of mask are these. */
	uint32_t mask, bits;
	fill_function fill;
	void (*begin)(struct draw *draw); /* once a draw call, or NULL */
	bool one_color; /* no vertex is shaded: all of a call has one colour */
	bool divides;   /* never bends: levels of detail change by row */
	bool rectangles; /* soft_fill_rectangle() may draw two triangles as one */
};

/* Finds draw->key, and the first path that takes it. */
const struct soft_path *soft_choose_path(struct draw *draw);

#endif
