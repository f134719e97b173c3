/*
 * Measures how far a candidate's pictures are from the reference's.
 *
 * The clip is sampled at the moments of its time grid and between them. Then
 * the intervals are divided in which the error may be larger than the largest
 * found, judged by how much it bends there, until the peak is within 5% or 0.05
 * pixels of the true one, whichever is more.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_ERROR_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_ERROR_H

#include "app/compare/candidate/candidate.h"

struct candidate_error {
	float peak_px; /* the largest distance of a vertex at any time */
	float peak_s;  /* when that is */
	float mean_px; /* over all vertices at evenly spaced moments */

	/*
	 * The next three are found at up to 500 moments of the grid.
	 *
	 * The distance for vertices whose normals face the eye sideways:
	 * how far the outline moves across itself.
	 */
	float outline_px;
	/* The largest angle between a vertex's normals. */
	float normal_deg;
	/*
	 * The largest difference in the key light's brightness of a vertex, in
	 * 63rds: the steps of green in RGB565.
	 */
	float shade_steps;
	int samples; /* moments that were compared */
};

/* The first moments at which an error exceeds a bound. */
struct candidate_excess {
	float bound_px;
	int count;
	float time_s[512];
};

/*
 * Compares over the whole clip. The grid is that of the reference's clip.
 * excess->bound_px is given; NULL is fine. Returns 0 or -ENOMEM.
 */
int candidate_error_measure(struct candidate *candidate,
	const struct screen_view *screen, const struct time_grid *grid,
	struct candidate_excess *excess, struct candidate_error *out);

#endif
