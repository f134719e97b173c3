/*
 * Measures how far a candidate's pictures are from the reference's.
 *
 * The clip is sampled at the moments of its time grid and between them, except
 * in gaps of the grid. Then each interval in which the error may exceed the
 * largest one found is halved repeatedly; the second difference of three
 * samples tells by how much it may. It ends when the peak is within 5% or 0.05
 * pixels of the true one, whichever is more.
 */
#ifndef APP_COMPARE_CANDIDATE_CANDIDATE_ERROR_H
#define APP_COMPARE_CANDIDATE_CANDIDATE_ERROR_H

#include "app/compare/candidate/candidate.h"

struct candidate_error {
	float peak_px; /* the largest distance of a vertex at any time */
	float peak_s;  /* the time of peak_px, in seconds of the clip */
	float mean_px; /* over all vertices, at the moments below */

	/*
	 * The mean and the next three are taken at some moments of the grid.
	 *
	 * The distance, along the normal's direction on the screen, of vertices
	 * whose normals are nearly perpendicular to the view: how far the
	 * outline moves.
	 */
	float outline_px;
	/* The largest angle between a vertex's normal and the reference's. */
	float normal_deg;
	/*
	 * The largest difference in the key light's brightness of a vertex, in
	 * 63rds: the steps of green in RGB565.
	 */
	float shade_steps;
	int samples; /* moments that were compared */
};

/* The moments, up to 512, at which the error first exceeds a bound. */
struct candidate_excess {
	float bound_px;
	int count;
	float time_s[512];
};

/*
 * Compares over the whole clip. grid belongs to the reference's clip; normals
 * are compared at up to normal_moments of its moments, 1 or more. The
 * caller sets excess->bound_px; excess may be NULL. Returns 0 or -ENOMEM.
 */
int candidate_error_measure(struct candidate *candidate,
	const struct screen_view *screen, const struct time_grid *grid,
	int normal_moments, struct candidate_excess *excess,
	struct candidate_error *out);

/*
 * Finds only the peak, in as many threads as there are candidates. All show the
 * same, each compared with a reference of its own. Their number does not change
 * what is found. Returns 0 or -ENOMEM.
 */
int candidate_error_find_peak(struct candidate *candidates, int count,
	const struct screen_view *screen, const struct time_grid *grid,
	float *peak_px);

#endif
