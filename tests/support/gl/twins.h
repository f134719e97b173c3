/*
 * Two equal sets of small buffers: a function in assembly draws into one and
 * its twin in C into the other, after which both must be the same.
 */
#ifndef TESTS_SUPPORT_GL_TWINS_H
#define TESTS_SUPPORT_GL_TWINS_H

#include <stdint.h>

enum {
	TWINS_SIDE = 64,
	TWINS_PIXELS = TWINS_SIDE * TWINS_SIDE,
	TWINS_ROW = 20,  /* the first row to draw */
	TWINS_ROWS = 20, /* the most rows to draw; the rest stay unchanged */
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

/* Makes twins with the same noise in both, and stencils of 0. */
struct twins *twins_make(uint32_t *seed);

/*
 * Gets the address of the depth at row TWINS_ROW, column 0, and the distance
 * from behind a depth to its pixel, as struct band has them.
 */
void twins_place(const struct twins *twins, int which, uintptr_t *depth,
	uintptr_t *pixels);

/* Makes two random edges in 16.16 that begin and end in columns low..high. */
void twins_edges(
	uint32_t *seed, int low, int high, uint32_t edge[2], uint32_t step[2]);

/* Fails the test unless both sets are the same. Frees the twins. */
void twins_check(struct twins *twins);

#endif
