/*
 * Measures how far two models with the same vertices are apart on the screen.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_MEASURE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_MEASURE_H

#include "app/compare/measure/screen_view.h"

struct optimize_measure_view {
	int width, height; /* pixels */
	/* The part of a clip's moments that is measured, at most 1: all. */
	double share;
	/* That of the models' instances; set by optimize_measure_unit(). */
	float unit_scale;
};

/*
 * Plays a clip of both models, or poses them at rest if clip is -1, in the view
 * in which `limber play` frames the clip. *peak_px is the largest distance of a
 * vertex, as exact as in candidate_error.h; 0 without vertices. *box is what
 * the view frames: the wanted clip is posed for it only if it is empty. Returns
 * 0, or -errno after logging an error: -EINVAL if the files of the models have
 * other vertices.
 */
int optimize_measure(const struct model *wanted, const struct model *found,
	int clip, struct optimize_measure_view view, struct bounds *box,
	const struct log *log, float *peak_px);

/*
 * Finds view->unit_scale, and how many pixels a unit of world space covers at
 * the point of the first clip that is closest to the eye; without clips, of the
 * rest pose. It is 1 without vertices. *box is what the view frames, for
 * optimize_measure() of that clip. Returns 0, or -errno after logging an error.
 */
int optimize_measure_unit(const struct model *model,
	struct optimize_measure_view *view, const struct log *log,
	struct bounds *box, float *px_per_unit);

/*
 * Returns the part of the moments at which a search measures all clips of a
 * model: 1, unless they are long or many. What it finds has to be measured at
 * all moments then.
 */
double optimize_measure_share(const struct model *model);

#endif
