/*
 * The coverage of pixels by smooth points and lines, which multiplies fragments'
 * alpha (GL ES 1.1 sections 3.3.1, 3.4.2 and 3.9). It is linear in the distance of
 * the pixel's centre from the edge, from 1/2 pixel outside to 1/2 inside.
 */
#ifndef PLATFORM_GL_SOFT_STAGES_COVERAGE_H
#define PLATFORM_GL_SOFT_STAGES_COVERAGE_H

#include <stdbool.h>
#include <stdint.h>

/* A disk or a rectangle; x and y are window coordinates, in 1/16 pixels. */
struct soft_coverage {
	bool used;
	int32_t x, y;         /* the centre */
	int32_t radius_q8;    /* of a disk, in 1/256 pixels; else 0 */
	int32_t u_q14, v_q14; /* unit vector along a line */
	int32_t half_length_q8, half_width_q8;
};

struct draw;
struct soft_row;

/*
 * Multiplies a run's alpha by the coverage. Removes uncovered pixels from both
 * ends of the run, maybe all; returns how many it removed from the left end.
 */
uint32_t soft_cover(
	const struct draw *draw, struct soft_row *run, uint32_t *color);

#endif
