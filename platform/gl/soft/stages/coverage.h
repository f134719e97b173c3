/*
 * How much of a pixel a smooth point or line covers, which its fragment's alpha
 * is multiplied with (GL ES 1.1 sections 3.3.1, 3.4.2 and 3.9): by the distance
 * of the pixel's centre from the edge, over a pixel.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_COVERAGE_H
#define PLATFORM_GL_SOFT_STAGES_COVERAGE_H

#include <stdbool.h>
#include <stdint.h>

/* A disk, or a rectangle: window coordinates in sixteenths, sizes in 256ths. */
struct soft_coverage {
	bool used;
	int32_t x, y;         /* the centre */
	int32_t radius_q8;    /* of a disk, else 0 */
	int32_t u_q14, v_q14; /* a line's direction */
	int32_t half_length_q8, half_width_q8;
};

struct draw;
struct soft_row;

/*
 * Multiplies the alpha of a run's colours. Cuts pixels that are not covered off
 * at both ends of the run; returns how many at the left one. None may be left.
 */
uint32_t soft_cover(
	const struct draw *draw, struct soft_row *run, uint32_t *color);

#endif
