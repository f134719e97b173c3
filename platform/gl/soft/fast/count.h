/*
 * Counting in the stencil, with nothing drawn: what the hulls of volumes do. Depth
 * is tested LESS; where that fails, or where it passes, the stencil goes up or
 * down by one and stays between 0 and 255.
 */
#ifndef PLATFORM_GL_SOFT_FAST_COUNT_H
#define PLATFORM_GL_SOFT_FAST_COUNT_H

#include <stdbool.h>
#include <stdint.h>

enum {
	COUNT_DOWN = 1,
	COUNT_PASSED = 2, /* else what failed */
};

/* Rows between two edges. */
struct count_band {
	uint16_t *depth; /* of column 0 */
	uint8_t *stencil;
	uint32_t edge[2]; /* see BAND_LEFT */
	uint32_t z;       /* at column 0, 10 bits of fraction */
	uint32_t z_right; /* a pixel further */
	int32_t rows;
	uint32_t edge_step[2];
	uint32_t z_down;
	int32_t width;    /* pixels from a row to the next */
	int32_t from, to; /* columns that may be counted */
	uint8_t kind;     /* of the two below, added up */
};

/* Counts in all rows, and leaves the band at the row after them. */
void soft_count_band(struct count_band *band);

#endif
