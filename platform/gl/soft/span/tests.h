/* Depth and stencil tests of fragments that span functions do not make. */
#ifndef PLATFORM_GL_SOFT_SPAN_TESTS_H
#define PLATFORM_GL_SOFT_SPAN_TESTS_H

#include "platform/gl/soft/span/run.h"

/* GL's comparisons: bits 0 to 2 of the enumerant let less, equal, greater pass. */
static inline bool soft_compares(GLenum function, uint32_t a, uint32_t b)
{
	return function >> (a < b ? 0 : a == b ? 1 : 2) & 1;
}

/* How many fragments from the first one on have the same result. */
struct soft_stretch {
	uint32_t count;
	bool passes;
};

/*
 * Makes the stencil test of a row's first pixels, at most count, as far as its
 * result is the same, and writes the stencil, but no depths. Makes the depth
 * test, too, if compared is set, or where the stencil depends on it; else
 * fragments may fail it later.
 */
struct soft_stretch soft_test(const struct soft *soft,
	const struct soft_row *row, uint32_t count, uint32_t z_right,
	bool compared);

/* Writes the depths of runs, where they pass the depth test. */
void soft_write_depths(GLenum function, const struct soft_run *run);

#endif
