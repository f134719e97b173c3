/*
 * How far apart two points are on the screen.
 */
#ifndef APP_COMPARE_SCREEN_ERROR_H
#define APP_COMPARE_SCREEN_ERROR_H

#include "app/compare/reference.h"

/* The viewer's look at the whole clip, as plain projection. */
struct screen {
	int width, height;
	mat4 view;      /* model units to eye, the eye looks along -Z */
	float focal_px; /* pixels a unit at distance 1 */
};

/* Framed as `limber play` frames the clip at its start. */
struct screen screen_frame(
	const struct reference *reference, int width, int height);

/* Pixels between two world points, as the screen shows them. */
float screen_distance_px(
	const struct screen *screen, const float a[3], const float b[3]);

#endif
