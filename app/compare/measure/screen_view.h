/*
 * Projects a clip onto the screen, to measure errors in pixels.
 */
#ifndef APP_COMPARE_MEASURE_SCREEN_VIEW_H
#define APP_COMPARE_MEASURE_SCREEN_VIEW_H

#include "app/compare/measure/reference.h"
#include "app/compare/measure/time_grid.h"
#include "app/scene/instance/bounds.h"

/* The view of a camera as plain numbers. */
struct screen_view {
	int width, height; /* pixels */
	mat4 view;      /* model units to eye space; the eye looks along -Z */
	float focal_px; /* pixels that one unit at distance 1 covers */
	float unit;     /* scene units per unit of the model */
	struct bounds box; /* that is framed, in the model's units */
};

/*
 * The view that frames the whole clip. It poses the reference at every moment
 * of the grid.
 */
struct screen_view screen_view_create(struct reference *reference,
	const struct time_grid *grid, int width, int height);

/*
 * Moves the view so that it frames a box in the model's units, as `limber play`
 * without labels frames all clips and the rest pose.
 */
void screen_view_frame(struct screen_view *screen, const struct bounds *box);

/* Projects a point of world space: pixels right of and above the middle. */
void screen_view_project(
	const struct screen_view *screen, const float point[3], float out[2]);

/* The distance in pixels between two points of world space. */
float screen_view_distance_px(
	const struct screen_view *screen, const float a[3], const float b[3]);

#endif
