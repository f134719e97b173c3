/*
 * How far the pictures of two models with the same vertices are apart.
 */
#ifndef APP_COMPARE_OPTIMIZE_OPTIMIZE_MEASURE_H
#define APP_COMPARE_OPTIMIZE_OPTIMIZE_MEASURE_H

#include "app/compare/measure/screen_view.h"

struct optimize_view_size {
	int width, height; /* pixels */
};

/*
 * Plays a clip of both, or shows the rest pose if clip is -1, in the view in
 * which limber play frames the clip. *peak_px is as exact as in
 * candidate_error.h. Returns 0, or -errno after logging an error.
 */
int optimize_measure(const struct model *wanted, const struct model *found,
	int clip, struct optimize_view_size size, const struct log *log,
	float *peak_px);

/*
 * The pixels that a unit of the world has where the clip, or the rest pose,
 * comes closest to the eye. Returns 0, or -errno after logging an error.
 */
int optimize_measure_unit(const struct model *model, int clip,
	struct optimize_view_size size, const struct log *log,
	float *px_per_unit);

#endif
