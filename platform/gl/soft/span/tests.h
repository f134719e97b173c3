/* Depth and stencil tests of fragments that span functions do not make. */
#ifndef PLATFORM_GL_SOFT_SPAN_TESTS_H
#define PLATFORM_GL_SOFT_SPAN_TESTS_H

#include "platform/gl/soft/soft.h"

/* GL's comparisons: bits 0 to 2 of the enumerant let less, equal, greater pass. */
static inline bool soft_compares(GLenum function, uint32_t a, uint32_t b)
{
	return function >> (a < b ? 0 : a == b ? 1 : 2) & 1;
}

/* Fragments side by side in a row, and their depths. */
struct soft_tested {
	size_t place; /* of the first one, in the depth and stencil buffers */
	uint32_t count;
	uint32_t z, z_right; /* 16.16 */
};

/*
 * Tests fragments and writes the stencil, but no depths. passes[] becomes 65535
 * for fragments that pass, else 0. False where none passes.
 */
bool soft_test(
	struct soft *soft, const struct soft_tested *tested, uint16_t *passes);

#endif
