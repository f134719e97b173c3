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
	struct bounds box; /* around the clip, in the model's units */
};

/*
 * The view in which `limber play` frames the whole clip at its start. It poses
 * the reference at every moment of the grid.
 */
struct screen_view screen_view_create(struct reference *reference,
	const struct time_grid *grid, int width, int height);

/* Projects a point of world space: pixels right of and above the middle. */
void screen_view_project(
	const struct screen_view *screen, const float point[3], float out[2]);

/* The distance in pixels between two points of world space. */
float screen_view_distance_px(
	const struct screen_view *screen, const float a[3], const float b[3]);

#endif
