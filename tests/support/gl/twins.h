/* Two sets of small buffers, to hold what is in assembly against the C. */
#ifndef TESTS_SUPPORT_GL_TWINS_H
#define TESTS_SUPPORT_GL_TWINS_H

#include <stdint.h>

enum {
	TWINS_SIDE = 64,
	TWINS_PIXELS = TWINS_SIDE * TWINS_SIDE,
	TWINS_ROW = 20,  /* the one to begin at */
	TWINS_ROWS = 20, /* at most, so that as many are free behind */
};

struct twins {
	uint16_t pixel[2][TWINS_PIXELS], depth[2][TWINS_PIXELS];
	uint8_t stencil[2][TWINS_PIXELS];
};

/*
 * Ends the test as skipped where the driver is built without assembly: the
 * function and its twin are the same there.
 */
void twins_need_assembly(void);

/* Noise, the same in both, and stencils of 0. */
struct twins *twins_make(uint32_t *seed);

/* Where a band of TWINS_ROW begins, as struct band has it. */
void twins_place(const struct twins *twins, int which, uintptr_t *depth,
	uintptr_t *pixels);

/* Edges in 16.16 that begin and end in columns low to high. */
void twins_edges(
	uint32_t *seed, int low, int high, uint32_t edge[2], uint32_t step[2]);

/* Fails unless both are the same; frees them. */
void twins_check(struct twins *twins);

#endif
